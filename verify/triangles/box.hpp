// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding box of a triangle, in the form that CGAL's box_intersection_d needs. Internal.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// A model of CGAL's concept BoxIntersectionBox_d. All boxes of one search need different numbers. (CGAL's
/// own boxes identify themselves by their address, which changes when they are sorted, or by a global
/// counter.)
struct Box {
  using NT = double;
  using ID = std::size_t;
  static constexpr int dimension() { return 3; }
  double min_coord(int d) const { return low[static_cast<std::size_t>(d)]; }
  double max_coord(int d) const { return high[static_cast<std::size_t>(d)]; }
  ID id() const { return number; }

  bool meets(const Box& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
  void add(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k)
      low[k] = std::min(low[k], other.low[k]), high[k] = std::max(high[k], other.high[k]);
  }

  std::array<double, 3> low, high;
  ID number;
};

inline Box box_of(std::span<const Eigen::Vector3d> points, const Triangle& t, std::size_t number) {
  const Eigen::Vector3d &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
  const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}, number};
}

}  // namespace tetproof::verify
