// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/polygons.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/model/weld.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

}  // namespace

Fan fan_of(std::span<const Index> corners, const std::vector<Vector3d>& points) {
  const auto n = static_cast<std::ptrdiff_t>(corners.size());
  const auto point = [&](std::ptrdiff_t i) -> const Vector3d& { return points[corners[(i + n) % n]]; };

  Vector3d low = point(0), high = point(0), mean = Vector3d::Zero();
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    low = low.cwiseMin(point(i)), high = high.cwiseMax(point(i));
    mean += (point(i) - point(0)) / n;
  }
  mean += point(0);
  const double size = (high - low).stableNorm();  // its squares may under- or overflow
  const double tolerance = std::max(1e-4 * size, 1e-6 * low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff());
  if (!std::isfinite(size) || !mean.allFinite())
    return {-1, "has a coordinate that is not finite or too large"};

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
  double backwards = 0;  // area of the fan's triangles that turn the wrong way
  for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
    const Vector3d a = (point(start + i) - apex) / size, b = (point(start + i + 1) - apex) / size;
    backwards -= std::min(0.0, normal.dot(a.cross(b)) / 2);
  }
  if (backwards * size > tolerance) return {-1, "is not convex"};
  return {start, {}};
}

namespace {

// Welds the points and cuts faces as they come.
class Faces {
 public:
  Faces(const InputFile& file, SurfaceDocument& source) : file_(file), source_(source) {
    const std::size_t points = source.document.points.size();
    if (source.welded)
      surface_.vertices = std::move(source.document.points);
    else {
      moved_ = weld(source.document.points);
      surface_.vertices = std::move(source.document.points);
    }
    points_ = static_cast<std::int64_t>(points);
  }

  TriangleSurface take() {
    const Document& document = source_.document;
    std::size_t triangles = 0;
    for (const ElementBlock& block : document.blocks)
      if (block.dim == 2) triangles += block.count * static_cast<std::size_t>(block.nodes_each - 2);
    reserve_in_large_pages(surface_.triangles, triangles);
    for (const ElementBlock& block : document.blocks) {
      const bool face = block.dim == 2;
      if (!face && document.format != "off") continue;
      const Index* node = document.connectivity.data() + block.nodes;
      for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
        add({node, static_cast<std::size_t>(block.nodes_each)}, source_.places[block.first + e]);
    }
    return std::move(surface_);
  }

 private:
  void add(std::span<const Index> face, std::size_t place);
  [[noreturn]] void fail(std::size_t place, const std::string& message) const {
    const Scanner scanner(file_.path(), file_.bytes(), place);
    if (source_.text) scanner.fail_in_line(message);
    scanner.fail_at_byte(message);
  }

  const InputFile& file_;
  SurfaceDocument& source_;
  std::int64_t points_ = 0;
  std::vector<Index> moved_;    // where welding put each point; empty: nowhere else
  std::vector<Index> corners_;  // of the face at hand
  TriangleSurface surface_;
};

void Faces::add(std::span<const Index> face, std::size_t place) {
  if (face.size() == 3 && face[0] >= 0 && face[1] >= 0 && face[2] >= 0) {  // nearly all are
    const auto at = [&](Index i) { return moved_.empty() ? i : moved_[static_cast<std::size_t>(i)]; };
    surface_.triangles.push_back({at(face[0]), at(face[1]), at(face[2])});
    return;
  }
  if (face.size() < 3) fail(place, fmt::format("face has {} corners, expected at least 3", face.size()));
  corners_.clear();
  for (const Index corner : face) {
    if (corner < 0) {
      const std::int64_t named = source_.document.unknown[static_cast<std::size_t>(-1 - corner)];
      const std::int64_t first = source_.document.first_node;
      fail(place, points_ == 0 ? fmt::format("face names vertex {}, but there are no vertices", named)
                               : fmt::format("face names vertex {}, expected {} to {}", named, first,
                                             points_ - 1 + first));
    }
    corners_.push_back(moved_.empty() ? corner : moved_[static_cast<std::size_t>(corner)]);
  }
  auto& triangles = surface_.triangles;
  const std::array<Index, 3> as_named{corners_[0], corners_[1], corners_[2]};
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
  const std::size_t n = corners_.size();
  if (n < 3) {
    triangles.push_back(as_named);
    return;
  }
  std::size_t start = 0;
  if (n > 3) {
    const Fan fan = fan_of(corners_, surface_.vertices);
    if (fan.start < 0)
      fail(place, fmt::format("face with {} corners {}; cut it into triangles", face.size(), fan.fault));
    start = fan.start;
  }
  for (std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({corners_[start], corners_[(start + i) % n], corners_[(start + i + 1) % n]});
}

}  // namespace

TriangleSurface surface_of_faces(const InputFile& file, SurfaceDocument source) {
  return Faces(file, source).take();
}

}  // namespace tetproof::io
