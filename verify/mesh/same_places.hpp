// SPDX-License-Identifier: GPL-3.0-or-later
// Points with equal coordinates, looked up by point. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

struct SamePlaces {
  std::vector<Index> first;          ///< of each point: the first point with its coordinates
  std::vector<std::uint8_t> shared;  ///< 1 if other points have its coordinates, else 0

  /// `same_place`: sets of points with equal coordinates, each ascending.
  SamePlaces(std::size_t points, const std::vector<std::vector<Index>>& same_place)
      : first(points), shared(points, 0) {
    std::iota(first.begin(), first.end(), 0);
    for (const std::vector<Index>& set : same_place)
      for (const Index v : set)
        first[static_cast<std::size_t>(v)] = set[0], shared[static_cast<std::size_t>(v)] = 1;
  }
};

}  // namespace tetproof::verify
