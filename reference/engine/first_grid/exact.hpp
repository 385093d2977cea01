// SPDX-License-Identifier: GPL-3.0-or-later
// The exact predicates on which the decisions of the reference rest (reading D4).
#pragma once

#include <Eigen/Core>
#include <array>

namespace tetproof::reference {

/// The sign of (b-a) x (c-a) . (d-a), exact for the doubles as given: +1 if {a, b, c, d} is a positive
/// tetrahedron.
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d);

/// The sign of the area of the triangle (ax,ay) (bx,by) (cx,cy), exact: +1 if its corners run anticlockwise.
int orientation(double ax, double ay, double bx, double by, double cx, double cy);

/// Whether `p`, which must lie in the plane of the triangle, lies in the closed triangle. Exact. False for a
/// triangle without an area.
bool in_closed_triangle(const std::array<Eigen::Vector3d, 3>& t, const Eigen::Vector3d& p);

}  // namespace tetproof::reference
