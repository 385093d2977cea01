// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/first_grid_records.hpp"

namespace tetproof::reference {
namespace {

// The place of the cut on an edge between -1 and +1 (readings D6, D7).
Eigen::Vector3d cut_point(const Lattice& lattice, const Indicators& indicators, Edge e) {
  const std::int64_t own = indicators.cuts.find(e);
  if (own >= 0) return indicators.cuts.points[own];
  const Vertex low = lattice.low(e), high = lattice.high(e);
  const Vertex exterior = indicators.sign[low] < 0 ? low : high;
  return lattice.point(indicators.initial[exterior] == 0 ? exterior : low + high - exterior);
}

}  // namespace

FirstSteps first_steps(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
                       const std::vector<Vertex>& mended, const Grid& grid) {
  FirstSteps steps{.cells = lattice.cells,
                   .planes = lattice.planes,
                   .initial = {indicators.initial.begin(), indicators.initial.end()},
                   .after = {indicators.sign.begin(), indicators.sign.end()},
                   .mended = {mended.begin(), mended.end()}};
  for (std::size_t s = 0; s < settled.vertices.size(); ++s)
    steps.settled[settled.vertices[s]] = settled.points[s];
  for (Vertex low = 0; low < lattice.vertices(); ++low) {
    const auto [i, j, k] = lattice.position(low);
    const int there =
        (i < lattice.cells[0] ? 1 : 0) | (j < lattice.cells[1] ? 2 : 0) | (k < lattice.cells[2] ? 4 : 0);
    for (int direction = 1; direction < 8; ++direction) {
      if ((direction & there) != direction) continue;
      const Edge e = Edge{low} * 8 + direction;
      if (indicators.sign[low] * indicators.sign[lattice.high(e)] < 0)
        steps.cuts[{low, lattice.high(e)}] = cut_point(lattice, indicators, e);
    }
  }
  for (const std::uint8_t row : grid.lattice_rows)
    steps.rows.emplace_back(row == Grid::case_5_dropped ? "5-" : tables::table2[row].name);
  return steps;
}

}  // namespace tetproof::reference
