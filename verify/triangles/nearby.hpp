// SPDX-License-Identifier: GPL-3.0-or-later
// What of two triangles is near each other without being common to them. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <span>

#include "verify/triangles/box.hpp"
#include "verify/triangles/nearness.hpp"

namespace tetproof::verify {

/// A vertex near a triangle that it does not belong to.
struct Contact {
  Index vertex, triangle;
  auto operator<=>(const Contact&) const = default;
};

/// What is near of one pair of triangles.
struct PairNearness {
  std::array<Contact, 6> contacts{};  ///< the first `contact_count`
  int contact_count = 0;
  bool near = false;  ///< without a common vertex, and near without meeting
  bool fold = false;  ///< with a common edge, and they meet, or two of their other edges cross or nearly do
};

/// Looks at pairs of triangles whose boxes are wider than they by what is near.
class Nearby {
 public:
  Nearby(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, const Near& near)
      : points_(points),
        triangles_(triangles),
        near_(near),
        room_(near.limit() * near.diagonal()),
        margin_(2 * room_ * near.diagonal()) {}

  /// Whether a side of one triangle separates the shadows that both cast along an axis, but for vertices they
  /// share, by so much that they neither meet nor are near each other. Most pairs end here.
  bool wide_apart(const Triangle& first, const Triangle& second) const;

  /// Of the triangles of two boxes, which `meet` or not.
  PairNearness look(const Box& x, const Box& y, bool meet) const;

 private:
  struct Plane;
  const Eigen::Vector3d& at(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  bool is_near(Index v, const Box& box, const Triangle& t, const Plane& plane) const;
  bool segments_near(Index a, Index b, Index c, Index d) const;
  bool edges_near(const Triangle& s, const Triangle& t) const;
  bool edges_cross(const Triangle& s, int i, const Triangle& t, int k) const;

  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  const Near& near_;
  double room_;    // what is near [length]
  double margin_;  // [length^2]
};

}  // namespace tetproof::verify
