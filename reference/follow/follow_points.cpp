// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow_points.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::reference {

bool close(double a, double b) {
  return std::abs(a - b) <= agree * std::max(std::abs(a), std::abs(b));
}

std::string text(const Eigen::Vector3d& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x(), p.y(), p.z());
}

Corners sorted(Corners tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

TracePoints::TracePoints(const TetMesh& first_grid) : tree_(first_grid.points) {
  Eigen::AlignedBox<double, 3> box;
  for (const auto& p : first_grid.points) box.extend(p);
  reach_ = same_place * box.diagonal().norm();
}

Index TracePoints::find(const Eigen::Vector3d& p) {
  if (const auto known = known_.find(p); known != known_.end()) return known->second;
  if (!p.allFinite()) throw Divergence{"a point is not finite"};
  const double distance = tree_.distance(p);
  if (distance > reach_) throw Divergence{fmt::format("there is no point {} in the grid", text(p))};
  return known_.emplace(p, tree_.nearest(p, distance)).first->second;
}

}  // namespace tetproof::reference
