// SPDX-License-Identifier: GPL-3.0-or-later
// Exact volumes of closed sheets of triangles, rounded once. Internal.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// The exact signed volumes [length^3] that sets of oriented triangles enclose; each set must have no border
/// (every edge is run as often in one direction as in the other), else its volume depends on the origin.
class ExactVolumes {
 public:
  /// Triangle t belongs to set `set_of[t]`, or to none if that is negative; an empty `set_of`: all to set 0.
  ExactVolumes(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
               std::span<const Index> set_of, std::size_t sets);
  ~ExactVolumes();
  ExactVolumes(ExactVolumes&&) noexcept;
  ExactVolumes& operator=(ExactVolumes&&) noexcept;

  int sign(std::size_t set) const;
  double volume(std::size_t set) const;                     ///< the double nearest to it, ties to even
  double weighted_sum(std::span<const int> weights) const;  ///< of weights[i] * volume i, the nearest double
  /// This weighted sum less another's, the nearest double to the exact difference.
  double difference(std::span<const int> weights, const ExactVolumes& other,
                    std::span<const int> other_weights) const;
  /// Order of the sets' absolute volumes: negative, zero or positive as |volume i| <, = or > |volume j|.
  int compare_size(std::size_t i, std::size_t j) const;

 private:
  struct Sums;
  std::unique_ptr<Sums> sums_;
};

}  // namespace tetproof::verify
