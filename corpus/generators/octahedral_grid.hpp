// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere's worth of triangles without trigonometry: the octahedron unfolded onto the square [-1,1]^2.
#pragma once

#include <functional>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The unit vector at (u,v) in [-1,1]^2. The inner diamond |u|+|v| <= 1 is the upper half, seen from above;
/// the four corners are the lower half, folded down, all four corners of the square being the south pole.
/// Only +, -, *, / and sqrt: the same bits on every machine. Continuous, and smooth within each octant.
Eigen::Vector3d octahedral_direction(const Eigen::Vector2d& uv);

/// The frequency f whose 8 f^2 triangles come nearest to n.
int octahedral_frequency(double n);

/// A star-shaped surface of 8 f^2 triangles and 4 f^2 + 2 vertices, oriented outward, with (u,v) per corner;
/// `place` maps a unit vector to the vertex in its direction. No triangle straddles two octants. With a
/// `shift` (0 to 28, whole) the corners' u are that much larger, and (u,v) are rounded to multiples of 2^-47
/// first, so that the shift is exact.
TriangleSurface octahedral_surface(int f, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> place,
                                   double shift = 0);

}  // namespace tetproof::corpus
