// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/polygon.hpp"

#include <algorithm>
#include <numeric>

#include "corpus/fuzz/exact_sides.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {

std::vector<std::array<Index, 3>> cut_polygon(const std::vector<Eigen::Vector2d>& polygon) {
  std::vector<Index> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<Index, 3>> triangles;
  const auto is_ear = [&](Index a, Index b, Index c) {
    const Eigen::Vector2d &p = polygon[a], &q = polygon[b], &r = polygon[c];
    if (turn(p, q, r) <= 0) return false;
    return std::none_of(left.begin(), left.end(), [&](Index i) {
      return i != a && i != b && i != c && turn(p, q, polygon[i]) >= 0 && turn(q, r, polygon[i]) >= 0 &&
             turn(r, p, polygon[i]) >= 0;
    });
  };
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    std::size_t i = 0;
    while (i < n && !is_ear(left[(i + n - 1) % n], left[i], left[(i + 1) % n])) ++i;
    if (i == n) throw InputError("the outline crosses or touches itself");
    triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    if (n == 3) break;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

TriangleSurface prism(const std::vector<Eigen::Vector2d>& polygon, double h) {
  TriangleSurface surface;
  const Index n = static_cast<Index>(polygon.size());
  for (const double z : {0.0, h})
    for (const Eigen::Vector2d& p : polygon) surface.vertices.emplace_back(p[0], p[1], z);
  for (const auto& [a, b, c] : cut_polygon(polygon)) {
    surface.triangles.push_back({a, c, b});
    surface.triangles.push_back({n + a, n + b, n + c});
  }
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    surface.triangles.push_back({i, next, n + next});
    surface.triangles.push_back({i, n + next, n + i});
  }
  return surface;
}

}  // namespace tetproof::corpus
