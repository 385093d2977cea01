// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/projection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::corpus {
namespace {

using Eigen::Vector3d;

Vector3d unit(const Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Vector3d::Zero();
  const Vector3d scaled = v / largest;
  return scaled / scaled.norm();
}

// Directions that look along no axis and no diagonal, so that boxes and grids are seen as solids.
std::vector<Vector3d> fixed_directions() {
  std::vector<Vector3d> directions;
  for (const auto& [a, b, c] : {std::array{9, 6, 4}, {9, 4, 6}, {6, 9, 4}, {4, 9, 6}, {4, 6, 9}, {6, 4, 9}})
    for (const auto& [s, t] : {std::array{1, 1}, {-1, 1}, {1, -1}, {-1, -1}})
      directions.push_back(unit(Vector3d(s * a, t * b, c)));
  return directions;
}

}  // namespace

Vector3d best_direction(std::span<const DrawnTriangle> triangles) {
  std::vector<Vector3d> normals;  // as long as twice the area, in units that neither over- nor underflow
  double size = 0;
  for (const DrawnTriangle& t : triangles)
    for (int k = 1; k < 3; ++k)
      size = std::max(size, (t[static_cast<std::size_t>(k)] - t[0]).cwiseAbs().maxCoeff());
  if (!(size > 0)) size = 1;
  for (const DrawnTriangle& t : triangles)
    normals.push_back(((t[1] - t[0]) / size).cross((t[2] - t[0]) / size));
  std::vector<Vector3d> directions = fixed_directions();
  const std::size_t step = triangles.size() / 40 + 1;  // normals, tilted, so that thin parts look like solids
  for (std::size_t i = 0; i < normals.size(); i += step)
    if (const Vector3d n = unit(normals[i]); n != Vector3d::Zero())
      directions.push_back(unit(n + Vector3d(0.31, -0.23, 0.17)));
  Vector3d best = directions.front();
  double most = -1;
  for (const Vector3d& d : directions) {
    double shadow = 0, all = 0;
    int edge_on = 0;
    for (const Vector3d& n : normals) {
      const double seen = std::abs(n.dot(d)), area = n.norm();
      shadow += seen;
      all += area;
      edge_on += seen < 0.08 * area;
    }
    const double score = (all > 0 ? shadow / all : 0) - 0.5 * edge_on / static_cast<double>(normals.size());
    if (score > most + 1e-6) most = score, best = d;
  }
  return best;
}

Projection::Projection(const Vector3d& seen_from, std::span<const Vector3d> points, const Frame& frame)
    : seen_from_(seen_from), middle_(Vector3d::Zero()), frame_(frame) {
  if (!points.empty()) {
    Vector3d low = points.front(), high = low;
    for (const Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    middle_ = low + (high - low) / 2;
  }
  const Vector3d z = std::abs(seen_from_.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitY();
  right_ = unit(z.cross(seen_from_));
  up_ = seen_from_.cross(right_);
  const auto measure = [&] {
    std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (const Vector3d& p : points) {
      const std::array<double, 2> at{right_.dot(p - middle_), up_.dot(p - middle_)};
      for (std::size_t k = 0; k < 2; ++k)
        low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = points.empty() ? 0 : low[k];
      size_[k] = points.empty() ? 0 : high[k] - low[k];
    }
  };
  measure();
  const double larger = std::max(size_[0], size_[1]);
  // The two points that are farthest apart, or nearly: far from the first, and far from that.
  const auto farthest = [&](const Vector3d& from) {
    Vector3d found = from;
    double most = -1;
    for (const Vector3d& p : points) {
      const Vector3d way = p - from;
      const double a = right_.dot(way), b = up_.dot(way), length = a * a + b * b;
      if (length > most) most = length, found = p;
    }
    return found;
  };
  if (larger > 0) {
    const Vector3d one = farthest(points.front()), other = farthest(one), way = other - one;
    const Vector3d along = unit(right_.dot(way) * right_ + up_.dot(way) * up_);
    if (along != Vector3d::Zero()) {
      const Vector3d across = seen_from_.cross(along);
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Vector3d& p : points) {
        low = std::min(low, across.dot(p - middle_));
        high = std::max(high, across.dot(p - middle_));
      }
      if (high - low < larger / 5) {  // a strip
        right_ = along;
        up_ = across;
        measure();
      }
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const double room = k == 0 ? frame_.width : frame_.height;
    scale_[k] = size_[k] > 0 ? room / size_[k] : 0;
  }
  const double smaller =
      scale_[0] > 0 && scale_[1] > 0 ? std::min(scale_[0], scale_[1]) : std::max(scale_[0], scale_[1]);
  const bool strip = size_[1] > 0 && size_[1] * 12 < size_[0];
  scale_ = {smaller > 0 ? smaller : 1, strip ? scale_[1] / 3 : (smaller > 0 ? smaller : 1)};
}

Pixel Projection::operator()(const Vector3d& p) const {
  const std::array<double, 2> at{right_.dot(p - middle_), up_.dot(p - middle_)};
  const double x = frame_.left + frame_.width / 2.0 + (at[0] - low_[0] - size_[0] / 2) * scale_[0],
               y = frame_.top + frame_.height / 2.0 - (at[1] - low_[1] - size_[1] / 2) * scale_[1];
  const auto in_tenths = [](double v) {  // what lies far outside of the frame stays there
    return static_cast<int>(std::lround(10 * std::clamp(v, -2000.0, 3000.0)));
  };
  return {in_tenths(x), in_tenths(y)};
}

}  // namespace tetproof::corpus
