// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/distance/triangle_tree.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "io/bytes/large_pages.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t leaf_size = 3;
constexpr std::size_t largest_slab = 256;  // a patch of more triangles is hardly ever nearly plane

// The number of inner nodes of a tree of n triangles, halved in the same way as in `split`.
std::size_t inner_nodes(std::size_t n) {
  if (n <= leaf_size) return 0;
  return 1 + inner_nodes(n / 2) + inner_nodes(n - n / 2);
}

}  // namespace

Units units_of(std::span<const TriangleSet> sets) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(INFINITY), high = -low;
  for (const TriangleSet& set : sets)
    for (const Triangle& t : set.triangles)
      for (const Index v : t) {
        low = low.cwiseMin(set.points[static_cast<std::size_t>(v)]);
        high = high.cwiseMax(set.points[static_cast<std::size_t>(v)]);
      }
  Units units;
  if (!(low.array() <= high.array()).all()) return units;
  units.diagonal = (high - low).stableNorm();
  if (!std::isnormal(units.diagonal) || units.diagonal > std::numeric_limits<double>::max() / 4 ||
      units.diagonal < std::numeric_limits<double>::min() * 0x1p60)
    return units;
  units.origin = low / 2 + high / 2;
  int exponent;
  std::frexp(units.diagonal, &exponent);
  units.scale = std::ldexp(1.0, exponent);
  units.usable = true;
  return units;
}

TriangleTree::TriangleTree(TriangleSet set, const Units& units) : set_(set), units_(units) {
  const std::size_t n = set.triangles.size();
  if (n == 0) return;
  std::vector<Item> items(n);
  std::vector<std::uint8_t> excluded(n, 0);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t t) {
    const auto& [a, b, c] = set.triangles[t];
    const auto [p, q, r] = corners(static_cast<Index>(t));
    items[t] = {(p + q + r) / 3, static_cast<Index>(t)};
    excluded[t] = a == b || b == c || c == a;
  });
  io::resize_in_large_pages(nodes_, std::max<std::size_t>(1, inner_nodes(n)));
  split(items, 0, n, 0);
  io::resize_in_large_pages(frames_, n);
  place_.resize(n);
  triangle_.resize(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    triangle_[i] = items[i].triangle;
    place_[static_cast<std::size_t>(items[i].triangle)] = static_cast<std::int32_t>(i);
    frames_[i] = TriangleFrame::of(corners(items[i].triangle));
  });
  mate_ = match_edges(set.triangles, set.points.size(), excluded).mate;
}

std::array<Eigen::Vector3d, 3> TriangleTree::corners(Index t) const {
  std::array<Eigen::Vector3d, 3> corners;
  for (int k = 0; k < 3; ++k)
    corners[k] =
        units_.to(set_.points[static_cast<std::size_t>(set_.triangles[static_cast<std::size_t>(t)][k])]);
  return corners;
}

Index TriangleTree::across(Index t, int k) const {
  const Side side = 3 * t + k;
  const Side mate = mate_[static_cast<std::size_t>(side)];
  return mate == no_side ? -1 : mate / 3;
}

Eigen::Vector3d TriangleTree::normals(std::span<const Item> items) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Item& item : items) {
    const auto [p, q, r] = corners(item.triangle);
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    sum += normal.dot(sum) < 0 ? Eigen::Vector3d(-normal) : normal;
  }
  return sum;
}

TriangleTree::Slab TriangleTree::slab(std::span<const Item> items, const Eigen::Vector3d& normals) const {
  Slab slab;
  const double length = normals.norm();
  if (items.empty() || items.size() > largest_slab || !(length > 1e-150)) return slab;
  slab.normal = normals / length;
  double low = INFINITY, high = -INFINITY;
  for (const Item& item : items)
    for (const Eigen::Vector3d& p : corners(item.triangle)) {
      const double at = slab.normal.dot(p);
      low = std::min(low, at);
      high = std::max(high, at);
    }
  slab.low = low - slab_slack;
  slab.high = high + slab_slack;
  return slab;
}

// Halves [begin, end) at the median, along the longest side of the box of the triangles' middles.
// `inner_nodes` tells the position of every node in advance, so threads need not agree on numbers.
Eigen::Vector3d TriangleTree::split(std::vector<Item>& items, std::size_t begin, std::size_t end,
                                    std::int32_t at) {
  const std::size_t n = end - begin, half = n / 2;
  Eigen::Vector3d low = items[begin].middle, high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(items[i].middle);
    high = high.cwiseMax(items[i].middle);
  }
  Eigen::Index axis;
  (high - low).maxCoeff(&axis);
  const auto first = items.begin() + static_cast<std::ptrdiff_t>(begin);
  std::nth_element(first, first + static_cast<std::ptrdiff_t>(half), first + static_cast<std::ptrdiff_t>(n),
                   [axis](const Item& a, const Item& b) {
                     return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis]
                                                             : a.triangle < b.triangle;
                   });
  const std::size_t inner = inner_nodes(half);
  const std::array<std::array<std::size_t, 2>, 2> parts{{{begin, begin + half}, {begin + half, end}}};
  const std::array<std::int32_t, 2> child{at + 1, at + 1 + static_cast<std::int32_t>(inner)};
  std::array<Eigen::Vector3d, 2> normal;
  const auto build = [&](int side) {
    const auto& [from, to] = parts[static_cast<std::size_t>(side)];
    const std::span<const Item> own = std::span(items).subspan(from, to - from);
    Eigen::Vector3d box_low = Eigen::Vector3d::Constant(INFINITY), box_high = -box_low;
    if (to - from > leaf_size) {
      normal[side] = split(items, from, to, child[side]);
      const Node& below = nodes_[static_cast<std::size_t>(child[side])];
      box_low = below.low[0].cwiseMin(below.low[1]);
      box_high = below.high[0].cwiseMax(below.high[1]);
    } else {
      normal[side] = normals(own);
      for (const Item& item : own)
        for (const Eigen::Vector3d& p : corners(item.triangle)) {
          box_low = box_low.cwiseMin(p);
          box_high = box_high.cwiseMax(p);
        }
    }
    Node& node = nodes_[static_cast<std::size_t>(at)];
    node.low[side] = box_low;
    node.high[side] = box_high;
    node.slab[side] = slab(own, normal[side]);
    const bool leaf = to - from <= leaf_size;
    node.child[side] = leaf ? ~static_cast<std::int32_t>(from) : child[side];
    node.count[side] = !leaf ? 0 : to == from ? -1 : static_cast<std::int32_t>(to - from);
  };
  if (n > 4096)
    tbb::parallel_invoke([&] { build(0); }, [&] { build(1); });
  else
    build(0), build(1);
  if (normal[0].dot(normal[1]) < 0) normal[1] = -normal[1];
  return normal[0] + normal[1];
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& p, Index guess, double enough,
                                            double share) const {
  if (guess < 0) return search(p, {-1, INFINITY}, enough, share);
  return search(p, {guess, frame(guess).squared_distance(p)}, enough, share);
}

TriangleTree::Nearest TriangleTree::nearest_within(const Eigen::Vector3d& p, double reach,
                                                   Index guess) const {
  const double limit = reach * reach * (1 + 4 * 0x1p-53);
  if (guess >= 0)
    if (const double squared = frame(guess).squared_distance(p); squared <= limit)
      return search(p, {guess, squared}, -1, 0);
  return search(p, {-1, std::nextafter(limit, INFINITY)}, -1, 0);
}

TriangleTree::Nearest TriangleTree::search(const Eigen::Vector3d& p, Nearest best, double enough,
                                           double share) const {
  if (empty()) return best;
  const double good = enough < 0 ? -1 : enough * enough, keep = (1 - share) * (1 - share);
  double limit = keep * best.squared;  // a half that is not nearer need not be searched
  struct Open {
    std::int32_t node;
    double squared;
  };
  std::array<Open, 64> stack;  // at most one entry for each level, and one more
  int top = 0;
  stack[top++] = {0, 0};
  while (top > 0 && best.squared > good) {
    const Open open = stack[--top];
    if (open.squared >= limit) continue;
    const Node& node = nodes_[static_cast<std::size_t>(open.node)];
    const std::array<double, 2> squared{squared_to_half(p, node, 0, limit),
                                        squared_to_half(p, node, 1, limit)};
    const int nearer = squared[1] < squared[0];
    for (const int side : {nearer, 1 - nearer}) {
      if (node.count[side] <= 0 || squared[side] >= limit) continue;
      const std::int32_t first = ~node.child[side];
      for (std::int32_t i = first; i < first + node.count[side]; ++i)
        if (const double d = frames_[static_cast<std::size_t>(i)].squared_distance(p); d < best.squared)
          best = {triangle_[static_cast<std::size_t>(i)], d};
      limit = keep * best.squared;
    }
    for (const int side : {1 - nearer, nearer})
      if (node.count[side] == 0 && squared[side] < limit) stack[top++] = {node.child[side], squared[side]};
  }
  return best;
}

}  // namespace tetproof::verify
