// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/exact_sides.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "corpus/truth.hpp"

namespace tetproof::corpus {

int side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
         const Eigen::Vector3d& d) {
  // In doubles first. Each entry has one rounding error, each of the six products of three entries at most
  // five errors of 2^-53 altogether, and their sum five more: 16 units of the products' absolute sum are
  // enough. A result that is small, or edges that are so long that a
  // product's underflow would count, are left to the integers.
  const Eigen::Vector3d u = b - a, v = c - a, w = d - a;
  const double computed = u.cross(v).dot(w);
  const Eigen::Vector3d p = u.cwiseAbs(), q = v.cwiseAbs(), r = w.cwiseAbs();
  const double magnitude = (p[1] * q[2] + p[2] * q[1]) * r[0] + (p[2] * q[0] + p[0] * q[2]) * r[1] +
                           (p[0] * q[1] + p[1] * q[0]) * r[2];
  if (std::abs(computed) > magnitude * 0x1p-49 && std::abs(computed) > 1e-200 && r.maxCoeff() < 1e100)
    return computed > 0 ? 1 : -1;
  return orientation(a, b, c, d);
}

int turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const auto flat = [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p[0], p[1], 0); };
  return side(flat(a), flat(b), flat(c), {a[0], a[1], 1});
}

}  // namespace tetproof::corpus
