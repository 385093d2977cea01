// SPDX-License-Identifier: GPL-3.0-or-later
// Finds all pairs of triangles that meet or are near each other. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"
#include "verify/triangles/hubs.hpp"
#include "verify/triangles/near_distance.hpp"
#include "verify/triangles/near_pairs.hpp"
#include "verify/triangles/triangle_pairs.hpp"

namespace tetproof::verify {

/// The search stops at this many pairs that meet, and at this many pairs that are near: a mesh of random
/// numbers has quadratically many of them.
inline constexpr std::int64_t most_counted_pairs = 1'000'000;

/// All lists are ascending. `pairs` holds no more than the first `most`, the others hold all.
struct Intersections {
  /// More than most_counted_pairs meet: `count` is most_counted_pairs, and `pairs` has only some of them.
  bool more = false;
  std::int64_t count = 0;                   ///< number of pairs that meet
  std::vector<std::array<Index, 2>> pairs;  ///< those pairs, the lower triangle first
  /// More than most_counted_pairs are near: `contacts`, `folds` and `near` are empty.
  bool more_near = false;

  // Filled only if the caller asks for what is near:

  std::vector<Contact> contacts;  ///< each once, also those of triangles that meet
  /// Pairs with a common edge that meet, or two of whose other edges cross or nearly cross.
  std::vector<std::array<Index, 2>> folds;
  std::vector<std::array<Index, 2>> near;  ///< pairs without a common vertex that are near but do not meet
};

/// Finds all pairs that meet; with `near`, also those that are near. Leaves out the `excluded` triangles (the
/// degenerate ones). Takes near-linear time plus a constant for each pair whose boxes meet. A vertex of more
/// than `hub_from` triangles is a hub (hubs.hpp), where the boxes of all pairs meet: only those pairs
/// count there that a closer look cannot tell apart.
Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most = 100000,
                                 const Near* near = nullptr, std::size_t hub_from = most_at_vertex);

}  // namespace tetproof::verify
