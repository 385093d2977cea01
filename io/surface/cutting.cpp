// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/cutting.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "io/bytes/words.hpp"
#include "io/surface/constrained.hpp"
#include "io/surface/planar_cut.hpp"
#include "io/surface/polygons.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Index, 3>;

Vector3d normal_of(const Triangle& t, const std::vector<Vector3d>& points) {
  const auto p = [&](std::size_t k) -> const Vector3d& { return points[static_cast<std::size_t>(t[k])]; };
  Vector3d a = p(1) - p(0), b = p(2) - p(0);
  const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  if (size > 0) a /= size, b /= size;  // the products may under- or overflow
  return a.cross(b);
}

// The largest angle between neighbours [degrees]; of corners that are all on lines: 0.
double largest_bend(const std::vector<Triangle>& triangles, const std::vector<Vector3d>& points) {
  std::map<std::array<Index, 2>, Vector3d> normals;  // by directed side
  double largest = 0;
  for (const Triangle& t : triangles) {
    const Vector3d n = normal_of(t, points);
    for (std::size_t k = 0; k < 3; ++k) {
      normals[{t[k], t[(k + 1) % 3]}] = n;
      const auto other = normals.find({t[(k + 1) % 3], t[k]});
      if (other == normals.end() || n.isZero(0) || other->second.isZero(0)) continue;
      largest = std::max(largest, std::atan2(n.cross(other->second).norm(), n.dot(other->second)));
    }
  }
  return largest * 180 / std::numbers::pi;
}

// The two triangles of a quadrangle at the diagonal from corner `from`, 0 or 1.
std::array<Triangle, 2> halves(std::span<const Index> c, std::size_t from) {
  return from == 0 ? std::array{Triangle{c[0], c[1], c[2]}, Triangle{c[0], c[2], c[3]}}
                   : std::array{Triangle{c[1], c[2], c[3]}, Triangle{c[1], c[3], c[0]}};
}

void cut_bent_quadrangle(std::span<const Index> c, const std::vector<Vector3d>& points,
                         const Vector3d& normal, Cut& cut) {
  const auto folds = [&](std::size_t from) {
    const auto both = halves(c, from);
    return !(normal_of(both[0], points).dot(normal) > 0 && normal_of(both[1], points).dot(normal) > 0);
  };
  if (folds(0) && folds(1)) {
    cut.fault = "crosses itself";
    return;
  }
  const auto p = [&](std::size_t k) -> const Vector3d& { return points[static_cast<std::size_t>(c[k])]; };
  const int longer = compare_lengths(p(0), p(2), p(1), p(3));
  const bool second =
      folds(0) || (!folds(1) && (longer > 0 || (longer == 0 && std::min(c[1], c[3]) < std::min(c[0], c[2]))));
  for (const Triangle& half : halves(c, second ? 1 : 0)) cut.triangles.push_back(half);
  cut.bend = largest_bend(cut.triangles, points);
}

// Newell's normal; its length is twice the area, in units of `size`, which keeps the products in range.
Vector3d area_of(std::span<const Index> corners, const std::vector<Vector3d>& points, double size) {
  Vector3d area = Vector3d::Zero();
  const auto from_first = [&](std::size_t k) -> Vector3d {
    return (points[static_cast<std::size_t>(corners[k % corners.size()])] -
            points[static_cast<std::size_t>(corners[0])]) /
           size;
  };
  for (std::size_t k = 0; k < corners.size(); ++k) area += from_first(k).cross(from_first(k + 1));
  return area;
}

}  // namespace

void cut_polygon(std::span<const Index> corners, const std::vector<Vector3d>& points, Cut& cut) {
  cut.triangles.clear();
  cut.bend = 0;
  cut.fault.clear();
  const std::size_t n = corners.size();
  if (n == 3) {
    cut.triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  Fan fan = fan_of(corners, points);
  if (fan.shape == Fan::Shape::convex) {
    for (std::size_t i = 1; i + 1 < n; ++i)
      cut.triangles.push_back(
          {corners[fan.start], corners[(fan.start + i) % n], corners[(fan.start + i + 1) % n]});
    return;
  }
  if (fan.shape == Fan::Shape::broken) {
    cut.fault = std::move(fan.fault);
    return;
  }
  const bool bent = fan.shape == Fan::Shape::bent;
  if (bent && n == 4) return cut_bent_quadrangle(corners, points, fan.normal, cut);
  const PlanarFacet facet{.polygons = {corners}, .holes = {}, .odd = true};
  cut.fault = cut_planar(facet, points, fan.normal, cut.triangles);
  if (bent) cut.bend = largest_bend(cut.triangles, points);
}

void cut_facet(std::span<const std::span<const Index>> polygons, std::span<const Vector3d> holes,
               const std::vector<Vector3d>& points, Cut& cut) {
  cut.triangles.clear();
  cut.bend = 0;
  cut.fault.clear();
  std::vector<Index> corners;  // of all polygons
  for (const auto& polygon : polygons) corners.insert(corners.end(), polygon.begin(), polygon.end());
  if (corners.empty()) return;
  Vector3d low = points[static_cast<std::size_t>(corners[0])], high = low;
  for (const Index corner : corners) {
    const Vector3d& point = points[static_cast<std::size_t>(corner)];
    if (!point.allFinite()) low[0] = -std::numeric_limits<double>::infinity();
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).stableNorm(), tolerance = planar_tolerance(low, high);
  if (!std::isfinite(size)) {
    cut.fault = "has a coordinate that is not finite or too large";
    return;
  }
  Vector3d normal = Vector3d::Zero();
  for (const auto& polygon : polygons) {
    if (polygon.size() < 3 || size == 0) continue;
    if (const Vector3d area = area_of(polygon, points, size); area.norm() > normal.norm()) normal = area;
  }
  if (normal.norm() < 1e-9) return;  // no area, as in `fan_of`
  normal.normalize();
  double least = 0, most = 0;
  for (const Index corner : corners) {
    const double off =
        normal.dot(points[static_cast<std::size_t>(corner)] - points[static_cast<std::size_t>(corners[0])]);
    least = std::min(least, off), most = std::max(most, off);
  }
  PlanarFacet facet{.polygons = {polygons.begin(), polygons.end()}, .holes = holes, .odd = false};
  cut.fault = cut_planar(facet, points, normal, cut.triangles);
  if (most - least > 2 * tolerance) cut.bend = largest_bend(cut.triangles, points);
}

std::string Bends::text() const {
  std::string text;
  if (quadrangles > 0)
    text += fmt::format(
        "{} not planar: cut along the shorter diagonal; ",
        quadrangles == 1 ? std::string("1 quadrangle is") : fmt::format("{} quadrangles are", quadrangles));
  if (polygons > 0)
    text +=
        fmt::format("{} not planar: cut as seen along the axis next to the normal; ",
                    polygons == 1 ? std::string("1 polygon is") : fmt::format("{} polygons are", polygons));
  return text.empty() ? text : text + fmt::format("the largest bend is {:.3g} degrees", largest);
}

Facets::Facets(const Document& document) : document_(document) {
  for (const Facet& facet : document.facets)
    if (facet.polygons > 0) sorted_.push_back(&facet);
  std::sort(sorted_.begin(), sorted_.end(),
            [](const Facet* a, const Facet* b) { return a->first < b->first; });
}

const Facet* Facets::of(std::size_t element) const {
  const auto next = std::upper_bound(sorted_.begin(), sorted_.end(), element,
                                     [](std::size_t e, const Facet* facet) { return e < facet->first; });
  if (next == sorted_.begin()) return nullptr;
  const Facet* facet = *std::prev(next);
  return element - facet->first < facet->polygons ? facet : nullptr;
}

bool Facets::any_in(std::size_t first, std::size_t count) const {
  const auto next = std::lower_bound(sorted_.begin(), sorted_.end(), first + count,
                                     [](const Facet* facet, std::size_t end) { return facet->first < end; });
  if (next == sorted_.begin() || count == 0) return false;
  const Facet& last = **std::prev(next);
  return first < last.first + last.polygons;
}

void Facets::cut(const Facet& facet, const std::vector<Index>& moved, const std::vector<Vector3d>& points,
                 Cut& cut) const {
  std::vector<Index> nodes;
  std::vector<std::size_t> sizes;
  const std::size_t behind = facet.first + facet.polygons;
  auto at = std::upper_bound(document_.blocks.begin(), document_.blocks.end(), facet.first,
                             [](std::size_t e, const ElementBlock& block) { return e < block.first; });
  if (at != document_.blocks.begin()) --at;
  for (; at != document_.blocks.end() && at->first < behind; ++at) {
    const ElementBlock& block = *at;
    const std::size_t begin = std::max(block.first, facet.first),
                      end = std::min(block.first + block.count, behind);
    for (std::size_t e = begin; e < end; ++e) {
      const Index* node = document_.connectivity.data() + block.nodes +
                          (e - block.first) * static_cast<std::size_t>(block.nodes_each);
      for (std::int32_t k = 0; k < block.nodes_each; ++k) {
        if (node[k] < 0) {
          cut.triangles.clear();
          cut.fault = fmt::format("names node {}, which does not exist", document_.named(node[k]));
          return;
        }
        nodes.push_back(moved.empty() ? node[k] : moved[static_cast<std::size_t>(node[k])]);
      }
      sizes.push_back(static_cast<std::size_t>(block.nodes_each));
    }
  }
  std::vector<std::span<const Index>> polygons;
  const Index* from = nodes.data();
  for (const std::size_t size : sizes) {
    if (size > 0) polygons.emplace_back(from, size);
    from += size;
  }
  cut_facet(polygons, facet.holes, points, cut);
}

}  // namespace tetproof::io
