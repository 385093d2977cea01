// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles that meet in more than their common vertices and edge, exactly. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/edges.hpp"
#include "verify/nearness.hpp"

namespace tetproof::verify {

/// 1 where a triangle's three vertices lie on a line, exactly tested; `count` of them.
struct Degenerate {
  std::vector<std::uint8_t> triangles;
  std::int64_t count = 0;
};
Degenerate degenerate_triangles(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles);

/// Whether two non-degenerate triangles meet in a point that is not on a common vertex or edge; vertices are
/// common when their numbers are equal (touching without a common number is meeting). Three common vertices:
/// always.
bool triangles_meet(std::span<const Eigen::Vector3d> points, const Triangle& a, const Triangle& b);

/// A vertex near a triangle that it does not belong to.
struct Contact {
  Index vertex, triangle;
  auto operator<=>(const Contact&) const = default;
};

/// All lists ascend, and hold the first `most` at most.
struct Intersections {
  std::int64_t count = 0;                   ///< of pairs that meet
  std::vector<std::array<Index, 2>> pairs;  ///< those, lower triangle first
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
