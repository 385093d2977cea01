// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/patches.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <Eigen/Geometry>

#include "corpus/generators/random.hpp"
#include "corpus/shrink/editable_surface.hpp"

namespace tetproof::corpus {
namespace {

using Edge = std::array<Index, 2>;

constexpr std::size_t longest_border = 200;  // the caps of longer ones take too long to find
constexpr double never = std::numeric_limits<double>::infinity();

std::vector<std::vector<Index>> triangles_at(const TriangleSurface& surface) {
  std::vector<std::vector<Index>> at(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) at[v].push_back(static_cast<Index>(t));
  return at;
}

// The borders of the marked triangles, each as its vertices in the order in which the marked triangles pass
// them. Nothing if a border passes a vertex twice.
std::optional<std::vector<std::vector<Index>>> borders(const TriangleSurface& surface,
                                                       const std::vector<std::uint8_t>& marked) {
  std::vector<Edge> others;  // the sides of the triangles that are not marked
  for (std::size_t t = 0; t < marked.size(); ++t)
    for (int c = 0; c < 3 && !marked[t]; ++c)
      others.push_back({surface.triangles[t][c], surface.triangles[t][(c + 1) % 3]});
  std::sort(others.begin(), others.end());
  std::map<Index, Index> next;
  for (std::size_t t = 0; t < marked.size(); ++t)
    for (int c = 0; c < 3 && marked[t]; ++c) {
      const Index from = surface.triangles[t][c], to = surface.triangles[t][(c + 1) % 3];
      if (!std::binary_search(others.begin(), others.end(), Edge{to, from})) continue;
      if (!next.emplace(from, to).second) return std::nullopt;
    }
  std::vector<std::vector<Index>> all;
  while (!next.empty()) {
    std::vector<Index>& border = all.emplace_back();
    for (auto step = next.begin(); step != next.end(); step = next.find(border.back())) {
      const Index to = step->second;
      if (border.empty()) border.push_back(step->first);
      next.erase(step);
      if (to == border.front()) break;
      border.push_back(to);
    }
  }
  return all;
}

// Adds the triangulation of least area of a closed polygon; false if each one needs a diagonal that `taken`
// has.
bool cap(const TriangleSurface& surface, const std::vector<Index>& polygon, const std::vector<Edge>& taken,
         std::vector<std::array<Index, 3>>& triangles) {
  const int n = static_cast<int>(polygon.size());
  if (n < 3 || polygon.size() > longest_border) return false;
  std::vector<double> least(n * n, 0);  // area of the polygon i .. j
  std::vector<int> apex(n * n, -1);
  const auto usable = [&](int i, int j) {
    if (j == i + 1 || (i == 0 && j == n - 1)) return true;
    return !std::binary_search(taken.begin(), taken.end(), Edge{polygon[i], polygon[j]});
  };
  for (int width = 2; width < n; ++width)
    for (int i = 0; i + width < n; ++i) {
      const int j = i + width;
      least[i * n + j] = never;
      if (!usable(i, j)) continue;
      for (int k = i + 1; k < j; ++k) {
        const Eigen::Vector3d &a = surface.vertices[polygon[i]], &b = surface.vertices[polygon[k]],
                              &c = surface.vertices[polygon[j]];
        const double area = least[i * n + k] + least[k * n + j] + (b - a).cross(c - a).norm();
        if (area < least[i * n + j]) least[i * n + j] = area, apex[i * n + j] = k;
      }
    }
  if (!(least[n - 1] < never)) return false;
  std::vector<std::array<int, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const int k = apex[i * n + j];
    triangles.push_back({polygon[i], polygon[k], polygon[j]});
    open.push_back({i, k});
    open.push_back({k, j});
  }
  return true;
}

// A random choice of at most `most` of the numbers below n.
std::vector<Index> choice(std::size_t n, std::size_t most, std::uint64_t seed) {
  Random random(seed);
  std::vector<Index> numbers(n);
  for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<Index>(i);
  for (std::size_t i = 0; i < std::min(n, most); ++i)
    std::swap(numbers[i], numbers[i + random.below(static_cast<int>(n - i))]);
  numbers.resize(std::min(n, most));
  return numbers;
}

}  // namespace

std::optional<TriangleSurface> replace_patch(const TriangleSurface& surface, const Patch& patch) {
  std::vector<std::uint8_t> marked(surface.triangles.size(), 0);
  for (const Index t : patch) marked[t] = 1;
  const auto loops = borders(surface, marked);
  if (!loops || loops->empty()) return std::nullopt;
  std::vector<Edge> taken;  // in both directions, as the rest is on both sides of all but its borders
  TriangleSurface result;
  result.vertices = surface.vertices;
  for (std::size_t t = 0; t < marked.size(); ++t) {
    if (marked[t]) continue;
    result.triangles.push_back(surface.triangles[t]);
    for (int c = 0; c < 3; ++c) {
      const Index a = surface.triangles[t][c], b = surface.triangles[t][(c + 1) % 3];
      taken.push_back({a, b});
      taken.push_back({b, a});
    }
  }
  std::sort(taken.begin(), taken.end());
  for (const std::vector<Index>& loop : *loops)
    if (!cap(surface, loop, taken, result.triangles)) return std::nullopt;
  if (result.triangles.size() >= surface.triangles.size()) return std::nullopt;
  return without_unused_vertices(result);
}

std::vector<Patch> balls(const TriangleSurface& surface, std::uint64_t seed) {
  constexpr std::size_t centres = 16;
  const auto at = triangles_at(surface);
  std::vector<Patch> all;
  for (const Index centre : choice(surface.vertices.size(), centres, seed)) {
    std::vector<Index> front{centre};
    std::vector<std::uint8_t> seen(surface.vertices.size(), 0), taken(surface.triangles.size(), 0);
    seen[centre] = 1;
    Patch ball;
    std::size_t last = 0;
    for (int radius = 1; !front.empty(); ++radius) {
      std::vector<Index> further;
      for (const Index v : front)
        for (const Index t : at[v]) {
          if (!taken[t]) taken[t] = 1, ball.push_back(t);
          for (const Index w : surface.triangles[t])
            if (!seen[w]) seen[w] = 1, further.push_back(w);
        }
      front = std::move(further);
      // Balls that are a third larger than the last: a finer choice costs calls and gains little.
      if (radius < 2 || 3 * ball.size() < 4 * last || ball.size() == surface.triangles.size()) continue;
      last = ball.size();
      all.push_back(ball);
    }
  }
  for (Patch& ball : all) std::sort(ball.begin(), ball.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Patch& a, const Patch& b) { return a.size() > b.size(); });
  return all;
}

std::vector<Patch> stars(const TriangleSurface& surface) {
  std::vector<Patch> all = triangles_at(surface);
  std::erase_if(all, [](const Patch& star) { return star.size() < 6; });
  return all;
}

}  // namespace tetproof::corpus
