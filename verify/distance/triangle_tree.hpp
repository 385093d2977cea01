// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle nearest to a point: a tree of boxes. Internal.
//
// CGAL's AABB tree answers 13,000 such questions a second from anywhere and some 400,000 near the surface; a
// Hausdorff distance asks millions, and most of them with a good guess of the answer, which this tree uses.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/distance/triangle_frame.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// One box for everything that is compared, scaled by a power of two to a diagonal in [1/2, 1] about its
/// middle: equal points stay equal, and the differences that rounding makes are below 2^-53 in these units
/// wherever the box lies.
struct Units {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 1;     ///< [length]
  double diagonal = 0;  ///< of the box [length]
  bool usable = false;  ///< the box is finite, has a diagonal, and doubles can scale by it

  Eigen::Vector3d to(const Eigen::Vector3d& p) const { return (p - origin) / scale; }
  Eigen::Vector3d from(const Eigen::Vector3d& p) const { return p * scale + origin; }
};

struct TriangleSet {
  std::span<const Eigen::Vector3d> points;
  std::span<const Triangle> triangles;
};
Units units_of(std::span<const TriangleSet> sets);

/// What distances in units may be off by, all told: input rounded to units, frames, boxes that are passed
/// over. The error analysis gives 30 2^-53.
inline constexpr double distance_slack = 40 * 0x1p-53;

class TriangleTree {
 public:
  struct Nearest {
    Index triangle = -1;
    double squared = 0;  ///< distance [units^2]
  };

  /// Triangles name existing, finite points. Keeps what the spans refer to.
  TriangleTree(TriangleSet set, const Units& units);

  bool empty() const { return set_.triangles.empty(); }
  std::size_t size() const { return set_.triangles.size(); }
  const TriangleSet& set() const { return set_; }
  const Units& units() const { return units_; }
  const TriangleFrame& frame(Index t) const { return frames_[static_cast<std::size_t>(place_[t])]; }
  std::array<Eigen::Vector3d, 3> corners(Index t) const;  ///< [units]
  /// The triangle across side k of triangle t, or -1.
  Index across(Index t, int k) const;

  /// Of a point in units. `guess`: a triangle that may be near; -1: none. Once the distance is known to be
  /// at most `enough`, any triangle that near is good.
  Nearest nearest(const Eigen::Vector3d& p, Index guess = -1, double enough = -1) const;
  /// Calls visit(t) for all triangles within `distance` [units] of a point, until it returns false; false
  /// then.
  template <class Visit>
  bool for_each_within(const Eigen::Vector3d& p, double distance, const Visit& visit) const;

 private:
  struct Node {
    std::array<Eigen::Vector3d, 2> low, high;  // of the two halves
    std::array<std::int32_t, 2> child;         // a node; ~first for a leaf that starts at frame `first`
    std::array<std::int32_t, 2> count;         // of a leaf
  };
  struct Item {
    Eigen::Vector3d middle;
    Index triangle;
  };
  void split(std::vector<Item>& items, std::size_t begin, std::size_t end, std::int32_t node);
  static double squared_to_box(const Eigen::Vector3d& p, const Eigen::Vector3d& low,
                               const Eigen::Vector3d& high) {
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
  }

  TriangleSet set_;
  Units units_;
  std::vector<Node> nodes_;
  std::vector<TriangleFrame> frames_;  // in the order of the leaves
  std::vector<std::int32_t> place_;    // of a triangle's frame
  std::vector<Index> triangle_;        // of a frame
  std::vector<Side> mate_;
};

template <class Visit>
bool TriangleTree::for_each_within(const Eigen::Vector3d& p, double distance, const Visit& visit) const {
  if (empty()) return true;
  const double reach = distance * distance;
  std::array<std::int32_t, 64> stack;
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    for (int side = 0; side < 2; ++side) {
      if (node.count[side] < 0 || squared_to_box(p, node.low[side], node.high[side]) > reach) continue;
      if (node.count[side] == 0) {
        stack[top++] = node.child[side];
        continue;
      }
      for (std::int32_t i = ~node.child[side]; i < ~node.child[side] + node.count[side]; ++i)
        if (frames_[static_cast<std::size_t>(i)].squared_distance(p) <= reach)
          if (!visit(triangle_[static_cast<std::size_t>(i)])) return false;
    }
  }
  return true;
}

}  // namespace tetproof::verify
