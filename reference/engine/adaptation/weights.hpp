// SPDX-License-Identifier: GPL-3.0-or-later
// Step (v): eqs (3.1) to (3.6), one function each.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace tetproof::reference {

/// The volumes that eq. (3.1) asks for.
struct VolumeLaw {
  double v0;     ///< at distance 0, positive [length^3]
  double v1;     ///< at distance d1, positive [length^3]
  double d1;     ///< positive [length]
  double p = 1;  ///< positive: linear for 1, polynomial above, root below
};

/// The volume of a tetrahedron with the corners a, b, c, d [length^3], signed. Relative error about 1e-15
/// times the cube of its longest edge over its volume.
double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d);

/// The centroid of eq. (3.2), a quarter of the sum of the corners.
Eigen::Vector3d centroid(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                         const Eigen::Vector3d& d);

/// Eq. (3.1): the volume [length^3] that a tetrahedron at distance d >= 0 [length] should have. Used as it
/// stands beyond d1, but never below the smaller of v0 and v1 (reading D13).
double desired_volume(double d, const VolumeLaw& law);

/// Eq. (3.3): how far a volume is from the desired one [length^3].
double volume_error(double volume, double desired);

/// Eq. (3.4): the mean of the errors of `tets` tetrahedra, from their sum.
double average_error(double sum, std::int64_t tets);

/// Eq. (3.5): the mean after one tetrahedron was split into `pieces` and the sum of errors grew by `change`
/// (reading D16: over L + m - 1 for m pieces; the paper's L + 3 is for four).
double average_error_after_split(double sum, double change, std::int64_t tets, int pieces);

/// Eq. (3.6): the weight of the distance, 1 at the smallest absolute curvature and 1/10 at the largest; 1 if
/// all are equal (reading D15).
double curvature_weight(double kappa, double kappa_min, double kappa_max);

}  // namespace tetproof::reference
