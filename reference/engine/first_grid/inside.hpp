// SPDX-License-Identifier: GPL-3.0-or-later
// Inside or outside a closed surface, decided by parity along lines in the x direction, exactly (reading D4).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/engine/first_grid/lattice.hpp"

namespace tetproof::reference {

/// For each lattice vertex +1 inside or -1 outside the surface; for a vertex that lies on the surface either.
/// Whether the ray meets a triangle on its edge or at its corner is settled by moving the line by (epsilon,
/// epsilon^2) in y and z. Throws std::logic_error when a line leaves the box on the inside: the surface is
/// not closed.
std::vector<std::int8_t> inside_by_parity(const Lattice& lattice, const TriangleSurface& surface);

/// Answers for single points of the lattice's box, from the triangles over the cell column around the point.
class InsideTest {
 public:
  InsideTest(const Lattice& lattice, const TriangleSurface& surface);
  /// +1 inside, -1 outside, 0 on the surface; exact for the doubles as given.
  int operator()(const Eigen::Vector3d& p) const;

 private:
  const Lattice* lattice_;
  const TriangleSurface* surface_;
  std::vector<std::int64_t> first_;  // of each column (j, k) in triangles_
  std::vector<Index> triangles_;
};

}  // namespace tetproof::reference
