// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of numbers. Internal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// The numbers from 0 to n - 1, each in a set of its own at first. A set is known by its lowest number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The lowest number of the set that i is in.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(Index i, Index j) {
    i = find(i), j = find(j);
    if (i != j) parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace tetproof::verify
