// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulation of star-shaped surfaces without trigonometry: the octahedron, unfolded onto the square
// [-1,1]^2.
#pragma once

#include <functional>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The unit vector at (u,v) in [-1,1]^2. The inner diamond |u|+|v| <= 1 is the upper half of the sphere, seen
/// from above. The four triangles outside it are the lower half, folded down; all four corners of the square
/// are the south pole. The map is continuous, and smooth within each octant. It uses only +, -, *, / and
/// sqrt, so that its bits are the same on every machine.
Eigen::Vector3d octahedral_direction(const Eigen::Vector2d& uv);

/// The frequency f whose number of triangles, 8 f^2, is nearest to n.
int octahedral_frequency(double n);

/// A star-shaped surface of 8 f^2 triangles and 4 f^2 + 2 vertices, oriented outward, with (u,v) for each
/// corner. `place` maps a unit vector to the vertex in its direction. Every triangle lies in one octant.
/// `shift`, an integer from 0 to 28, is added to u at every corner. If it is not 0, (u,v) are first rounded
/// to multiples of 2^-47, so that the addition is exact.
TriangleSurface octahedral_surface(int f, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> place,
                                   double shift = 0);

}  // namespace tetproof::corpus
