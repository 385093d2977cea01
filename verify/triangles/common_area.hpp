// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two triangles lie on each other, with opposite orientations. Internal.
#pragma once

#include <Eigen/Core>
#include <span>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// Whether two triangles lie in one plane, face opposite directions, and have more in common than points and
/// segments. Exact. False if one of them is degenerate.
bool back_to_back(std::span<const Eigen::Vector3d> points, const Triangle& s, const Triangle& t);

}  // namespace tetproof::verify
