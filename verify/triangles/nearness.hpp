// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between points, segments and triangles, in double arithmetic: what is called near. Internal.
#pragma once

#include <Eigen/Core>
#include <span>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// What lies closer than this is near, [box diagonal of the boundary]; far from the origin, where coordinates
/// are rounded more coarsely, what lies within so many units in the last place of the largest of them.
inline constexpr double near_distance = 1e-12;
inline constexpr double near_units = 4;

/// Measures in units of the box diagonal, from a vertex of what is measured, so that neither scale nor place
/// of the mesh matter. Absolute error: some 1e-15. Distances to a triangle thinner than that are never too
/// small, and too large by at most its thickness.
class Near {
 public:
  /// The box is that of the triangles' vertices.
  Near(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles);

  double diagonal() const { return diagonal_; }  ///< [length]
  double limit() const { return limit_; }        ///< what is near [diagonal]
  /// False if the box has no diagonal that doubles can scale by; nothing is near then.
  bool usable() const { return usable_; }

  double to_plane(Index v, const Triangle& t) const;  ///< of a triangle; 0 if it has no area
  double to_segment(Index v, Index a, Index b) const;
  double to_triangle(Index v, const Triangle& t) const;
  double between_segments(Index a, Index b, Index c, Index d) const;
  double between_triangles(const Triangle& s, const Triangle& t) const;  ///< of two that do not meet

  /// Where along a segment the closest point lies: 0 at a, 1 at b.
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
