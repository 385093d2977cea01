// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/rounding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetproof::verify {

using Point = Eigen::Vector3d;

bool thinner_than_rounding(const std::array<Point, 4>& tet, double size) {
  double longest = 0, doubled_area = 0;
  for (int i = 0; i < 4; ++i) {
    const Point &a = tet[i], &b = tet[(i + 1) % 4], &c = tet[(i + 2) % 4];
    longest = std::max({longest, (b - a).norm(), (c - a).norm()});
    doubled_area = std::max(doubled_area, (b - a).cross(c - a).norm());
  }
  const double six_volumes = std::abs((tet[1] - tet[0]).cross(tet[2] - tet[0]).dot(tet[3] - tet[0]));
  return six_volumes <= 6e-12 * longest * longest * longest || six_volumes <= 1e-13 * size * doubled_area;
}

double smallest_solid_angle(const std::array<Point, 4>& tet) {
  double smallest = 1;
  for (int i = 0; i < 4; ++i) {  // van Oosterom and Strackee
    const Point a = tet[(i + 1) % 4] - tet[i], b = tet[(i + 2) % 4] - tet[i], c = tet[(i + 3) % 4] - tet[i];
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double omega = 2 * std::atan2(std::abs(a.cross(b).dot(c)),
                                        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    smallest = std::min(smallest, omega / (4 * std::numbers::pi));
  }
  return smallest;
}

}  // namespace tetproof::verify
