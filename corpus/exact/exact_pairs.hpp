// SPDX-License-Identifier: GPL-3.0-or-later
// The way in which two tetrahedra meet, decided with exact integers. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// The corners of a tetrahedron; must be finite.
using Corners = std::array<Eigen::Vector3d, 4>;

/// The way in which two tetrahedra meet. They may have any orientation but must not be flat.
struct Meeting {
  bool overlap = false;  ///< their interiors meet
  // If they do not overlap, the contacts outside the simplex of their common vertices:
  std::vector<int> one_in_other, other_in_one;  ///< corners of one that lie in the other
  bool crossing = false;                        ///< whether an edge of one crosses an edge of the other
};

/// `one` and `other` are the numbers of the corners; equal numbers are common vertices. The method looks for
/// a separating plane: 8 candidates are parallel to a face, 36 to an edge of each tetrahedron.
Meeting meeting(const Corners& a, const std::array<Index, 4>& one, const Corners& b,
                const std::array<Index, 4>& other);

/// Whether two triangles lie in one plane and have an area in common, but not all three corners. They must
/// not be degenerate.
bool partly_on_each_other(const std::array<Eigen::Vector3d, 3>& f, const std::array<Eigen::Vector3d, 3>& g);

}  // namespace tetproof::corpus
