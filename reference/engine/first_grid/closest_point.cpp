// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/closest_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tetproof::reference {

using Eigen::Vector3d;

namespace {

Vector3d closest_on_segment(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const Vector3d d = b - a;
  const double length2 = d.squaredNorm(), t = d.dot(p - a);
  if (!(t > 0)) return a;
  return t < length2 ? Vector3d(a + (t / length2) * d) : b;
}

}  // namespace

bool lexicographically_less(const Vector3d& a, const Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

std::array<Vector3d, 3> sorted_corners(std::array<Vector3d, 3> triangle) {
  std::sort(triangle.begin(), triangle.end(), lexicographically_less);
  return triangle;
}

Vector3d closest_point(std::array<Vector3d, 3> triangle, const Vector3d& p) {
  const auto [a, b, c] = sorted_corners(std::move(triangle));
  Vector3d best = closest_on_segment(a, b, p);
  const auto consider = [&](const Vector3d& q) {
    const double now = (q - p).squaredNorm(), before = (best - p).squaredNorm();
    if (now < before || (now == before && lexicographically_less(q, best))) best = q;
  };
  consider(closest_on_segment(a, c, p));
  consider(closest_on_segment(b, c, p));
  // The foot of the perpendicular, if it falls inside the triangle. Where rounding misjudges that, the
  // closest point on an edge, found above, is almost as close.
  // Divided by a power of two, exactly: its square, the fourth power of a length, may be too large or too
  // small for a double. Not a number if the triangle has no area.
  const Vector3d n = (b - a).cross(c - a), normal = n / std::exp2(std::ilogb(n.cwiseAbs().maxCoeff()));
  const auto inside = [&](const Vector3d& u, const Vector3d& v) {
    return normal.dot((v - u).cross(p - u)) >= 0;
  };
  if (normal.squaredNorm() > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    consider(p - normal * (normal.dot(p - a) / normal.squaredNorm()));
  return best;
}

}  // namespace tetproof::reference
