// SPDX-License-Identifier: GPL-3.0-or-later
#include "facet_cover.hpp"

#include <algorithm>
#include <cmath>

namespace tetproof::test {
namespace {

// The coordinates across an axis.
std::array<Eigen::Index, 2> across(std::size_t axis) {
  return {static_cast<Eigen::Index>((axis + 1) % 3), static_cast<Eigen::Index>((axis + 2) % 3)};
}

bool repeats(std::vector<Index> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

}  // namespace

FacetCover::FacetCover(const Document& document, const std::vector<Element>& elements, const Facet& facet)
    : document_(document) {
  const auto polygons = std::span(elements).subspan(facet.first, facet.polygons);
  long double best = 0;
  for (const Element& polygon : polygons) {
    const std::size_t n = polygon.nodes.size();
    corners_.insert(polygon.nodes.begin(), polygon.nodes.end());
    for (std::size_t k = 0; k < n; ++k) sides_.emplace_back(polygon.nodes[k], polygon.nodes[(k + 1) % n]);
    if (n < 3 || polygon.names_unknown()) continue;
    const std::array<long double, 3> normal{area(polygon.nodes, 0), area(polygon.nodes, 1),
                                            area(polygon.nodes, 2)};
    const long double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > best)) continue;
    best = length;
    const auto shorter = [](long double x, long double y) { return std::abs(x) < std::abs(y); };
    axis_ =
        static_cast<std::size_t>(std::max_element(normal.begin(), normal.end(), shorter) - normal.begin());
    largest_ = normal[axis_];
  }
  if (corners_.empty() || *corners_.begin() < 0) largest_ = 0;
  if (largest_ == 0 || hole_is_near(facet)) return;
  for (const Element& polygon : polygons)
    if (polygon.nodes.size() >= 3 && !repeats(polygon.nodes) && area(polygon.nodes, axis_) != 0)
      always_covered_.insert(polygon.nodes.begin(), polygon.nodes.end());
}

bool FacetCover::may_be(std::span<const std::array<Index, 3>> triangles) const {
  if (largest_ == 0) return false;
  std::set<Index> met;
  std::set<Side> run;
  for (const auto& t : triangles) {
    met.insert(t.begin(), t.end());
    if (const long double turn = area(t, axis_); turn != 0 && (turn > 0) != (largest_ > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == t[(k + 1) % 3] || corners_.count(t[k]) == 0 || !run.insert({t[k], t[(k + 1) % 3]}).second)
        return false;
  }
  if (!std::includes(met.begin(), met.end(), always_covered_.begin(), always_covered_.end())) return false;
  return std::all_of(run.begin(), run.end(), [&](const Side& side) {
    return run.count({side.second, side.first}) > 0 ||
           std::any_of(sides_.begin(), sides_.end(), [&](const Side& whole) {
             return is_on(side.first, whole) && is_on(side.second, whole);
           });
  });
}

// Twice the area as seen along an axis; 0 if rounding may decide its sign. Products of doubles are in the
// range of a long double.
long double FacetCover::area(std::span<const Index> corners, std::size_t axis) const {
  const auto [u, v] = across(axis);
  const auto from_first = [&](std::size_t k, Eigen::Index i) -> long double {
    const auto x = [&](std::size_t c) -> long double {
      return document_.points[static_cast<std::size_t>(corners[c % corners.size()])][i];
    };
    return x(k) - x(0);
  };
  long double sum = 0, terms = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const long double one = from_first(k, u) * from_first(k + 1, v),
                      other = from_first(k, v) * from_first(k + 1, u);
    sum += one - other, terms += std::abs(one) + std::abs(other);
  }
  return std::abs(sum) > 1e-9L * terms ? sum : 0;
}

bool FacetCover::hole_is_near(const Facet& facet) const {
  return std::any_of(facet.holes.begin(), facet.holes.end(), [&](const Eigen::Vector3d& hole) {
    const auto axes = across(axis_);
    return std::all_of(axes.begin(), axes.end(), [&](Eigen::Index k) {
      const auto x = [&](Index i) { return document_.points[static_cast<std::size_t>(i)][k]; };
      return std::any_of(corners_.begin(), corners_.end(), [&](Index i) { return x(i) <= hole[k]; }) &&
             std::any_of(corners_.begin(), corners_.end(), [&](Index i) { return x(i) >= hole[k]; });
    });
  });
}

// Whether a node is an end of a side, or lies on its line as it is seen.
bool FacetCover::is_on(Index node, const Side& side) const {
  return node == side.first || node == side.second ||
         area(std::array{side.first, side.second, node}, axis_) == 0;
}

}  // namespace tetproof::test
