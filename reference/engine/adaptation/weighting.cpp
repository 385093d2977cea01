// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/weighting.hpp"

#include <algorithm>

#include "reference/engine/adaptation/curvature.hpp"

namespace tetproof::reference {

Weighting::Weighting(const TriangleSurface& surface, bool curvature) : tree_(surface.vertices) {
  if (!curvature) return;
  kappas_ = absolute_curvatures(surface);
  const auto [least, most] = std::minmax_element(kappas_.begin(), kappas_.end());
  kappa_min_ = *least;
  kappa_max_ = *most;
}

double Weighting::distance(const std::array<Eigen::Vector3d, 4>& corners, double within) const {
  const auto& [a, b, c, d] = corners;
  return tree_.distance(centroid(a, b, c, d), within);
}

Weight Weighting::weigh(const std::array<Eigen::Vector3d, 4>& corners, double distance) const {
  const auto& [a, b, c, d] = corners;
  Weight w{.d = distance, .kappa = 0, .omega = 1, .volume = volume(a, b, c, d)};
  if (with_curvature()) {
    w.kappa = kappas_[tree_.nearest(centroid(a, b, c, d), distance)];
    w.omega = curvature_weight(w.kappa, kappa_min_, kappa_max_);
  }
  w.desired = desired_volume(w.omega * w.d, law_);
  w.error = volume_error(w.volume, w.desired);
  return w;
}

double Weighting::least_error(double volume, double d, double reach) const {
  constexpr double slack = 1e-12;  // far above the rounding errors of the distances and of eq. (3.1)
  const double nearest =
      std::max(0.0, (d - reach) * (1 - slack)) * (with_curvature() ? 0.1 : 1) * (1 - slack);
  const double farthest = (d + reach) * (1 + slack);
  const double at_nearest = desired_volume(nearest, law_), at_farthest = desired_volume(farthest, law_);
  const double least = std::min(at_nearest, at_farthest) * (1 - slack),
               most = std::max(at_nearest, at_farthest) * (1 + slack);
  return std::max({0.0, least - volume, volume - most});
}

}  // namespace tetproof::reference
