// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the steps, the trace of section 2, and the mistakes' names.
#include "tests/second/second.hpp"

#include "tests/second/section2.hpp"
#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

trace::Settings recorded(const Settings& s, const std::string& surface_name) {
  return {.program = "tetproof-second",
          .surface = surface_name,
          .region = s.outside ? "outside" : "inside",
          .box_scale = s.box_scale,
          .on_surface = s.literal ? 0 : s.on_surface,
          .diagonals = s.shortest_diagonals ? "shortest" : "lowest",
          .literal = s.literal,
          .p = s.p,
          .curvature = s.curvature,
          .parametric = false,
          .improve = s.improve == Quality::none          ? "none"
                     : s.improve == Quality::solid_angle ? "solid-angle"
                                                         : "aspect-ratio",
          .improve_below = s.improve_below,
          .points = s.insertions < 0 ? "auto" : std::to_string(s.insertions),
          .past_dilution = s.past_dilution};
}

std::vector<trace::Record> section2_records(const Lattice& lattice, const Indicators& indicators,
                                            const Grid& grid, const std::set<int>& mended) {
  std::vector<trace::Record> records;
  records.push_back(trace::Lattice{.box = {lattice.low, lattice.high}, .cells = lattice.cells});
  for (int k = 0; k <= lattice.cells[2]; ++k)
    for (int j = 0; j <= lattice.cells[1]; ++j) {
      trace::Indicators row{.j = j, .k = k};
      for (int i = 0; i <= lattice.cells[0]; ++i) {
        row.initial += "-0+"[indicators.initial.at(lattice.number({i, j, k})) + 1];
        row.after += "-0+"[indicators.after.at(lattice.number({i, j, k})) + 1];
      }
      records.push_back(row);
    }
  for (const auto& [v, point] : indicators.settled)
    records.push_back(
        trace::Moved{.vertex = lattice.places.at(v), .point = point, .mended = mended.count(v) > 0});
  for (const auto& [edge, point] : indicators.cuts)
    records.push_back(
        trace::Cut{.edge = {lattice.places.at(edge.first), lattice.places.at(edge.second)}, .point = point});
  for (std::size_t t = 0; t < lattice.tets.size(); t += 6) {
    trace::Rows cell{.cell = lattice.places.at(lattice.tets[t][0])};
    for (int i = 0; i < 6; ++i) cell.rows[i] = grid.rows[t + i];
    records.push_back(cell);
  }
  return records;
}

}  // namespace

Run run(const TriangleSurface& surface, const Settings& settings, const std::string& surface_name) {
  const Lattice lattice = make_lattice(surface, settings);  // (i)
  std::set<int> mended;
  Indicators indicators;
  Grid grid;
  while (true) {
    indicators = characterize(surface, lattice, settings, mended);  // (ii), (iii)
    grid = extract(surface, lattice, indicators, settings);         // (iv)
    if (grid.to_mend.empty() || settings.literal) break;
    mended.insert(grid.to_mend.begin(), grid.to_mend.end());  // D4
  }
  Run result{.records = section2_records(lattice, indicators, grid, mended),
             .mended = static_cast<int>(mended.size())};
  result.records.insert(result.records.begin(), recorded(settings, surface_name));
  Adaptation adaptation(surface, grid, settings);
  result.first = adaptation.mesh();
  adaptation.run(result.records);  // (v), (vi)
  result.grid = adaptation.mesh();
  return result;
}

const std::vector<NamedMistake>& mistakes() {
  static const std::vector<NamedMistake> all{
      {Mistake::table2_row, "table2-row"},
      {Mistake::higher_diagonal, "higher-diagonal"},
      {Mistake::table3_interior_end, "table3-interior-end"},
      {Mistake::asked_for_both, "asked-for-both"},
      {Mistake::case5_kept, "case5-kept"},
      {Mistake::distance_to_triangles, "distance-to-triangles"},
      {Mistake::volumes_exchanged, "volumes-exchanged"},
      {Mistake::signed_error, "signed-error"},
      {Mistake::signed_curvature, "signed-curvature"},
      {Mistake::inverted_curvature_weight, "inverted-curvature-weight"},
      {Mistake::four_pieces, "four-pieces"},
      {Mistake::row_3b_as_3a, "row-3b-as-3a"},
      {Mistake::row_4c_on_face, "row-4c-on-face"},
      {Mistake::forgotten_surface_point, "forgotten-surface-point"},
      {Mistake::skewed_centroid, "skewed-centroid"},
      {Mistake::dilution_ignored, "dilution-ignored"},
      {Mistake::worst_flip, "worst-flip"},
      {Mistake::flips_everywhere, "flips-everywhere"},
      {Mistake::tetrahedron_without_neighbours, "no-neighbours"}};
  return all;
}

}  // namespace tetproof::second
