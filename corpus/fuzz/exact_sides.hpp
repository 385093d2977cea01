// SPDX-License-Identifier: GPL-3.0-or-later
// On which side a point lies: exact signs of determinants of doubles. Internal.
#pragma once

#include <Eigen/Core>

namespace tetproof::corpus {

/// The sign of (b - a) x (c - a): 1 if a, b, c turn anticlockwise.
int turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// The sign of (b - a) x (c - a) . (d - a): 1 if d lies on the side from which a, b, c turn anticlockwise.
int side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
         const Eigen::Vector3d& d);

}  // namespace tetproof::corpus
