// SPDX-License-Identifier: GPL-3.0-or-later
// Decides pairs of triangles that a search proposes, and collects what they have in common. Internal.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "verify/triangles/box.hpp"
#include "verify/triangles/intersections.hpp"

namespace tetproof::verify {

/// Sorts the list, removes repeated items and keeps the first `most`.
template <class T>
void keep_first(std::vector<T>& list, std::size_t most) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  if (list.size() > most) list.resize(most), list.shrink_to_fit();
}

void keep_first_of_each(Intersections& all, std::size_t most);

/// Ends a search.
struct TooManyPairs {};

/// Decides pairs of triangles for several threads. Each thread has a list of its own, and joins it to that of
/// all in the end.
class Decider {
 public:
  /// The list of pairs keeps the first `most`. What is near is looked for only with `near`. Keeps the
  /// arguments.
  Decider(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, std::size_t most,
          const Near* near);

  /// Whether `add` would find anything. The boxes are enlarged by the near distance and meet.
  bool finds(const Box& x, const Box& y) const;
  /// Adds what the triangles of two such boxes have in common. Throws TooManyPairs after most_counted_pairs.
  void add(const Box& x, const Box& y, Intersections& found);
  /// Adds the list of one thread to that of all.
  void join(Intersections& all, const Intersections& part);

  bool too_many_meet() const { return met_ > most_counted_pairs; }
  bool too_many_near() const { return near_pairs_ > most_counted_pairs; }

 private:
  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  std::size_t most_;
  std::optional<Nearby> nearby_;
  std::atomic<std::int64_t> met_ = 0, near_pairs_ = 0;
  std::mutex joining_;
};

}  // namespace tetproof::verify
