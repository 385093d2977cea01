// SPDX-License-Identifier: GPL-3.0-or-later
// Fewer triangles that look alike, for pictures of large surfaces.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

struct ReducedTriangles {
  std::vector<std::array<Index, 3>> triangles;  ///< positions in the same points
  std::vector<std::size_t> from;                ///< of each, the triangle that it comes from
  double cell = 0;  ///< points within a cube of this size were joined [length]; 0: nothing was changed
};

/// Joins the points in each cell of a lattice to the first of them, and drops triangles that collapse or
/// coincide, until at most `most` triangles are left. Works on any set of triangles, closed or not; sheets
/// nearer than a cell may fall together. It is for the eye alone. All points that the triangles name must be
/// finite.
ReducedTriangles reduced(std::span<const Eigen::Vector3d> points,
                         std::span<const std::array<Index, 3>> triangles, std::size_t most);

}  // namespace tetproof::io
