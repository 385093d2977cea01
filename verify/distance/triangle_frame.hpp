// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle in coordinates of its own plane, for distances that stay accurate for needles. Internal.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace tetproof::verify {

/// The triangle's corners have the coordinates (0, 0), (length, 0) and (t, h). Its longest edge lies along
/// the first axis, so 0 <= t <= length and the angles at that edge are acute.
///
/// The axes are orthonormal up to rounding, whatever the triangle's shape. The second axis of a needle may be
/// turned about the first by eps length / h, but this moves no point of the triangle by more than eps length.
/// So the distance from a point within R of the first corner has an absolute error of about eps R. This holds
/// for every triangle, also for one without area.
struct TriangleFrame {
  Eigen::Vector3d a, u, v;  // first corner; axes
  double length, t, h;
  double left_x, left_y, left_length;     // direction from (0, 0) to (t, h)
  double right_x, right_y, right_length;  // direction from (length, 0) to (t, h)
  int first;                              // the corner, 0 to 2, that is at (0, 0)

  struct Place {
    double x, y, zz;  // coordinates in the plane, and the squared height over it
  };

  static TriangleFrame of(const std::array<Eigen::Vector3d, 3>& corners) {
    std::array<double, 3> sides;
    for (int i = 0; i < 3; ++i) sides[i] = (corners[(i + 1) % 3] - corners[i]).squaredNorm();
    TriangleFrame f;
    f.first = static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    f.a = corners[f.first];
    const Eigen::Vector3d along = corners[(f.first + 1) % 3] - f.a, c = corners[(f.first + 2) % 3] - f.a;
    f.length = along.norm();
    f.u = f.length > 0 ? Eigen::Vector3d(along / f.length) : Eigen::Vector3d::Zero();
    // Orthogonalise twice: for a needle, the remainder after the first time need not be orthogonal.
    f.v = c - c.dot(f.u) * f.u;
    for (int i = 0; i < 2; ++i) {
      const double rest = f.v.norm();
      f.v = rest > 0 ? Eigen::Vector3d(f.v / rest) : Eigen::Vector3d::Zero();
      f.v -= f.v.dot(f.u) * f.u;
    }
    if (f.v.squaredNorm() < 0.25) f.v.setZero();
    f.t = std::clamp(c.dot(f.u), 0.0, f.length);
    f.h = std::max(c.dot(f.v), 0.0);
    f.left_length = std::hypot(f.t, f.h);
    f.left_x = f.left_length > 0 ? f.t / f.left_length : 1;
    f.left_y = f.left_length > 0 ? f.h / f.left_length : 0;
    f.right_length = std::hypot(f.length - f.t, f.h);
    f.right_x = f.right_length > 0 ? (f.t - f.length) / f.right_length : -1;
    f.right_y = f.right_length > 0 ? f.h / f.right_length : 0;
    return f;
  }

  Place place(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d w = p - a;
    const double x = w.dot(u), y = w.dot(v);
    return {x, y, (w - x * u - y * v).squaredNorm()};
  }

  /// The distance in the plane from the line of a side, positive outside. Sides have the triangle's numbers:
  /// side k runs from corner k to the next.
  double beyond(int side, const Place& p) const {
    switch ((side + 3 - first) % 3) {
      case 0:
        return -p.y;
      case 1:
        return (p.x - length) * right_y - p.y * right_x;
      default:
        return left_x * p.y - left_y * p.x;
    }
  }

  double squared_distance(const Place& p) const {
    if (p.y <= 0) {  // the angles at the longest edge are acute, so only this edge can be closest
      const double dx = p.x - std::clamp(p.x, 0.0, length);
      return p.zz + p.y * p.y + dx * dx;
    }
    const bool left = left_x * p.y > left_y * p.x, right = (p.x - length) * right_y > p.y * right_x;
    if (!left && !right) return p.zz;
    double least = INFINITY;
    const auto to_segment = [&](double x, double y, double dx, double dy, double l) {
      const double s = std::clamp(x * dx + y * dy, 0.0, l), rx = x - s * dx, ry = y - s * dy;
      least = std::min(least, rx * rx + ry * ry);
    };
    if (left) to_segment(p.x, p.y, left_x, left_y, left_length);
    if (right) to_segment(p.x - length, p.y, right_x, right_y, right_length);
    return p.zz + least;
  }

  double squared_distance(const Eigen::Vector3d& p) const { return squared_distance(place(p)); }
};

}  // namespace tetproof::verify
