// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/on_triangle.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tetproof::verify {

bool on_triangle(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Eigen::Vector3d& x) { return Kernel::Point_3(x.x(), x.y(), x.z()); };
  const Kernel::Point_3 a = point(corners[0]), b = point(corners[1]), c = point(corners[2]), q = point(p);
  if (CGAL::orientation(a, b, c, q) != CGAL::COPLANAR) return false;
  // All four points lie in one plane. Project them along an axis that the plane does not contain.
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [&](const Eigen::Vector3d& x) {
      return Kernel::Point_2(x[(axis + 1) % 3], x[(axis + 2) % 3]);
    };
    const Kernel::Point_2 fa = flat(corners[0]), fb = flat(corners[1]), fc = flat(corners[2]), fq = flat(p);
    const CGAL::Orientation whole = CGAL::orientation(fa, fb, fc);
    if (whole == CGAL::COLLINEAR) continue;
    const auto outside = [&](const Kernel::Point_2& x, const Kernel::Point_2& y) {
      return CGAL::orientation(x, y, fq) == -whole;
    };
    return !outside(fa, fb) && !outside(fb, fc) && !outside(fc, fa);
  }
  return false;
}

}  // namespace tetproof::verify
