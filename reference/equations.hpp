// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's equations, one function for each. The distance of eq. (3.2) is a search and not here: see
// `Page::distance` in paper/page.hpp and `VertexTree::distance` in engine/adaptation/vertex_tree.hpp.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetproof::reference {

/// Eq. (2.1) for one coordinate: (1-t) X_0 + t X_1. The sum over I, J, K of eq. (2.1) is the product of three
/// of these, because the edges of the box are parallel to the axes (reading D1).
inline double eq_2_1(double x0, double x1, double t) {
  return (1 - t) * x0 + t * x1;
}

/// The parameters of eq. (3.1).
struct VolumeLaw {
  double v0;     ///< at distance 0, positive [length^3]
  double v1;     ///< at distance d1, positive [length^3]
  double d1;     ///< positive [length]
  double p = 1;  ///< positive; 1: linear, above 1: polynomial, below 1: root
};

/// The signed volume of the tetrahedron with the corners a, b, c, d [length^3]. Its relative error is about
/// 1e-15 times the cube of the longest edge over the volume.
inline double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a) / 6;
}

/// The centroid in eq. (3.2): a quarter of the sum of the corners.
inline Eigen::Vector3d centroid(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                const Eigen::Vector3d& d) {
  return (a + b + c + d) / 4;
}

/// Eq. (3.1): the volume [length^3] that a tetrahedron at distance d >= 0 [length] should have. The equation
/// is also used beyond d1, but the volume is never below the smaller of v0 and v1 (reading D13).
inline double desired_volume(double d, const VolumeLaw& law) {
  const double t = std::pow(d / law.d1, law.p);
  return std::max((1 - t) * law.v0 + t * law.v1, std::min(law.v0, law.v1));
}

/// Eq. (3.3): the difference between a volume and the desired one [length^3], not negative.
inline double volume_error(double volume, double desired) {
  return std::abs(volume - desired);
}

/// Eq. (3.4): the mean error [length^3] of `tets` tetrahedra, from the sum of their errors.
inline double average_error(double sum, std::int64_t tets) {
  return sum / static_cast<double>(tets);
}

/// Eq. (3.5): the mean error [length^3] after one of `tets` tetrahedra is split into `pieces` and the sum of
/// the errors changes by `change`. For m pieces the mean is over L + m - 1 tetrahedra; the L + 3 of the page
/// is for four (reading D16).
inline double average_error_after_split(double sum, double change, std::int64_t tets, int pieces) {
  return (sum + change) / static_cast<double>(tets + pieces - 1);
}

/// A sum of doubles with Neumaier's compensation, so that its error does not grow with the number of terms
/// (reading D16).
class CompensatedSum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

/// Eq. (3.6): the weight of the distance, which is 1 at the smallest absolute curvature and 1/10 at the
/// largest. It is 1 if both are equal (reading D15).
inline double curvature_weight(double kappa, double kappa_min, double kappa_max) {
  if (kappa_min == kappa_max) return 1;
  const double range = kappa_max - kappa_min;
  return (kappa_max - kappa) / range + (kappa - kappa_min) / range / 10;
}

}  // namespace tetproof::reference
