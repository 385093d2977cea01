// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/exact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tetproof::reference {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_3 point(const Eigen::Vector3d& a) {
  return {a.x(), a.y(), a.z()};
}

// The axis along which the triangle can be projected so that the projection has an area, decided exactly. -1
// if there is none: then the triangle has no area either.
int projection_axis(const std::array<Eigen::Vector3d, 3>& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (orientation(t[0][u], t[0][v], t[1][u], t[1][v], t[2][u], t[2][v]) != 0) return axis;
  }
  return -1;
}

}  // namespace

int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
  return static_cast<int>(
      CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by), Kernel::Point_2(cx, cy)));
}

bool in_closed_triangle(const std::array<Eigen::Vector3d, 3>& t, const Eigen::Vector3d& p) {
  const int axis = projection_axis(t);
  if (axis < 0) return false;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  int signs[3];
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d &a = t[c], &b = t[(c + 1) % 3];
    signs[c] = orientation(a[u], a[v], b[u], b[v], p[u], p[v]);
  }
  return (signs[0] >= 0 && signs[1] >= 0 && signs[2] >= 0) ||
         (signs[0] <= 0 && signs[1] <= 0 && signs[2] <= 0);
}

}  // namespace tetproof::reference
