// SPDX-License-Identifier: GPL-3.0-or-later
// Step (v): the formulas of section 3, one function for each. The distance of eq. (3.2) is in
// vertex_tree.hpp.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace tetproof::reference {

/// The parameters of eq. (3.1).
struct VolumeLaw {
  double v0;     ///< at distance 0, positive [length^3]
  double v1;     ///< at distance d1, positive [length^3]
  double d1;     ///< positive [length]
  double p = 1;  ///< positive; 1: linear, above 1: polynomial, below 1: root
};

/// The signed volume of the tetrahedron with the corners a, b, c, d [length^3]. Its relative error is about
/// 1e-15 times the cube of the longest edge over the volume.
double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d);

/// The centroid in eq. (3.2): a quarter of the sum of the corners.
Eigen::Vector3d centroid(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                         const Eigen::Vector3d& d);

/// Eq. (3.1): the volume [length^3] that a tetrahedron at distance d >= 0 [length] should have. The equation
/// is also used beyond d1, but the volume is never below the smaller of v0 and v1 (reading D13).
double desired_volume(double d, const VolumeLaw& law);

/// Eq. (3.3): the difference between a volume and the desired one [length^3], not negative.
double volume_error(double volume, double desired);

/// Eq. (3.4): the mean error [length^3] of `tets` tetrahedra, from the sum of their errors.
double average_error(double sum, std::int64_t tets);

/// Eq. (3.5): the mean error [length^3] after one of `tets` tetrahedra is split into `pieces` and the sum of
/// the errors changes by `change`. For m pieces the mean is over L + m - 1 tetrahedra; the paper's L + 3 is
/// for four (reading D16).
double average_error_after_split(double sum, double change, std::int64_t tets, int pieces);

/// Eq. (3.6): the weight of the distance, which is 1 at the smallest absolute curvature and 1/10 at the
/// largest. It is 1 if both are equal (reading D15).
double curvature_weight(double kappa, double kappa_min, double kappa_max);

}  // namespace tetproof::reference
