// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iii): every lattice vertex is outside (-1), on the surface (0) or inside (+1), and every edge between
// -1 and +1 has its cut.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/engine/first_grid/intersections.hpp"
#include "reference/tables.hpp"

namespace tetproof::reference {

enum class Region { inside, outside };

/// Lattice vertices that were taken to the surface for good (reading D4), ascending, each with its new place.
struct SurfaceVertices {
  std::vector<Vertex> vertices;
  std::vector<Eigen::Vector3d> points;

  bool contains(Vertex v) const;
  /// Adds vertices (ascending, none of them held yet).
  void add(const std::vector<NearVertex>& more);
};

/// Where lattice edges between -1 and +1 are cut: points of their own, by lexicographic order of their edges
/// (reading D3). An edge between -1 and +1 without one is cut at its end that was 0 before Table 3 (reading
/// D7).
struct Cuts {
  std::vector<std::uint8_t>
      directions;  ///< for each lattice vertex a bit for each direction, of the edges it is the low end of
  std::vector<std::uint32_t> first;  ///< for each lattice vertex the number of its first cut
  std::vector<Eigen::Vector3d> points;
  std::vector<Edge> edges;  ///< of each cut

  /// The number of the edge's cut, or -1.
  std::int64_t find(Edge e) const {
    const std::uint8_t bits = directions[e >> 3];
    const unsigned direction = e & 7;
    if (!(bits >> direction & 1)) return -1;
    return first[e >> 3] + __builtin_popcount(bits & ((1u << direction) - 1));
  }
};

struct Indicators {
  std::vector<std::int8_t> initial;  ///< of each lattice vertex, before Table 3
  std::vector<std::int8_t> sign;     ///< after it
  Cuts cuts;
  std::array<std::int64_t, tables::table3.size()> table3{};  ///< how often each row was applied
  std::int64_t dropped =
      0;  ///< intersection points that Table 3 gave up: features thinner than the lattice (reading D11)
};

/// The initial indicators: parity for the vertices off the surface, 0 on it; signs flipped for the outside
/// (reading D5).
std::vector<std::int8_t> initial_indicators(std::vector<std::int8_t> inside,
                                            const std::vector<Vertex>& on_surface,
                                            const SurfaceVertices& settled, Region region);

/// Table 3 and the choice of cuts. Vertices in `settled` keep their 0, make and take no request, and their
/// edges have no cuts (reading D4).
Indicators characterize(const Lattice& lattice, std::vector<std::int8_t> initial,
                        const std::vector<EdgeIntersections>& intersections, const SurfaceVertices& settled);

}  // namespace tetproof::reference
