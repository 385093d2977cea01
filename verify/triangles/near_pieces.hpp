// SPDX-License-Identifier: GPL-3.0-or-later
// Finds pairs of points, segments and triangles in space that may be near each other, also where very many of
// them are long and thin, or have a common vertex. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// The convex hull of three points (some of which may be equal), enlarged by `slack` along every axis. The
/// slack covers what the caller calls near, the caller's rounding, and `rounding_of_pieces` times the largest
/// absolute coordinate. No number exceeds 2^500, so that no product overflows.
struct Piece {
  std::array<Eigen::Vector3d, 3> corners;
  double slack = 0;
  Index owner = -1;                       ///< several pieces may have the same owner
  std::array<Index, 3> hubs{-1, -1, -1};  ///< pieces with a common hub are not compared; -1: none
};

inline constexpr double rounding_of_pieces = 0x1p-46;  ///< see `separated` in separation.cpp

enum class Compare {
  all,             ///< all pairs without a common hub
  pairs_with_hub,  ///< of these only pairs one of which has a hub
};

enum class Threads {
  all,  ///< calls come from several threads and in any order
  one,  ///< calls come from the caller's thread, in an order that depends only on the arguments
};

/// Calls `report(owner, other)` for each pair of pieces whose enlarged hulls meet, if it is to be compared
/// and the owners differ. Reports other pairs, too, and pairs more than once. Whatever `report` throws ends
/// the search.
///
/// Takes n log n time if few pieces are near each other apart from those with a common hub: the pieces are
/// grouped in a tree, and two groups are done as soon as a plane separates them or they have a common hub.
void near_pieces(const std::vector<Piece>& pieces, Compare compare, Threads threads,
                 const std::function<void(Index, Index)>& report);

}  // namespace tetproof::verify
