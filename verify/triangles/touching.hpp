// SPDX-License-Identifier: GPL-3.0-or-later
// Exact tests for points and segments that touch. Internal.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::verify {

/// Whether p lies in the plane of three points; true if they lie on a line. Exact.
bool touches_plane(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& plane);
/// Whether p lies on the closed segment. Exact.
bool touches_segment(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 2>& segment);
/// Whether two closed segments have a common point. Exact.
bool segments_touch(const std::array<Eigen::Vector3d, 2>& one, const std::array<Eigen::Vector3d, 2>& other);

}  // namespace tetproof::verify
