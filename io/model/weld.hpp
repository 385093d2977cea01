// SPDX-License-Identifier: GPL-3.0-or-later
// Merges points with the same coordinates.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// Keeps the first of each set of equal points, in order, and returns the new position of each old point.
/// Equality is exact: -0 equals 0 (the first occurrence keeps its sign), and a point with a NaN equals no
/// point. Takes linear time. Throws std::length_error beyond 2^31 - 1 points, the limit of Index.
std::vector<Index> weld(std::vector<Eigen::Vector3d>& points);

}  // namespace tetproof::io
