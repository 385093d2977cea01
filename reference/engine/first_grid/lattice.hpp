// SPDX-License-Identifier: GPL-3.0-or-later
// Step (i): the lattice, which is the scaled bounding box of the surface, divided into cells by eq. (2.1),
// and each cell into six tetrahedra. Of the surface it uses only the bounding box.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// The number of a lattice vertex: i + (nx+1)(j + (ny+1)k), reading D3.
using Vertex = Index;

/// The number of a lattice edge: 8 * low + direction, which orders edges lexicographically by (low, high),
/// reading D3. The edge starts at its lower-numbered vertex, low, in one of seven directions: one cell along
/// +x if bit 0 is set, +y if bit 1, +z if bit 2.
using Edge = std::int64_t;

struct Lattice {
  std::array<int, 3> cells;  ///< nx, ny, nz
  /// The n+1 coordinates of the lattice planes normal to each axis [length].
  std::array<std::vector<double>, 3> planes;
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
  /// The difference between the numbers of the ends of an edge with direction `bits`, or of a cell's corner 0
  /// and its corner `bits`.
  Vertex offset(int bits) const {
    return (bits & 1 ? stride(0) : 0) + (bits & 2 ? stride(1) : 0) + (bits & 4 ? stride(2) : 0);
  }
  Vertex low(Edge e) const { return static_cast<Vertex>(e >> 3); }
  Vertex high(Edge e) const { return low(e) + offset(static_cast<int>(e & 7)); }
  /// The number of the last plane at or below `x`, or 0 if `x` is below all of them. So it is the number of a
  /// cell, 0 to n-1, or n from the last plane on.
  int cell_of(int axis, double x) const;
};

/// The corners of the six tetrahedra of a cell (reading D2). A corner is a sum of bits: 1 for x, 2 for y, 4
/// for z. Each tetrahedron walks from corner 0 to corner 7 along the axes in one order: xyz, xzy, yxz, yzx,
/// zxy, zyx. So its vertices ascend in number.
inline constexpr std::array<std::array<int, 4>, 6> kuhn_tets{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
/// The orientations of these tetrahedra: +1 if the permutation of the axes is even, -1 if it is odd.
inline constexpr std::array<int, 6> kuhn_signs{1, -1, -1, 1, 1, -1};

/// The lattice in the surface's box, scaled about its centre by `box_scale` > 1 (reading D1). `cells` gives
/// three numbers of cells; or one number, for the longest side, and two zeros, and then the other two are
/// chosen so that the cells come closest to cubes, at least 4 (or as many as along the longest side). Throws
/// InputError if a number is out of range, the longest side of the box is not between 1e-90 and 1e90, the
/// lattice has more than 4e8 vertices, or two planes coincide in double precision.
Lattice make_lattice(const TriangleSurface& surface, std::array<int, 3> cells, double box_scale);

}  // namespace tetproof::reference
