// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iii): the indicator of every lattice vertex, which is -1 outside, 0 on the surface and +1 inside, and
// the cut on every edge between -1 and +1.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/engine/first_grid/intersections.hpp"
#include "reference/options.hpp"
#include "reference/tables.hpp"

namespace tetproof::reference {

/// Lattice vertices that were moved to the surface and stay 0 (reading D4), ascending, each with its new
/// place.
struct SurfaceVertices {
  std::vector<Vertex> vertices;
  std::vector<Eigen::Vector3d> points;

  bool contains(Vertex v) const;
  /// Adds vertices: ascending, and none that is already there.
  void add(const std::vector<NearVertex>& more);
};

/// The cuts of lattice edges between -1 and +1 that are new points, in lexicographic order of their edges
/// (reading D3). An edge between -1 and +1 that has no such point is cut at its end that was 0 before Table 3
/// (reading D7).
struct Cuts {
  /// For each lattice vertex, a bit for each of its edges (of which it is the lower-numbered end) that has a
  /// cut.
  std::vector<std::uint8_t> directions;
  std::vector<std::uint32_t> first;  ///< for each lattice vertex, the number of the first cut on these edges
  std::vector<Eigen::Vector3d> points;
  std::vector<Edge> edges;  ///< of each cut

  /// The number of the cut on an edge, or -1.
  std::int64_t find(Edge e) const {
    const std::uint8_t bits = directions[e >> 3];
    const unsigned direction = e & 7;
    if (!(bits >> direction & 1)) return -1;
    return first[e >> 3] + __builtin_popcount(bits & ((1u << direction) - 1));
  }
};

struct Indicators {
  std::vector<std::int8_t> initial;  ///< the indicator of each lattice vertex before Table 3
  std::vector<std::int8_t> sign;     ///< the same after Table 3
  Cuts cuts;
  std::array<std::int64_t, tables::table3.size()> table3{};  ///< how often each row was applied
  /// Intersection points that Table 3 ignored: features thinner than the lattice (reading D11).
  std::int64_t dropped = 0;
};

/// The initial indicators: those of `inside`, with 0 for the vertices in `on_surface` and in `settled`. For
/// the region outside the signs are exchanged (reading D5).
std::vector<std::int8_t> initial_indicators(std::vector<std::int8_t> inside,
                                            const std::vector<Vertex>& on_surface,
                                            const SurfaceVertices& settled, Region region);

/// Applies Table 3 and chooses the cuts. Vertices in `settled` keep their 0: they neither make nor receive a
/// request, and their edges have no cuts (reading D4).
Indicators characterize(const Lattice& lattice, std::vector<std::int8_t> initial,
                        const std::vector<EdgeIntersections>& intersections, const SurfaceVertices& settled);

}  // namespace tetproof::reference
