// SPDX-License-Identifier: GPL-3.0-or-later
// Points with the same coordinates become one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// Keeps the first of each set of equal points, in order, and returns for each old point its new position.
/// Equality is exact: -0 equals 0 (the first occurrence keeps its sign), a point with a NaN equals none. Time
/// is linear. Throws std::length_error beyond 2^31 - 1 points, which no Index could name.
std::vector<Index> weld(std::vector<Eigen::Vector3d>& points);

}  // namespace tetproof::io
