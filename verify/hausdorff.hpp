// SPDX-License-Identifier: GPL-3.0-or-later
// The directed Hausdorff distance between two sets of triangles, as a guaranteed interval.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

struct HausdorffOptions {
  /// Wanted width of the interval [length]. Doubles cannot reach a width below about 1e-14 of the diagonal of
  /// the box around both sets; where triangles must be cut often, below 1e-12.
  double error = 0;
  /// The interval is also narrowed until it is no wider than this share of its upper end, within the limit
  /// `most_pieces`. So a distance far below `error` is known, too. 0: `error` is enough.
  double relative = 0;
  /// The largest number of pieces of triangles to examine. After that the interval stays as wide as it is.
  std::int64_t most_pieces = 50'000'000;
};

/// The maximum over the points of A of the distance to the nearest point of B lies in [lower, upper]. This is
/// guaranteed, rounding included.
struct DirectedDistance {
  double lower = 0, upper = 0;  ///< [length]
  Index triangle = -1;          ///< the triangle of A that holds `point`
  Eigen::Vector3d point =
      Eigen::Vector3d::Zero();  ///< here the distance is at least `lower` (up to rounding)
  Index nearest = -1;           ///< the triangle of B closest to `point`
  std::int64_t pieces = 0;      ///< number of pieces examined
};

/// The largest distance from a point of the triangles A to the nearest point of the triangles B.
/// The distance to one triangle S is a convex function. So on a convex piece P of a triangle of A, the
/// distance to B is at most the largest distance from P's corners to S, for any triangle S of B. The search
/// starts with whole triangles. A piece is done if its bound is no more than the largest distance found so
/// far plus `error`. Otherwise it is cut along the walls that stand on the edges of S: the part over S is
/// judged by S, and the rest by S's neighbours. If that does not help, the piece is halved. If the three
/// corners of a triangle of A lie exactly on one triangle of B, its distance counts as exactly 0. The result
/// is the same for any number of threads. Triangles without area count as the segments or points that they
/// are. Throws InputError if a triangle names a point that does not exist or is not finite, or if doubles
/// cannot measure the common box (a diagonal below 1e-289 or above 4e307). If A is empty the result is [0,
/// 0]; if only B is empty it is [infinity, infinity].
DirectedDistance directed_hausdorff(std::span<const Eigen::Vector3d> points_a,
                                    std::span<const std::array<Index, 3>> triangles_a,
                                    std::span<const Eigen::Vector3d> points_b,
                                    std::span<const std::array<Index, 3>> triangles_b,
                                    const HausdorffOptions& options);

}  // namespace tetproof::verify
