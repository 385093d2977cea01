// SPDX-License-Identifier: GPL-3.0-or-later
// The exact predicates that decide in the reference (reading D4).
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::reference {

/// Sign of (b-a) x (c-a) . (d-a), exact for the doubles as given: +1 when {a, b, c, d} is a positive
/// tetrahedron.
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d);

/// Sign of the area of the triangle (ax,ay) (bx,by) (cx,cy), exact: +1 when it runs anticlockwise.
int orientation(double ax, double ay, double bx, double by, double cx, double cy);

/// Whether a point of the plane of a triangle lies in the closed triangle, exact. False for a triangle
/// without an area.
bool in_closed_triangle(const std::array<Eigen::Vector3d, 3>& t, const Eigen::Vector3d& p);

}  // namespace tetproof::reference
