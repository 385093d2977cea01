// SPDX-License-Identifier: GPL-3.0-or-later
// Whether points lie on triangles, exactly. Internal.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::verify {

/// Is p in the closed triangle? Exact; false for a triangle without area.
bool on_triangle(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace tetproof::verify
