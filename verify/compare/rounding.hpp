// SPDX-License-Identifier: GPL-3.0-or-later
// Whether rounding decides about a tetrahedron: what two right implementations that add in another order may
// see differently. Internal.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::verify {

/// Relative difference up to which two numbers that are compared to choose are equally good.
inline constexpr double tie = 1e-12;

/// Whether a tetrahedron is so thin that its sign and its quality are a matter of rounding: a volume below
/// 1e-12 of its longest edge's cube, or a height below 1e-13 of `size`, the magnitude of the coordinates.
bool thinner_than_rounding(const std::array<Eigen::Vector3d, 4>& tet, double size);

/// The smallest solid angle of a tetrahedron, over 4 pi.
double smallest_solid_angle(const std::array<Eigen::Vector3d, 4>& tet);

}  // namespace tetproof::verify
