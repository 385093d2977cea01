// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/mend.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/engine/first_grid/exact.hpp"

namespace tetproof::reference {

std::vector<Index> not_positive(const TetMesh& mesh) {
  constexpr std::size_t tets_a_task = 1 << 14;
  std::vector<std::vector<Index>> slices((mesh.tets.size() + tets_a_task - 1) / tets_a_task);
  tbb::parallel_for(std::size_t{0}, slices.size(), [&](std::size_t s) {
    for (std::size_t t = s * tets_a_task; t < std::min(mesh.tets.size(), (s + 1) * tets_a_task); ++t) {
      const auto& [a, b, c, d] = mesh.tets[t];
      if (orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) <= 0)
        slices[s].push_back(static_cast<Index>(t));
    }
  });
  std::vector<Index> all;
  for (const auto& slice : slices) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

std::vector<NearVertex> vertices_to_mend(const Lattice& lattice, const TriangleSurface& surface,
                                         const Indicators& indicators, const SurfaceVertices& settled,
                                         const Grid& grid, const std::vector<Index>& tets) {
  std::map<Vertex, double> chosen;  // the vertex, and the length from it to its cut
  double longest = 0;
  for (const Index t : tets) {
    const std::uint32_t number = grid.lattice_tet[t];
    const std::int64_t cell = number / 6;
    const auto nx = lattice.cells[0], ny = lattice.cells[1];
    const Vertex base = lattice.vertex(static_cast<int>(cell % nx), static_cast<int>(cell / nx % ny),
                                       static_cast<int>(cell / nx / ny));
    const auto& corners = kuhn_tets[number % 6];
    Vertex nearest = -1;
    double shortest = HUGE_VAL;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) {
        const Vertex low = base + lattice.offset(corners[a]), high = base + lattice.offset(corners[b]);
        const std::int64_t cut = indicators.cuts.find(Edge{low} * 8 + (corners[a] ^ corners[b]));
        if (cut < 0) continue;
        for (const Vertex end : {low, high}) {
          const double length = (indicators.cuts.points[cut] - lattice.point(end)).norm();
          if (length < shortest) std::tie(shortest, nearest) = std::pair(length, end);
        }
      }
    if (nearest < 0 || settled.contains(nearest)) continue;
    chosen.try_emplace(nearest, shortest);
    longest = std::max(longest, shortest);
  }
  if (chosen.empty()) return {};
  // A vertex is at most the length to its cut away from the surface. Rounding may have put the cut on the
  // vertex itself, so the radius must not be 0.
  const double radius = std::max(2 * longest, 1e-6 * lattice.shortest_edge);
  return find_near_vertices(lattice, surface, radius, [&](Vertex v) { return chosen.contains(v); });
}

}  // namespace tetproof::reference
