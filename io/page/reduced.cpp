// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/page/reduced.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace tetproof::io {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Index, 3>;

// The cells along each axis. Cubes of a size of 1 / cells of the longest side.
ReducedTriangles by_cells(std::span<const Vector3d> points, std::span<const Triangle> triangles,
                          const Vector3d& low, double side, int cells) {
  // The cell of each point that is used, in one number. Halves first: the box of the largest doubles is wider
  // than doubles can say.
  std::vector<std::uint64_t> cell(points.size(), 0);
  std::vector<std::uint8_t> used(points.size(), 0);
  std::vector<Index> order;
  for (const Triangle& t : triangles)
    for (const Index v : t)
      if (!used[static_cast<std::size_t>(v)]) {
        used[static_cast<std::size_t>(v)] = 1;
        order.push_back(v);
        for (int k = 0; k < 3; ++k) {
          const double at = (points[static_cast<std::size_t>(v)][k] / 2 - low[k]) / side * cells;
          const auto whole = static_cast<std::uint64_t>(std::clamp(at, 0.0, static_cast<double>(cells)));
          cell[static_cast<std::size_t>(v)] = cell[static_cast<std::size_t>(v)] << 21 | whole;
        }
      }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(cell[static_cast<std::size_t>(a)], a) < std::pair(cell[static_cast<std::size_t>(b)], b);
  });
  std::vector<Index> first(points.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same =
        i > 0 && cell[static_cast<std::size_t>(order[i])] == cell[static_cast<std::size_t>(order[i - 1])];
    first[static_cast<std::size_t>(order[i])] =
        same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  struct Kept {
    Triangle sorted;
    std::size_t from;
  };
  std::vector<Kept> kept;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = first[static_cast<std::size_t>(triangles[i][k])];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::sort(t.begin(), t.end());
    kept.push_back({t, i});
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
    return std::tie(a.sorted, a.from) < std::tie(b.sorted, b.from);
  });
  kept.erase(std::unique(kept.begin(), kept.end(),
                         [](const Kept& a, const Kept& b) { return a.sorted == b.sorted; }),
             kept.end());
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.from < b.from; });
  ReducedTriangles result{.triangles = {}, .from = {}, .cell = side / cells * 2};
  for (const Kept& k : kept) {
    Triangle t;  // wound as it was
    for (std::size_t c = 0; c < 3; ++c) t[c] = first[static_cast<std::size_t>(triangles[k.from][c])];
    result.triangles.push_back(t);
    result.from.push_back(k.from);
  }
  return result;
}

}  // namespace

ReducedTriangles reduced(std::span<const Vector3d> points, std::span<const Triangle> triangles,
                         std::size_t most) {
  ReducedTriangles all{.triangles = {triangles.begin(), triangles.end()}, .from = {}, .cell = 0};
  all.from.resize(triangles.size());
  std::iota(all.from.begin(), all.from.end(), std::size_t{0});
  if (triangles.size() <= most) return all;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Triangle& t : triangles)
    for (const Index v : t) {
      low = low.cwiseMin(points[static_cast<std::size_t>(v)] / 2);
      high = high.cwiseMax(points[static_cast<std::size_t>(v)] / 2);
    }
  const double side = (high - low).maxCoeff();
  if (!(side > 0)) return all;
  // A surface of a box has about 2 * 6 * cells^2 triangles where points fill the cells.
  const double guess = std::sqrt(static_cast<double>(most) / 4);
  for (int cells = static_cast<int>(std::clamp(guess, 1.0, 2e6));; cells = std::max(1, cells * 4 / 5)) {
    ReducedTriangles fewer = by_cells(points, triangles, low, side, cells);
    if (fewer.triangles.size() <= most || cells == 1) return fewer;
  }
}

}  // namespace tetproof::io
