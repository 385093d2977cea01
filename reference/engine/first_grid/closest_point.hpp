// SPDX-License-Identifier: GPL-3.0-or-later
// The closest point of a triangle, and the lexicographic order of points that settles ties.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::reference {

/// The point of a triangle that is closest to `p`, in double precision: the same for any order of the
/// corners.
Eigen::Vector3d closest_point(std::array<Eigen::Vector3d, 3> triangle, const Eigen::Vector3d& p);

/// A triangle with its corners in lexicographic order, so that nothing computed from it depends on the
/// numbering of the vertices.
std::array<Eigen::Vector3d, 3> sorted_corners(std::array<Eigen::Vector3d, 3> triangle);
bool lexicographically_less(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace tetproof::reference
