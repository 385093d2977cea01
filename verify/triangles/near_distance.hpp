// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as near: distances between vertices, edges and triangles, each against the size of the triangle
// that it is measured from. Internal.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// A triangle's near distance, its *room*, is `near_distance` times its longest edge, or `near_units` units
/// in the last place of its largest coordinate, whichever is larger. But it is never more than
/// `near_thickness` times the thickness of the triangle's tetrahedron: a mesh whose elements are that thin
/// was meant to be so.
inline constexpr double near_distance = 1e-12;
inline constexpr double near_units = 4;
inline constexpr double near_thickness = 1e-3;
/// Distances are measured in doubles, off by at most this share of the measured triangle's size.
inline constexpr double near_error = 1e-14;

/// Says what is near a triangle, and how far apart triangles are. Where a triangle's room is so small that
/// doubles cannot measure it, only what exactly touches the triangle is near.
///
/// All differences are taken from a vertex of what is measured, and scaled by a power of two. So neither the
/// mesh's scale nor its position matters, nor other parts of another size.
class Near {
 public:
  /// `opposite`: for each triangle, the vertex of its tetrahedron opposite to it; empty: there are no
  /// tetrahedra, and a triangle's thickness is its smallest height.
  Near(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
       std::span<const Index> opposite = {});

  double room(Index t) const { return rooms_[static_cast<std::size_t>(t)]; }  ///< [length]
  double size(Index t) const { return sizes_[static_cast<std::size_t>(t)]; }  ///< its longest edge [length]
  double room(Index s, Index t) const { return std::max(room(s), room(t)); }  ///< that of a pair [length]

  bool on_plane(Index v, Index t) const;                   ///< v is near the triangle's plane
  bool on_edge(Index v, Index a, Index b, Index t) const;  ///< v is near the edge a b of triangle t
  bool on_triangle(Index v, Index t) const;                ///< v is near triangle t
  /// The edge a b of triangle s and the edge c d of triangle t are near each other.
  bool edges_near(Index a, Index b, Index s, Index c, Index d, Index t) const;

  double to_triangle(Index v, Index t) const;        ///< the distance [length]
  double between_triangles(Index s, Index t) const;  ///< the distance of two that do not meet [length]
  /// The position of the segment's point that is closest to v: 0 at a, 1 at b.
  double along(Index v, Index a, Index b) const;

 private:
  const Triangle& triangle(Index t) const { return triangles_[static_cast<std::size_t>(t)]; }
  const Eigen::Vector3d& at(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  Eigen::Vector3d from(Index a, Index b) const { return factor_ * at(b) - factor_ * at(a); }
  double between_segments(Index a, Index b, Index c, Index d) const;

  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  double factor_ = 1;  // a power of two: the difference of two scaled coordinates is finite
  std::vector<double> rooms_, sizes_;
};

}  // namespace tetproof::verify
