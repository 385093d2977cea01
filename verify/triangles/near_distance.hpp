// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between points, segments and triangles in double arithmetic, and the limit for "near". Internal.
#pragma once

#include <Eigen/Core>
#include <span>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// Two things are near if their distance is below this, in diagonals of the boundary's box. Far from the
/// origin, where coordinates are rounded more coarsely, the limit is `near_units` units in the last place of
/// the largest coordinate.
inline constexpr double near_distance = 1e-12;
inline constexpr double near_units = 4;

/// Measures distances in units of the box diagonal. All differences are taken from a vertex of the measured
/// triangle or segment, so neither the mesh's scale nor its position matters. Absolute error: about 1e-15.
/// The distance to a triangle thinner than that is never too small, and too large by at most its thickness.
class Near {
 public:
  /// The box is the bounding box of the triangles' vertices.
  Near(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles);

  double diagonal() const { return diagonal_; }  ///< [length]
  double limit() const { return limit_; }        ///< the largest distance that is near [diagonal]
  /// False if doubles cannot scale by the box's diagonal; then nothing is near.
  bool usable() const { return usable_; }

  double to_plane(Index v, const Triangle& t) const;  ///< to the triangle's plane; 0 if it has no area
  double to_segment(Index v, Index a, Index b) const;
  double to_triangle(Index v, const Triangle& t) const;
  double between_segments(Index a, Index b, Index c, Index d) const;
  double between_triangles(const Triangle& s, const Triangle& t) const;  ///< the two must not meet

  /// The position of the segment's point that is closest to v: 0 at a, 1 at b.
  double along(Index v, Index a, Index b) const;

 private:
  Eigen::Vector3d from(Index a, Index b) const {
    return scale_ * (points_[static_cast<std::size_t>(b)] - points_[static_cast<std::size_t>(a)]);
  }

  std::span<const Eigen::Vector3d> points_;
  double diagonal_ = 0, scale_ = 0, limit_ = near_distance;
  bool usable_ = false;
};

}  // namespace tetproof::verify
