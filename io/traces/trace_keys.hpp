// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the keys of each kind of record once, for the writer and the reader of traces. Not installed.
#pragma once

#include <array>
#include <type_traits>
#include <variant>

#include "io/trace.hpp"

namespace tetproof::trace {

/// Calls `field` for each key of a record, in the order in which they are written. `field` reads or writes
/// the key.
template <class R, class Fields>
void describe(R& r, Fields& field) {
  using T = std::remove_const_t<R>;
  if constexpr (std::is_same_v<T, Settings>) {
    field.with_defaults();
    field("program", r.program), field("surface", r.surface), field("region", r.region);
    field("box_scale", r.box_scale), field("on_surface", r.on_surface), field("diagonals", r.diagonals);
    field("literal", r.literal), field("p", r.p), field("curvature", r.curvature);
    field("parametric", r.parametric), field("improve", r.improve), field("improve_below", r.improve_below);
    field("points", r.points), field("past_dilution", r.past_dilution);
  } else if constexpr (std::is_same_v<T, Lattice>) {
    field("box", r.box), field("cells", r.cells);
  } else if constexpr (std::is_same_v<T, Indicators>) {
    field("j", r.j), field("k", r.k), field("initial", r.initial), field("after", r.after);
  } else if constexpr (std::is_same_v<T, Moved>) {
    field("vertex", r.vertex), field("point", r.point), field.with_defaults(), field("mended", r.mended);
  } else if constexpr (std::is_same_v<T, Cut>) {
    field("edge", r.edge), field("point", r.point);
  } else if constexpr (std::is_same_v<T, Rows>) {
    field("cell", r.cell), field("rows", r.rows);
  } else if constexpr (std::is_same_v<T, Mapped>) {
    field("from", r.from), field("to", r.to);
  } else if constexpr (std::is_same_v<T, FirstGrid>) {
    field("points", r.points), field("tets", r.tets), field("mean_volume", r.mean_volume);
    field("v0", r.v0), field("v1", r.v1), field("d1", r.d1);
    field("kappa_min", r.kappa_min), field("kappa_max", r.kappa_max), field("e_avg", r.e_avg);
    field("e_avg_goal", r.e_avg_goal);
  } else if constexpr (std::is_same_v<T, Weight>) {
    field("tet", r.tet), field("d", r.d), field("kappa", r.kappa), field("omega", r.omega);
    field("volume", r.volume), field("desired", r.desired), field("error", r.error);
  } else if constexpr (std::is_same_v<T, Insertion>) {
    field("n", r.n), field("tet", r.tet), field("row", r.row), field("replaced", r.replaced);
    field("point", r.point), field("e_avg", r.e_avg);
  } else if constexpr (std::is_same_v<T, Flip>) {
    field.choice("kind", r.two_to_three, "2-3", "3-2"), field("face", r.face), field("edge", r.edge);
    field.pair("quality", r.quality_before, r.quality_after), field("e_avg", r.e_avg);
  } else {
    static_assert(std::is_same_v<T, End>);
    field("stopped", r.stopped), field("insertions", r.insertions), field("flips", r.flips);
    field("refused", r.refused), field("points", r.points), field("tets", r.tets), field("e_avg", r.e_avg);
  }
}

/// The format's names for the kinds of records, in the order of the variant.
inline constexpr std::array<const char*, std::variant_size_v<Record>> names{
    "settings", "lattice",    "indicators", "moved",     "cut",  "rows",
    "mapped",   "first_grid", "weight",     "insertion", "flip", "end"};

}  // namespace tetproof::trace
