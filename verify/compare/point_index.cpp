// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/point_index.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "io/error.hpp"

namespace tetproof::verify {
namespace {

constexpr double cell_in_tolerances = 8;  // most look-ups then stay in one cell
constexpr int crowd = 512;

}  // namespace

PointIndex::PointIndex(double tolerance) : tolerance_(tolerance), width_(cell_in_tolerances * tolerance) {}

PointIndex::Cell PointIndex::cell(const Eigen::Vector3d& point) const {
  Cell cell;
  for (int i = 0; i < 3; ++i)
    cell[i] = (width_ > 0 ? std::floor(point[i] / width_) : point[i]) + 0.0;  // no -0
  return cell;
}

int PointIndex::append(const Eigen::Vector3d& point) {
  Last& last = cells_[cell(point)];
  ++last.count;
  before_.push_back(last.point);
  points_.push_back(point);
  return last.point = static_cast<int>(points_.size()) - 1;
}

void PointIndex::check_crowd(const Last& last, const Eigen::Vector3d& point) const {
  if (last.count > crowd)
    throw InputError(
        fmt::format("more than {} points lie within {} times the tolerance {:.3g} of ({:.9g}, {:.9g}, "
                    "{:.9g}): a smaller --tolerance is needed",
                    crowd, cell_in_tolerances, tolerance_, point.x(), point.y(), point.z()));
}

int PointIndex::add(const Eigen::Vector3d& point) {
  if (const auto found = cells_.find(cell(point)); found != cells_.end()) {
    check_crowd(found->second, point);
    for (int i = found->second.point; i >= 0; i = before_[i])
      if (points_[i] == point) return i;
  }
  return append(point);
}

int PointIndex::find(const Eigen::Vector3d& point, const std::vector<bool>& taken) const {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(tolerance_);
  const Cell low = cell(point - reach), high = cell(point + reach);
  int best = -1;
  double closest = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    Cell cell;
    bool again = false;  // an earlier corner was in the same cell
    for (int i = 0; i < 3; ++i) {
      cell[i] = corner >> i & 1 ? high[i] : low[i];
      again |= (corner >> i & 1) && high[i] == low[i];
    }
    if (again) continue;
    const auto found = cells_.find(cell);
    if (found == cells_.end()) continue;
    check_crowd(found->second, point);
    for (int i = found->second.point; i >= 0; i = before_[i]) {
      if (static_cast<std::size_t>(i) < taken.size() && taken[i]) continue;
      const double distance = (points_[i] - point).norm();
      if (distance <= tolerance_ && (distance < closest || (distance == closest && i < best)))
        best = i, closest = distance;
    }
  }
  return best;
}

}  // namespace tetproof::verify
