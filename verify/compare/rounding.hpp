// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether rounding decides about a tetrahedron: two correct implementations that add in another order
// may then see it differently. Internal.
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::verify {

/// Two numbers that decide a choice are equally good up to this relative difference.
inline constexpr double tie = 1e-12;

/// Whether a tetrahedron is so thin that rounding decides its sign and its quality: its volume is below 1e-12
/// of the cube of its longest edge, or a height is below 1e-13 of `size`, the magnitude of the coordinates
/// [length].
bool thinner_than_rounding(const std::array<Eigen::Vector3d, 4>& tet, double size);

/// The smallest solid angle of a tetrahedron, divided by 4 pi.
double smallest_solid_angle(const std::array<Eigen::Vector3d, 4>& tet);

}  // namespace tetproof::verify
