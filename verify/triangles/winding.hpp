// SPDX-License-Identifier: GPL-3.0-or-later
// Rays from exact rational points inside triangles, and the triangles that they cross. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

struct Crossing {
  Index triangle;
  int sign;  ///< +1: the ray passes to the triangle's outer side; -1: to its inner side
};

/// Casts a ray from the centroid of each start triangle towards its outer side and lists the other triangles
/// that it crosses, ascending. If all triangles together have no border, the sum of the signs is the winding
/// number of all other triangles just outside the centroid. The parity of the crossings with one closed sheet
/// says whether the centroid lies inside that sheet.
///
/// All decisions are exact. Where a ray meets an edge or a vertex, the start counts as moved aside by an
/// infinitesimal step. A triangle that contains the centroid (the two then intersect) is not crossed. Start
/// triangles must not be degenerate.
std::vector<std::vector<Crossing>> cast_rays(std::span<const Eigen::Vector3d> points,
                                             std::span<const Triangle> triangles,
                                             std::span<const Index> starts);

/// For each closed sheet, the number of other sheets that it lies inside, decided at the centroid of its
/// first triangle.
std::vector<int> nesting_depths(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                const Sheets& sheets);

/// The first tetrahedron that contains the points next to a triangle's centroid on its inner side; -1 if
/// there is none. Exact. The tetrahedron `without` and the `excluded` ones (empty: none) do not count;
/// negative and flat ones contain nothing.
Index tet_inside(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded, const Triangle& triangle,
                 Index without);

}  // namespace tetproof::verify
