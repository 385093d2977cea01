// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/polygons.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetproof::io {

using Eigen::Vector3d;

double planar_tolerance(const Vector3d& low, const Vector3d& high) {
  const double size = (high - low).stableNorm();  // the squares may under- or overflow
  return std::max(1e-4 * size, 1e-6 * low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff());
}

Fan fan_of(std::span<const Index> corners, const std::vector<Vector3d>& points) {
  const auto n = static_cast<std::ptrdiff_t>(corners.size());
  const auto point = [&](std::ptrdiff_t i) -> const Vector3d& { return points[corners[(i + n) % n]]; };

  Vector3d low = point(0), high = point(0), mean = Vector3d::Zero();
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    low = low.cwiseMin(point(i)), high = high.cwiseMax(point(i));
    mean += (point(i) - point(0)) / n;
  }
  mean += point(0);
  const double size = (high - low).stableNorm(), tolerance = planar_tolerance(low, high);
  if (!std::isfinite(size) || !mean.allFinite())
    return {.shape = Fan::Shape::broken, .fault = "has a coordinate that is not finite or too large"};

  Vector3d normal = Vector3d::Zero();  // Newell's; in units of the polygon's size, as all products below
  for (std::ptrdiff_t i = 0; i < n; ++i)
    normal += ((point(i) - mean) / size).cross((point(i + 1) - mean) / size);
  if (normal.norm() < 1e-9) {  // no area: harmless if it is a line, a figure of eight otherwise
    Vector3d along = Vector3d::Zero();
    for (std::ptrdiff_t i = 1; i < n; ++i)
      if (((point(i) - point(0)) / size).norm() > along.norm()) along = (point(i) - point(0)) / size;
    along.normalize();
    for (std::ptrdiff_t i = 1; i < n; ++i)
      if (((point(i) - point(0)) / size).cross(along).norm() * size > tolerance)
        return {.shape = Fan::Shape::broken, .fault = "crosses itself"};
    return {};
  }
  normal.normalize();
  double off = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) off = std::max(off, std::abs(normal.dot(point(i) - mean)));
  if (!(off <= tolerance)) return {.shape = Fan::Shape::bent, .normal = normal};
  const Fan concave{.shape = Fan::Shape::concave, .normal = normal};

  // The distance of each corner outwards of the line through its neighbours, and the sum of the turns.
  std::vector<double> outwards(n);
  double turned = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vector3d before = (point(i) - point(i - 1)) / size, after = (point(i + 1) - point(i)) / size;
    const double cross = normal.dot(before.cross(after));
    const double chord = (before + after).norm();
    outwards[i] = chord > 0 ? cross / chord * size : 0;
    turned += std::atan2(cross, before.dot(after));
    if (outwards[i] < -tolerance) return concave;
  }
  if (turned > 3 * std::numbers::pi) return concave;

  std::ptrdiff_t start = 0;
  double best = -1;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double least = std::min(outwards[(i + n - 1) % n], outwards[(i + 1) % n]);
    if (least > best) best = least, start = i;
    if (least > tolerance) break;
  }
  const Vector3d& apex = point(start);
  double backwards = 0;  // area of the fan's triangles that turn the wrong way
  for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
    const Vector3d a = (point(start + i) - apex) / size, b = (point(start + i + 1) - apex) / size;
    backwards -= std::min(0.0, normal.dot(a.cross(b)) / 2);
  }
  if (backwards * size > tolerance) return concave;
  return {.start = static_cast<std::size_t>(start), .normal = normal};
}

}  // namespace tetproof::io
