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
  /// Wanted width of the interval [length]. Reached wherever doubles allow: not below some 1e-14 of the
  /// diagonal of the box of both sets.
  double error = 0;
  /// Within the work below the interval is narrowed until it is no wider than this share of its upper end: a
  /// distance far below `error` is then known, too. 0: `error` is enough.
  double relative = 0;
  /// Pieces of triangles looked at; past it the interval stays as wide as it is.
  std::int64_t most_pieces = 50'000'000;
};

/// max over the points of A of the distance to the nearest point of B lies in [lower, upper]: guaranteed,
/// rounding included.
struct DirectedDistance {
  double lower = 0, upper = 0;                      ///< [length]
  Index triangle = -1;                              ///< of A; there the distance is at least `lower`,
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< at this point of it (to rounding)
  Index nearest = -1;                               ///< the triangle of B that is closest to it
  std::int64_t pieces = 0;                          ///< how many were looked at
};

/// From each point of the triangles A to the nearest of the triangles B.
///
/// The distance to one triangle S is convex. So over a convex piece P of a triangle of A the distance to B is
/// at most the largest distance of P's corners to S, whichever triangle S of B is taken. Starting from whole
/// triangles, a piece is done when that is no more than the largest distance found so far plus `error`; else
/// it is cut along the walls that stand on the edges of S, what stands over S being judged by S and the rest
/// by S's neighbours, and where that does not help it is halved. A triangle of A whose three corners lie
/// exactly on one triangle of B counts as exactly 0. Same bytes for any number of threads.
///
/// Triangles without area are taken as what they are, segments or points. InputError if a triangle names a
/// point that does not exist or is not finite, or if doubles cannot measure the common box (a diagonal below
/// 1e-289 or beyond 4e307). A empty: [0, 0]; B empty and A not: [infinity, infinity].
DirectedDistance directed_hausdorff(std::span<const Eigen::Vector3d> points_a,
                                    std::span<const std::array<Index, 3>> triangles_a,
                                    std::span<const Eigen::Vector3d> points_b,
                                    std::span<const std::array<Index, 3>> triangles_b,
                                    const HausdorffOptions& options);

}  // namespace tetproof::verify
