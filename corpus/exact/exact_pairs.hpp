// SPDX-License-Identifier: GPL-3.0-or-later
// How two tetrahedra meet, over exact integers. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// Finite points.
using Corners = std::array<Eigen::Vector3d, 4>;

/// How two tetrahedra, not flat, of either orientation, meet.
struct Meeting {
  bool overlap = false;  ///< they have common inside
  // Otherwise, of what they have in common beyond the simplex of their common vertices:
  std::vector<int> one_in_other, other_in_one;  ///< corners of the one that lie in the other
  bool crossing = false;                        ///< edges that cross
};

/// `one` and `other`: numbers of the corners; equal numbers are common vertices. By separating planes: 8
/// along faces and 36 along an edge of each.
Meeting meeting(const Corners& a, const std::array<Index, 4>& one, const Corners& b,
                const std::array<Index, 4>& other);

}  // namespace tetproof::corpus
