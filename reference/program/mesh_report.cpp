// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/program/mesh_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/bytes/words.hpp"

namespace tetproof::reference {
namespace {

using Json = nlohmann::ordered_json;

std::string orientation_of(const verify::SurfaceReport& surface) {
  const auto outward = std::count_if(surface.components.begin(), surface.components.end(),
                                     [](const verify::SurfaceComponent& c) { return c.outward; });
  if (outward == static_cast<std::ptrdiff_t>(surface.components.size())) return "outward";
  return outward == 0 ? "inward" : "mixed";
}

// Counts how often each row of a table was used.
template <class Table, class Counts>
Json counts_by_row(const Table& table, const Counts& counts) {
  Json json;
  for (std::size_t r = 0; r < counts.size(); ++r) json[std::string(table[r].name)] = counts[r];
  return json;
}

Json adaptation_json(const Adaptation& a) {
  Json json{{"mean_volume", a.mean_volume},
            {"v0", a.law.v0},
            {"v1", a.law.v1},
            {"d1", a.law.d1},
            {"p", a.law.p},
            {"e_avg_first", a.e_avg_first},
            {"e_avg_last", a.e_avg_last},
            {"insertions", a.insertions},
            {"rows", counts_by_row(tables::table4, a.rows)},
            {"refused", a.refused},
            {"left", a.left},
            {"flips", a.flips},
            {"stopped", name_of(a.stopped)},
            {"smallest_solid_angle", a.smallest_solid_angle},
            {"smallest_d_over_a", a.smallest_aspect_ratio},
            {"smallest_d_over_sqrt_a", a.smallest_d_over_sqrt_a}};
  if (a.with_curvature) {
    json["kappa_min"] = a.kappa_min;
    json["kappa_max"] = a.kappa_max;
    json["kappa_outlier_ratio"] = a.kappa_outlier_ratio;
  }
  return json;
}

std::string adaptation_text(const Adaptation& a) {
  const std::string_view why = a.stopped == Stop::no_gain    ? "no split lowers E_avg"
                               : a.stopped == Stop::dilution ? "the chosen tetrahedron is not too large (D17)"
                               : a.stopped == Stop::stalled
                                   ? "E_avg has reached no new minimum for a long time (D23)"
                               : a.stopped == Stop::points ? "the requested number of points is reached"
                               : a.stopped == Stop::e_avg  ? "the requested E_avg is reached"
                                                           : "the trace's next decision is not admissible";
  std::string text = fmt::format(
      "adapted: {} inserted, {}; E_avg {:.4g} -> {:.4g} of the first grid's mean volume\n"
      "  stopped: {}: {}\n",
      io::counted(a.insertions, "points"), io::counted(a.flips, "flips"), a.e_avg_first / a.mean_volume,
      a.e_avg_last / a.mean_volume, name_of(a.stopped), why);
  text += fmt::format("  smallest D/A {:.4g} per length, D/sqrt(A) {:.4g}\n", a.smallest_aspect_ratio,
                      a.smallest_d_over_sqrt_a);
  if (a.refused)
    text += fmt::format("  {} refused: rounding would have flattened a piece (D18)\n",
                        io::counted(a.refused, "splits"));
  if (a.left)
    text += fmt::format(
        "  {} new points not moved to the parametric surface, because a tetrahedron would turn over or the "
        "boundary cross itself (D12)\n",
        a.left);
  if (a.kappa_outlier_ratio > 10)
    text += fmt::format(
        "  the largest curvature is {} the 99th percentile{}: a few outliers decide eq. (3.6) (D15)\n",
        std::isinf(a.kappa_outlier_ratio) ? "above" : fmt::format("{:.0f} times", a.kappa_outlier_ratio),
        std::isinf(a.kappa_outlier_ratio) ? ", which is 0" : "");
  return text;
}

}  // namespace

std::string generation_text(const Generation& made) {
  const auto [nx, ny, nz] = made.lattice.cells;
  std::string text = fmt::format("grid: {} tetrahedra, {} points, from a lattice of {} x {} x {} cells\n",
                                 made.grid.mesh.tets.size(), made.grid.mesh.points.size(), nx, ny, nz);
  if (made.moved_to_surface)
    text += fmt::format("  {} lattice vertices moved to the surface\n", made.moved_to_surface);
  if (made.mended)
    text += fmt::format("  {} more moved there because rounding had inverted a tetrahedron\n", made.mended);
  if (made.dropped_intersections)
    text += fmt::format(
        "  the surface has features thinner than the lattice: {} intersections on lattice edges dropped "
        "(Table 3)\n",
        made.dropped_intersections);
  if (made.mapped || made.not_mapped)
    text += fmt::format("  {} points moved to the parametric surface, {} had to stay where they were (D12)\n",
                        made.mapped, made.not_mapped);
  if (made.not_positive)
    text += fmt::format("  {} tetrahedra are not positive after rounding: the grid is not adapted\n",
                        made.not_positive);
  if (made.adaptation) {
    text += adaptation_text(*made.adaptation);
    text +=
        fmt::format("grid: {} tetrahedra, {} points\n", made.mesh().tets.size(), made.mesh().points.size());
  }
  if (made.follow) {
    for (const std::string& what : made.follow->not_checked)
      text += fmt::format("not checked: the trace has no records of its {}\n", what);
    text +=
        made.follow->admissible
            ? fmt::format("every decision of the trace is admissible, {} of them by a tie\n",
                          made.follow->ties)
            : fmt::format("not admissible, line {} of the trace: {}\n", made.follow->line, made.follow->what);
  }
  return text;
}

void add_generation(Json& json, const std::string& surface_name, const verify::SurfaceReport& surface,
                    const Generation& made) {
  json["generation"] = {
      {"surface",
       {{"file", surface_name},
        {"triangles", surface.triangles},
        {"components", surface.components.size()},
        {"orientation", orientation_of(surface)}}},
      {"lattice",
       {{"cells", made.lattice.cells}, {"points", made.lattice.vertices()}, {"tets", made.lattice.tets()}}},
      {"first_grid", {{"points", made.grid.mesh.points.size()}, {"tets", made.grid.mesh.tets.size()}}},
      {"cases", counts_by_row(tables::table2, made.grid.rows)},
      {"table3", counts_by_row(tables::table3, made.table3)},
      {"dropped_intersections", made.dropped_intersections},
      {"moved_to_surface", made.moved_to_surface},
      {"mended", made.mended},
      {"collapsed", made.grid.collapsed},
      {"mapped", made.mapped},
      {"not_mapped", made.not_mapped},
      {"not_positive", made.not_positive}};
  if (made.adaptation) json["adaptation"] = adaptation_json(*made.adaptation);
  if (made.follow)
    json["follow"] = {{"admissible", made.follow->admissible},
                      {"line", made.follow->line},
                      {"what", made.follow->what},
                      {"ties", made.follow->ties},
                      {"not_checked", made.follow->not_checked}};
}

}  // namespace tetproof::reference
