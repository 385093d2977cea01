// SPDX-License-Identifier: GPL-3.0-or-later
// Rays from exact rational points inside triangles, and which other triangles they cross. Internal.
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

/// For each start triangle, what a ray crosses that leaves from its centroid to its outer side. The signs add
/// up to the winding number of all other triangles at the centroid, on its outer side, if together they have
/// no border; the parity of the crossings of a closed sheet says whether the centroid lies inside it. Decided
/// in exact arithmetic; where the ray meets an edge or vertex, as if the start were an infinitesimal step
/// aside. A triangle that contains the centroid (the two then intersect) is not crossed. Start triangles must
/// not be degenerate. Crossings ascend by triangle.
std::vector<std::vector<Crossing>> cast_rays(std::span<const Eigen::Vector3d> points,
                                             std::span<const Triangle> triangles,
                                             std::span<const Index> starts);

/// In how many other sheets each closed sheet lies, decided at the centroid of its first triangle.
std::vector<int> nesting_depths(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                const Sheets& sheets);

/// The first tetrahedron but `without` that contains the points next to a triangle's centroid on its inner
/// side, or -1; exact. All tetrahedra but the `excluded` ones (empty: none) are looked at; negative and flat
/// ones contain nothing.
Index tet_inside(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded, const Triangle& triangle,
                 Index without);

}  // namespace tetproof::verify
