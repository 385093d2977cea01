// SPDX-License-Identifier: GPL-3.0-or-later
// Exact test for a point on a triangle. Internal.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::verify {

/// Whether p lies in the closed triangle. Exact; false for a triangle without area.
bool on_triangle(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace tetproof::verify
