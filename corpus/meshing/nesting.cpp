// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a surface by exact predicates: a point is inside a closed part if a segment from it to a place
// outside crosses an odd number of the part's triangles.
#include "corpus/meshing/nesting.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tetproof::corpus {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Eigen::Vector3d;

enum class Place { outside, inside, on };

Point exact(const Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}
int side(const Point& a, const Point& b, const Point& c, const Point& d) {
  return static_cast<int>(CGAL::orientation(a, b, c, d));
}

enum class Crossing { none, one, touches_start, unclear };

/// How the segment from p to q meets the triangle. Unclear: through an edge, or in the triangle's plane.
Crossing crossing(const Point& p, const Point& q, const std::array<Point, 3>& t) {
  const int start = side(t[0], t[1], t[2], p), end = side(t[0], t[1], t[2], q);
  if (start == end) return start == 0 ? Crossing::unclear : Crossing::none;
  bool left = false, right = false, edge = false;
  for (int k = 0; k < 3; ++k) {
    const int s = side(p, q, t[k], t[(k + 1) % 3]);
    left |= s > 0;
    right |= s < 0;
    edge |= s == 0;
  }
  if (left && right) return Crossing::none;
  if (start == 0) return Crossing::touches_start;
  return edge || end == 0 ? Crossing::unclear : Crossing::one;
}

/// One part, with its box.
struct Part {
  std::vector<std::array<Point, 3>> triangles;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = Vector3d::Constant(-std::numeric_limits<double>::infinity());
};

std::vector<Part> split(const TriangleSurface& surface, const Nesting& nesting) {
  std::vector<Part> parts(nesting.parent.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    Part& part = parts[static_cast<std::size_t>(nesting.part_of_triangle[i])];
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& v = surface.vertices[static_cast<std::size_t>(surface.triangles[i][k])];
      corners[k] = exact(v);
      part.low = part.low.cwiseMin(v);
      part.high = part.high.cwiseMax(v);
    }
    part.triangles.push_back(corners);
  }
  return parts;
}

/// Where the point is. Absent if 60 segments all met an edge, which no closed surface of few triangles does.
std::optional<Place> place(const Vector3d& point, const Part& part) {
  if ((point.array() < part.low.array()).any() || (point.array() > part.high.array()).any())
    return Place::outside;
  const Vector3d size = (part.high - part.low).cwiseMax(part.high.cwiseAbs() * 1e-9);
  std::uint64_t random = 1;
  for (int attempt = 0; attempt < 60; ++attempt) {
    Vector3d target;
    for (int k = 0; k < 3; ++k) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      target[k] = part.low[k] + size[k] * (static_cast<double>(random >> 40) / (1 << 24));
    }
    target[attempt % 3] = part.high[attempt % 3] + size[attempt % 3];
    bool odd = false, unclear = false;
    for (const auto& triangle : part.triangles) {
      const Crossing found = crossing(exact(point), exact(target), triangle);
      if (found == Crossing::touches_start) return Place::on;
      unclear |= found == Crossing::unclear;
      odd ^= found == Crossing::one;
    }
    if (!unclear) return odd ? Place::inside : Place::outside;
  }
  return std::nullopt;
}

/// Distance from `from` along `direction` to the nearest triangle other than `except`, in doubles; 0: none.
double free_way(const TriangleSurface& surface, const Vector3d& from, const Vector3d& direction,
                std::size_t except) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (i == except) continue;
    const auto corner = [&](std::size_t k) -> const Vector3d& {
      return surface.vertices[static_cast<std::size_t>(surface.triangles[i][k])];
    };
    const Vector3d u = corner(1) - corner(0), v = corner(2) - corner(0), h = direction.cross(v);
    const double determinant = u.dot(h);
    if (determinant == 0) continue;
    const Vector3d s = from - corner(0), q = s.cross(u);
    const double a = s.dot(h) / determinant, b = direction.dot(q) / determinant;
    const double way = v.dot(q) / determinant;
    if (a >= 0 && b >= 0 && a + b <= 1 && way > 0) nearest = std::min(nearest, way);
  }
  return std::isfinite(nearest) ? nearest : 0;
}

}  // namespace

Nesting nesting(const TriangleSurface& surface) {
  std::vector<std::size_t> root(surface.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&root](Index vertex) {
    auto i = static_cast<std::size_t>(vertex);
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : surface.triangles) {
    root[find(t[1])] = find(t[0]);
    root[find(t[2])] = find(t[0]);
  }
  Nesting result;
  std::vector<int> number(root.size(), -1);
  std::vector<Index> vertex;  // one of each part
  for (const auto& t : surface.triangles) {
    int& part = number[find(t[0])];
    if (part < 0) {
      part = static_cast<int>(vertex.size());
      vertex.push_back(t[0]);
    }
    result.part_of_triangle.push_back(part);
  }
  const std::size_t parts = vertex.size();
  result.parent.assign(parts, -1);
  result.depth.assign(parts, 0);
  if (parts < 2) return result;

  const std::vector<Part> all = split(surface, result);
  std::vector<std::vector<int>> around(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    for (std::size_t k = 0; k < parts; ++k)
      if (i != k && place(surface.vertices[static_cast<std::size_t>(vertex[i])], all[k]) == Place::inside)
        around[i].push_back(static_cast<int>(k));
    result.depth[i] = static_cast<int>(around[i].size());
  }
  for (std::size_t i = 0; i < parts;
       ++i)  // the parts around a part lie in each other: the innermost is deepest
    for (const int k : around[i])
      if (result.parent[i] < 0 || result.depth[static_cast<std::size_t>(k)] >
                                      result.depth[static_cast<std::size_t>(result.parent[i])])
        result.parent[i] = k;
  return result;
}

std::optional<Vector3d> point_in(const TriangleSurface& surface, const Nesting& nesting, int part) {
  const std::vector<Part> all = split(surface, nesting);
  std::vector<std::size_t> triangles;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    if (nesting.part_of_triangle[i] == part) triangles.push_back(i);
  // Points halfway from the middle of a triangle to the next triangle on either side, the widest way first.
  std::vector<std::pair<double, Vector3d>> candidates;
  const std::size_t step = std::max<std::size_t>(1, triangles.size() / 64);
  for (std::size_t i = 0; i < triangles.size(); i += step) {
    const auto& t = surface.triangles[triangles[i]];
    const Vector3d &a = surface.vertices[static_cast<std::size_t>(t[0])],
                   &b = surface.vertices[static_cast<std::size_t>(t[1])],
                   &c = surface.vertices[static_cast<std::size_t>(t[2])];
    const Vector3d normal = (b - a).cross(c - a).stableNormalized(), middle = (a + b + c) / 3;
    for (const double sign : {1.0, -1.0})
      if (const double way = free_way(surface, middle, sign * normal, triangles[i]); way > 0)
        candidates.emplace_back(way, middle + sign * way / 2 * normal);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [way, point] : candidates) {
    bool good = place(point, all[static_cast<std::size_t>(part)]) == Place::inside;
    for (int k = 0; good && k < nesting.parts(); ++k)
      if (nesting.parent[static_cast<std::size_t>(k)] == part)
        good = place(point, all[static_cast<std::size_t>(k)]) == Place::outside;
    if (good) return point;
  }
  return std::nullopt;
}

}  // namespace tetproof::corpus
