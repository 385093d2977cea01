// SPDX-License-Identifier: GPL-3.0-or-later
// The directed Hausdorff distance between two sets of triangles, enclosed in an interval.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

struct HausdorffOptions {
  /// Wanted width of the interval [length]. It is reached wherever doubles allow, which is not below some
  /// 1e-14 of the diagonal of the box of both sets.
  double error = 0;
  /// The interval is narrowed until it is no wider than this share of its upper end, so that a distance far
  /// below `error` is known, too. `most_pieces` limits the work. 0: `error` is enough.
  double relative = 0;
  /// The number of pieces of triangles that are looked at. After that the interval stays as wide as it is.
  std::int64_t most_pieces = 50'000'000;
};

/// The maximum, over the points of A, of the distance to the nearest point of B lies in [lower, upper]. This
/// is guaranteed, rounding included.
struct DirectedDistance {
  double lower = 0, upper = 0;                      ///< [length]
  Index triangle = -1;                              ///< a triangle of A
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< a point of it (to rounding), at least `lower` from B
  Index nearest = -1;                               ///< the triangle of B that is closest to the point
  std::int64_t pieces = 0;                          ///< how many pieces were looked at
};

/// The distance from the points of the triangles A to the nearest of the triangles B.
///
/// The distance to one triangle S is convex. So for every triangle S of B, the distance from a convex piece P
/// of a triangle of A to B is at most the largest distance of P's corners to S. The search starts from whole
/// triangles. A piece is done when this bound is no more than the largest distance found so far plus `error`.
/// Otherwise it is cut along the walls that stand on the edges of S: the part over S is compared with S, and
/// the other parts with S's neighbours. Where that does not help, the piece is halved. A triangle of A whose
/// three corners lie exactly on one triangle of B has distance 0, exactly. The result is the same for any
/// number of threads.
///
/// Triangles without area are taken as segments or points. InputError if a triangle names a
/// point that does not exist or is not finite, or if doubles cannot measure the common box (a diagonal below
/// 1e-289 or beyond 4e307). A empty: [0, 0]; B empty and A not: [infinity, infinity].
DirectedDistance directed_hausdorff(std::span<const Eigen::Vector3d> points_a,
                                    std::span<const std::array<Index, 3>> triangles_a,
                                    std::span<const Eigen::Vector3d> points_b,
                                    std::span<const std::array<Index, 3>> triangles_b,
                                    const HausdorffOptions& options);

}  // namespace tetproof::verify
