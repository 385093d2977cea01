// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the triangle nearest to a point with a tree of boxes. Internal.
//
// CGAL's AABB tree answers 13,000 such queries a second for arbitrary points, and some 400,000 near the
// surface. A Hausdorff distance makes millions of queries, most of them with a good guess of the answer. This
// tree uses the guess.
//
// Far from a curved surface all its points are nearly as far. A box around a patch of size s is nearer than
// the patch by up to s, so boxes alone rule out almost nothing there. So each patch also has a slab: two
// planes across its mean normal that hold the patch between them. With a radius of curvature R, the slab is
// only s^2 / R thick.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/distance/triangle_frame.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// Coordinates relative to the middle of one box around everything that is compared, scaled by a power of two
/// so that the box's diagonal is in [1/2, 1]. Equal points stay equal. Wherever the box lies, rounding
/// changes coordinates by less than 2^-53 in these units.
struct Units {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 1;     ///< [length]
  double diagonal = 0;  ///< of the box [length]
  bool usable = false;  ///< the box is finite, its diagonal is positive, and doubles can scale by it

  // The inverse of a power of two is exact.
  Eigen::Vector3d to(const Eigen::Vector3d& p) const { return (p - origin) * (1 / scale); }
  Eigen::Vector3d from(const Eigen::Vector3d& p) const { return p * scale + origin; }
};

struct TriangleSet {
  std::span<const Eigen::Vector3d> points;
  std::span<const Triangle> triangles;
};
/// The units of the box around all triangles of the sets.
Units units_of(std::span<const TriangleSet> sets);

/// A bound for the total error of a distance [units], from rounding the input to units, from the frames, and
/// from boxes that are skipped. The error analysis gives 30 2^-53.
inline constexpr double distance_slack = 40 * 0x1p-53;
/// Slabs are wider by this on both sides [units], so that rounding never makes them nearer than their patch.
/// With u = 2^-53 and points within 1/2 of the origin, normal . q is off by less than 2 u for the patch and
/// for the point, and their difference by u; the normal is too long by less than 4 u, and the square is off
/// by u.
inline constexpr double slab_slack = 16 * 0x1p-53;

class TriangleTree {
 public:
  struct Nearest {
    Index triangle = -1;
    double squared = 0;  ///< distance [units^2]
  };

  /// The triangles must name existing, finite points. The tree refers to the data of the spans, which must
  /// outlive it.
  TriangleTree(TriangleSet set, const Units& units);

  bool empty() const { return set_.triangles.empty(); }
  std::size_t size() const { return set_.triangles.size(); }
  const TriangleSet& set() const { return set_; }
  const Units& units() const { return units_; }
  const TriangleFrame& frame(Index t) const { return frames_[static_cast<std::size_t>(place_[t])]; }
  std::array<Eigen::Vector3d, 3> corners(Index t) const;  ///< [units]
  /// The triangle across side k of triangle t; -1 if there is none.
  Index across(Index t, int k) const;

  /// The triangle nearest to a point [units]. `guess`: a triangle that may be near; -1: none. The search may
  /// stop at any triangle whose distance is at most `enough`. With `share` > 0, another triangle may be
  /// nearer by up to this share of the distance found.
  Nearest nearest(const Eigen::Vector3d& p, Index guess = -1, double enough = -1, double share = 0) const;
  /// The nearest triangle, if it is within `reach` of the point (or farther by less than rounding); else
  /// none.
  Nearest nearest_within(const Eigen::Vector3d& p, double reach, Index guess = -1) const;
  /// Calls visit(t) for each triangle within `distance` [units] of a point. If visit returns false, the
  /// search ends and returns false.
  template <class Visit>
  bool for_each_within(const Eigen::Vector3d& p, double distance, const Visit& visit) const;

 private:
  // Every point q of a patch has low <= normal . q <= high. The normal's length is at most 1 + 2^-50, and 0
  // if the patch has no slab: then low < 0 < high.
  struct Slab {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double low = -slab_slack, high = slab_slack;
  };
  struct Node {
    std::array<Eigen::Vector3d, 2> low, high;  // boxes of the two halves
    std::array<Slab, 2> slab;
    std::array<std::int32_t, 2> child;  // a node; for a leaf, ~first, where its frames begin at `first`
    std::array<std::int32_t, 2> count;  // frames of a leaf; 0: a node; -1: an empty leaf
  };
  // Improves on `best`.
  Nearest search(const Eigen::Vector3d& p, Nearest best, double enough, double share) const;
  struct Item {
    Eigen::Vector3d middle;
    Index triangle;
  };
  // Returns a sum of the triangles' normals, all turned to one side.
  Eigen::Vector3d split(std::vector<Item>& items, std::size_t begin, std::size_t end, std::int32_t node);
  Eigen::Vector3d normals(std::span<const Item> items) const;
  Slab slab(std::span<const Item> items, const Eigen::Vector3d& normals) const;
  static double squared_to_box(const Eigen::Vector3d& p, const Eigen::Vector3d& low,
                               const Eigen::Vector3d& high) {
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
  }
  // No triangle of this half is nearer. Where the box alone says that it is not within `limit`, the slab is
  // not asked.
  static double squared_to_half(const Eigen::Vector3d& p, const Node& node, int side, double limit) {
    const double box = squared_to_box(p, node.low[side], node.high[side]);
    if (box >= limit) return box;
    const Slab& slab = node.slab[side];
    const double at = slab.normal.dot(p), off = std::max({slab.low - at, at - slab.high, 0.0});
    return std::max(box, off * off);
  }

  TriangleSet set_;
  Units units_;
  std::vector<Node> nodes_;
  std::vector<TriangleFrame> frames_;  // in the order of the leaves
  std::vector<std::int32_t> place_;    // for each triangle, the position of its frame
  std::vector<Index> triangle_;        // for each frame, its triangle
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
      if (node.count[side] < 0 || squared_to_half(p, node, side, reach) > reach) continue;
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
