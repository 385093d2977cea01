// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/common_area.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A triangle without one of its coordinates.
using Flat = std::array<Kernel::Point_2, 3>;
Flat without(int axis, std::span<const Eigen::Vector3d> points, const Triangle& t) {
  Flat flat;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& p = points[t[k]];
    flat[k] = {p[(axis + 1) % 3], p[(axis + 2) % 3]};
  }
  return flat;
}

// Whether the line through an edge of `one` has all of `other` on the side away from `one`, or on itself.
// `turn` is the orientation of `one`.
bool an_edge_separates(const Flat& one, CGAL::Orientation turn, const Flat& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    bool away = true;
    for (const Kernel::Point_2& p : other)
      away = away && CGAL::orientation(one[k], one[(k + 1) % 3], p) != turn;
    if (away) return true;
  }
  return false;
}

}  // namespace

bool back_to_back(std::span<const Eigen::Vector3d> points, const Triangle& s, const Triangle& t) {
  const auto point = [&](Index v) {
    const Eigen::Vector3d& p = points[v];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  for (const Index v : t)
    if (CGAL::orientation(point(s[0]), point(s[1]), point(s[2]), point(v)) != CGAL::COPLANAR) return false;
  // In one plane, an axis that is not parallel to it can be left out.
  for (int axis = 0; axis < 3; ++axis) {
    const Flat one = without(axis, points, s);
    const CGAL::Orientation turn = CGAL::orientation(one[0], one[1], one[2]);
    if (turn == CGAL::COLLINEAR) continue;
    const Flat other = without(axis, points, t);
    return CGAL::orientation(other[0], other[1], other[2]) == -turn && !an_edge_separates(one, turn, other) &&
           !an_edge_separates(other, -turn, one);
  }
  return false;
}

}  // namespace tetproof::verify
