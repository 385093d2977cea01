// SPDX-License-Identifier: GPL-3.0-or-later
// Exact volumes of closed sheets of triangles, rounded only at the end. Internal.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

/// The exact signed volumes [length^3] that sets of oriented triangles enclose. Each set must have no border:
/// its triangles run along every edge equally often in both directions. Otherwise its volume depends on the
/// origin.
class ExactVolumes {
 public:
  /// Triangle t belongs to set `set_of[t]`, or to no set if that is negative. If `set_of` is empty, all
  /// triangles belong to set 0.
  ExactVolumes(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
               std::span<const Index> set_of, std::size_t sets);
  ~ExactVolumes();
  ExactVolumes(ExactVolumes&&) noexcept;
  ExactVolumes& operator=(ExactVolumes&&) noexcept;

  int sign(std::size_t set) const;
  double volume(std::size_t set) const;  ///< the double nearest to the exact volume, ties to even
  /// The double nearest to the exact sum of weights[i] * volume i.
  double weighted_sum(std::span<const int> weights) const;
  /// This weighted sum minus the weighted sum of `other`: the double nearest to the exact difference. In
  /// cubes of 2^exponent, so that it fits into a double whatever the scale.
  double difference(std::span<const int> weights, const ExactVolumes& other,
                    std::span<const int> other_weights, int exponent = 0) const;
  /// The double nearest to the exact sum of weights[i] * volume i, in cubes of 2^exponent.
  double weighted_sum_in_units(std::span<const int> weights, int exponent) const;
  /// Compares absolute volumes: negative, zero or positive if |volume i| <, = or > |volume j|.
  int compare_size(std::size_t i, std::size_t j) const;

 private:
  struct Sums;
  std::unique_ptr<Sums> sums_;
};

}  // namespace tetproof::verify
