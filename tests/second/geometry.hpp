// SPDX-License-Identifier: GPL-3.0-or-later
// Exact questions about points and a surface, each answered by asking all triangles in turn.
#pragma once

#include <Eigen/Geometry>

#include "io/triangle_surface.hpp"

namespace tetproof::second {

using Point = Eigen::Vector3d;

/// The exact sign of (b-a) x (c-a) . (d-a).
int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Is p exactly on a triangle of the surface?
bool is_on(const TriangleSurface& surface, const Point& p);

/// Is p, which is not on the surface, inside it? Exact, by the parity of a ray that meets no edge and no
/// vertex.
bool is_inside(const TriangleSurface& surface, const Point& p);

/// The point of a triangle that is closest to p.
Point closest_on_triangle(const Point& p, const Point& a, const Point& b, const Point& c);

/// The point of the surface that is closest to p, of several the lexicographically smallest; p itself if it
/// is on it.
Point closest_on_surface(const TriangleSurface& surface, const Point& p);

bool lexicographically_less(const Point& a, const Point& b);

}  // namespace tetproof::second
