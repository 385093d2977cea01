// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/weights.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::reference {

double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a) / 6;
}

Eigen::Vector3d centroid(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                         const Eigen::Vector3d& d) {
  return (a + b + c + d) / 4;
}

double desired_volume(double d, const VolumeLaw& law) {
  const double t = std::pow(d / law.d1, law.p);
  return std::max((1 - t) * law.v0 + t * law.v1, std::min(law.v0, law.v1));
}

double volume_error(double volume, double desired) {
  return std::abs(volume - desired);
}

double average_error(double sum, std::int64_t tets) {
  return sum / static_cast<double>(tets);
}

double average_error_after_split(double sum, double change, std::int64_t tets, int pieces) {
  return (sum + change) / static_cast<double>(tets + pieces - 1);
}

double curvature_weight(double kappa, double kappa_min, double kappa_max) {
  if (kappa_min == kappa_max) return 1;
  const double range = kappa_max - kappa_min;
  return (kappa_max - kappa) / range + (kappa - kappa_min) / range / 10;
}

}  // namespace tetproof::reference
