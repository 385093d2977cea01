// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for a plane that separates two sets of points. Internal.
#pragma once

#include <Eigen/Core>
#include <span>

namespace tetproof::verify {

/// True only if each point of the convex hull of `a` is farther than `slack`, along at least one axis, from
/// each point of the convex hull of `b`. Exact up to rounding: the distance may be short of `slack` by 2^-47
/// times the largest absolute coordinate. False if the hulls are nearer, and where no separating plane was
/// found in a few steps. No coordinate may exceed 2^500; `a` and `b` are not empty.
bool separated(std::span<const Eigen::Vector3d> a, std::span<const Eigen::Vector3d> b, double slack);

}  // namespace tetproof::verify
