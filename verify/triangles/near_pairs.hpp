// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of two triangles that are near each other although the triangles do not share them.
// Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <span>

#include "verify/triangles/box.hpp"
#include "verify/triangles/near_distance.hpp"

namespace tetproof::verify {

/// A vertex near a triangle that it does not belong to.
struct Contact {
  Index vertex, triangle;
  auto operator<=>(const Contact&) const = default;
};

/// What is near in one pair of triangles.
struct PairNearness {
  std::array<Contact, 6> contacts{};  ///< only the first `contact_count` count
  int contact_count = 0;
  bool near = false;  ///< they have no common vertex and are near, but do not meet
  /// They have a common edge and meet, or two of their other edges cross or nearly cross.
  bool fold = false;
};

/// Tests triangle pairs whose boxes have each been enlarged by the triangle's room.
class Nearby {
 public:
  Nearby(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, const Near& near)
      : points_(points), triangles_(triangles), near_(near) {}

  /// Whether the line through a side of one triangle separates the projections of both along an axis (except
  /// for shared vertices) so widely that the triangles neither meet nor are near. This settles most pairs.
  bool wide_apart(Index first, Index second) const;

  /// Finds what is near in the triangles of two boxes. `meet`: whether the triangles meet.
  PairNearness look(const Box& x, const Box& y, bool meet) const;

 private:
  struct Plane;
  const Eigen::Vector3d& at(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  const Triangle& triangle(Index t) const { return triangles_[static_cast<std::size_t>(t)]; }
  bool is_near(Index v, const Box& box, Index t, const Plane& plane) const;
  bool segments_near(Index a, Index b, Index s, Index c, Index d, Index t) const;
  bool edges_near(Index s, Index t) const;
  bool edges_cross(Index s, int i, Index t, int k) const;

  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  const Near& near_;
};

}  // namespace tetproof::verify
