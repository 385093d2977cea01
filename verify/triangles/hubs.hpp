// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the pairs of triangles at vertices of very many triangles that may meet or be near each other.
// Internal.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "verify/triangles/box.hpp"
#include "verify/triangles/edges.hpp"
#include "verify/triangles/near_pieces.hpp"

namespace tetproof::verify {

/// A hub is a vertex of more than this many triangles.
inline constexpr std::size_t most_at_vertex = 64;

/// The triangles at hubs. The boxes of the n triangles at a vertex all meet, so a search by boxes would look
/// at n^2 pairs there. See hubs.cpp for what is done instead. Keeps the spans.
class Hubs {
 public:
  /// `excluded` triangles (empty: none) do not count.
  Hubs(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
       const std::vector<std::uint8_t>& excluded, std::size_t most = most_at_vertex);

  bool none() const { return !any_; }
  bool at_hub(const Triangle& t) const { return any_ && (is_hub_[t[0]] || is_hub_[t[1]] || is_hub_[t[2]]); }

  /// Calls `report(s, t)` for each pair of triangles, one of which is at a hub, that meet in more than common
  /// vertices and edges, or are near each other in the sense of Nearby::look, or both. `room(t)`: by how much
  /// the box of a triangle is enlarged [length]; two triangles are near only if a part of one that the other
  /// does not share is within the sum of both from the other. Reports other pairs, too, and pairs more than
  /// once. Whatever `report` throws ends the search.
  void candidates(const std::function<double(Index)>& room, Threads threads,
                  const std::function<void(Index, Index)>& report) const;

 private:
  std::vector<Index> triangles_in(std::vector<Box> around, const std::function<Box(Index)>& box) const;

  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  std::span<const std::uint8_t> excluded_;
  std::size_t most_;
  bool any_ = false;
  std::vector<std::uint8_t> is_hub_;
};

}  // namespace tetproof::verify
