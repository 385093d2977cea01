// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a point is inside or outside a closed surface: decided exactly, by the parity of crossings along
// lines in the x direction (reading D4).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/engine/first_grid/lattice.hpp"

namespace tetproof::reference {

/// For each lattice vertex, +1 if it is inside the surface and -1 if it is outside. A vertex on the surface
/// may get either. Where a line meets an edge or a corner of a triangle, it counts as moved by (epsilon,
/// epsilon^2) in y and z. Throws std::logic_error if a line is still inside where it leaves the box: then the
/// surface is not closed.
std::vector<std::int8_t> inside_by_parity(const Lattice& lattice, const TriangleSurface& surface);

/// Tests single points of the lattice's box. It uses only the triangles that meet the column of cells, along
/// x, that holds the point.
class InsideTest {
 public:
  InsideTest(const Lattice& lattice, const TriangleSurface& surface);
  /// +1 inside, -1 outside, 0 on the surface; exact for the doubles as given.
  int operator()(const Eigen::Vector3d& p) const;

 private:
  const Lattice* lattice_;
  const TriangleSurface* surface_;
  std::vector<std::int64_t> first_;  // of each column (j, k), the position in triangles_
  std::vector<Index> triangles_;
};

}  // namespace tetproof::reference
