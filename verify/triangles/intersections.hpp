// SPDX-License-Identifier: GPL-3.0-or-later
// The search for all pairs of triangles that meet, or that are near each other. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"
#include "verify/triangles/nearby.hpp"
#include "verify/triangles/nearness.hpp"
#include "verify/triangles/triangle_pairs.hpp"

namespace tetproof::verify {

/// The search ends at so many pairs that meet, and that for what is near at so many of those: there are
/// quadratically many in a mesh of random numbers.
inline constexpr std::int64_t most_counted_pairs = 1'000'000;

/// All lists ascend, and hold the first `most` at most.
struct Intersections {
  bool more = false;       ///< there are more than most_counted_pairs: `count` is that number, and only some
                           ///< `pairs` are kept
  std::int64_t count = 0;  ///< of pairs that meet
  std::vector<std::array<Index, 2>> pairs;  ///< those, lower triangle first
  bool more_near = false;  ///< more than most_counted_pairs are near: what follows is not told
  // Only when asked for what is near:
  std::vector<Contact> contacts;  ///< each once; of triangles that meet, too
  std::vector<std::array<Index, 2>>
      folds;  ///< with a common edge, and meet, or are near where two others cross
  std::int64_t near_count = 0;
  std::vector<std::array<Index, 2>> near;  ///< without a common vertex, and near without meeting
};

/// All pairs that meet; `excluded` triangles (the degenerate ones) are left out. With `near`, also what is
/// near. Near-linear time plus the number of pairs whose boxes meet.
Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most = 100000,
                                 const Near* near = nullptr);

}  // namespace tetproof::verify
