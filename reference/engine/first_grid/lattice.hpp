// SPDX-License-Identifier: GPL-3.0-or-later
// Step (i): the scaled bounding box, eq. (2.1), and its split into tetrahedra. Nothing of the surface but its
// box.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// Number of a lattice vertex: i + (nx+1)(j + (ny+1)k), reading D3.
using Vertex = Index;

/// A lattice edge runs from its lower-numbered vertex in one of seven directions: +x where bit 0 is set, +y
/// bit 1, +z bit 2. Its number, 8 * low + direction, orders edges lexicographically by (low, high), reading
/// D3.
using Edge = std::int64_t;

struct Lattice {
  std::array<int, 3> cells;  ///< nx, ny, nz
  std::array<std::vector<double>, 3>
      planes;            ///< the n+1 coordinates of the lattice planes along each axis [length]
  double shortest_edge;  ///< of a cell [length]

  Vertex vertices() const { return stride(2) * (cells[2] + 1); }
  std::int64_t tets() const { return 6LL * cells[0] * cells[1] * cells[2]; }
  Vertex stride(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? cells[0] + 1 : (cells[0] + 1) * (cells[1] + 1);
  }
  Vertex vertex(int i, int j, int k) const { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); }
  std::array<int, 3> position(Vertex v) const {
    const int row = v / (cells[0] + 1);
    return {v % (cells[0] + 1), row % (cells[1] + 1), row / (cells[1] + 1)};
  }
  Eigen::Vector3d point(int i, int j, int k) const { return {planes[0][i], planes[1][j], planes[2][k]}; }
  Eigen::Vector3d point(Vertex v) const {
    const auto [i, j, k] = position(v);
    return point(i, j, k);
  }
  /// How far the vertex number grows along a direction (or from a cell's first corner to its corner `bits`).
  Vertex offset(int bits) const {
    return (bits & 1 ? stride(0) : 0) + (bits & 2 ? stride(1) : 0) + (bits & 4 ? stride(2) : 0);
  }
  Vertex low(Edge e) const { return static_cast<Vertex>(e >> 3); }
  Vertex high(Edge e) const { return low(e) + offset(static_cast<int>(e & 7)); }
  /// The last plane at or below `x`, and plane 0 below all of them. The planes bound cells 0 .. n-1; n is the
  /// last plane itself.
  int cell_of(int axis, double x) const;
};

/// One coordinate of eq. (2.1), of which the sum over I, J, K is the product: (1-t) X_0 + t X_1.
double eq_2_1(double x0, double x1, double t);

/// The corners of the six tetrahedra of a cell (reading D2), as bits (x 1, y 2, z 4), in the order xyz, xzy,
/// yxz, yzx, zxy, zyx of the axes; each runs from corner 0 to corner 7, so its vertices ascend in number.
inline constexpr std::array<std::array<int, 4>, 6> kuhn_tets{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
/// Their orientations: the permutation of the axes is even or odd.
inline constexpr std::array<int, 6> kuhn_signs{1, -1, -1, 1, 1, -1};

/// The lattice of a surface's box, scaled about its centre by `box_scale` > 1 (reading D1). `cells` gives
/// three numbers, or one along the longest side and zeros: then the others follow so that the cells come
/// closest to cubes. Throws InputError if a number is out of range, the box is not between 1e-90 and 1e90
/// long, the lattice has more than 4e8 vertices, or its planes coincide in double precision.
Lattice make_lattice(const TriangleSurface& surface, std::array<int, 3> cells, double box_scale);

}  // namespace tetproof::reference
