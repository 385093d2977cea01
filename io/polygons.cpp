// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygons.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include "io/error.hpp"
#include "io/weld.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

// Where the fan of a planar and convex polygon starts; -1 and the reason if it is not both.
struct Fan {
  std::ptrdiff_t start = -1;
  std::string fault;
};

Fan fan_of(std::span<const Index> corners, const std::vector<Vector3d>& points) {
  const auto n = static_cast<std::ptrdiff_t>(corners.size());
  const auto point = [&](std::ptrdiff_t i) -> const Vector3d& { return points[corners[(i + n) % n]]; };

  Vector3d low = point(0), high = point(0), mean = Vector3d::Zero();
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    low = low.cwiseMin(point(i)), high = high.cwiseMax(point(i));
    mean += (point(i) - point(0)) / n;
  }
  mean += point(0);
  const double size = (high - low).norm();
  const double tolerance = std::max(1e-4 * size, 1e-6 * low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff());
  if (!std::isfinite(size)) return {-1, "has a coordinate that is not finite or too large"};

  Vector3d normal =
      Vector3d::Zero();  // Newell's, in units of the polygon's size so that nothing under- or overflows
  for (std::ptrdiff_t i = 0; i < n; ++i)
    normal += ((point(i) - mean) / size).cross((point(i + 1) - mean) / size);
  if (normal.norm() < 1e-9) {  // no area: harmless if it is a line, a figure of eight otherwise
    Vector3d along = Vector3d::Zero();
    for (std::ptrdiff_t i = 1; i < n; ++i)
      if ((point(i) - point(0)).norm() > along.norm()) along = point(i) - point(0);
    along /= size;
    along.normalize();
    for (std::ptrdiff_t i = 1; i < n; ++i)
      if (((point(i) - point(0)) / size).cross(along).norm() * size > tolerance)
        return {-1, "is not convex: it crosses itself"};
    return {0, {}};
  }
  normal.normalize();
  double off = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) off = std::max(off, std::abs(normal.dot(point(i) - mean)));
  if (!(off <= tolerance))
    return {-1,
            fmt::format("is not planar: a corner is {:.3g} off its plane, allowed {:.3g}", off, tolerance)};

  // How far each corner lies outwards of the line through its neighbours, and how much it turns.
  std::vector<double> outwards(n);
  double turned = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vector3d before = (point(i) - point(i - 1)) / size, after = (point(i + 1) - point(i)) / size;
    const double cross = normal.dot(before.cross(after));
    const double chord = (before + after).norm();
    outwards[i] = chord > 0 ? cross / chord * size : 0;
    turned += std::atan2(cross, before.dot(after));
    if (outwards[i] < -tolerance)
      return {-1, fmt::format("is not convex: it turns inwards at corner {}", i + 1)};
  }
  if (turned > 3 * std::numbers::pi) return {-1, "is not convex: it winds more than once around"};

  std::ptrdiff_t start = 0;
  double best = -1;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double least = std::min(outwards[(i + n - 1) % n], outwards[(i + 1) % n]);
    if (least > best) best = least, start = i;
    if (least > tolerance) break;
  }
  const Vector3d& apex = point(start);
  for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
    const Vector3d a = (point(start + i) - apex) / size, b = (point(start + i + 1) - apex) / size;
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    if (normal.dot(a.cross(b)) * size < -tolerance * longest) return {-1, "is not convex"};
  }
  return {start, {}};
}

[[noreturn]] void fail(const Polygons& polygons, std::size_t polygon, const InputFile& file,
                       const std::string& message) {
  const Scanner place(file.path(), file.bytes(), polygons.places[polygon]);
  if (polygons.text) place.fail_in_line(message);
  place.fail_at_byte(message);
}

}  // namespace

TriangleSurface triangulate(Polygons polygons, const InputFile& file) {
  TriangleSurface surface;
  const auto points_in_file = static_cast<std::int64_t>(polygons.points.size());
  if (points_in_file > std::numeric_limits<Index>::max())
    throw InputError(
        fmt::format("{}: {} points, at most 2147483647 can be numbered", file.path(), points_in_file));
  const std::vector<Index> moved = weld(polygons.points);
  surface.vertices = std::move(polygons.points);
  surface.triangles.reserve(polygons.corners.size() -
                            std::min(polygons.corners.size(), 2 * polygons.ends.size()));

  std::vector<Index> corners;
  std::size_t begin = 0;
  for (std::size_t polygon = 0; polygon < polygons.ends.size(); begin = polygons.ends[polygon++]) {
    const std::span<const Index> named(&polygons.corners[begin], polygons.ends[polygon] - begin);
    if (named.size() < 3)
      fail(polygons, polygon, file, fmt::format("face has {} corners, expected at least 3", named.size()));
    corners.clear();
    for (const Index corner : named) {
      if (corner < 0 || corner >= points_in_file)
        fail(polygons, polygon, file,
             fmt::format("face names vertex {}, expected one of the file's {}", corner + polygons.first,
                         points_in_file) +
                 (points_in_file
                      ? fmt::format(", {} to {}", polygons.first, polygons.first + points_in_file - 1)
                      : ""));
      corners.push_back(moved[corner]);
    }
    if (corners.size() == 3) {
      surface.triangles.push_back({corners[0], corners[1], corners[2]});
      continue;
    }
    const std::array<Index, 3> collapsed{corners[0], corners[1], corners[2]};
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    const auto n = static_cast<std::ptrdiff_t>(corners.size());
    if (n < 3) {
      surface.triangles.push_back(collapsed);
      continue;
    }
    std::ptrdiff_t start = 0;
    if (n > 3) {
      const Fan fan = fan_of(corners, surface.vertices);
      if (fan.start < 0)
        fail(polygons, polygon, file,
             fmt::format("face with {} corners {}; cut it into triangles", named.size(), fan.fault));
      start = fan.start;
    }
    for (std::ptrdiff_t i = 1; i + 1 < n; ++i)
      surface.triangles.push_back({corners[start], corners[(start + i) % n], corners[(start + i + 1) % n]});
  }
  return surface;
}

}  // namespace tetproof::io
