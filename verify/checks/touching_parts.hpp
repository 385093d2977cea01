// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the mesh that touch along faces that do not match, and do not overlap. Internal.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "verify/mesh/boundary.hpp"

namespace tetproof::verify {

/// Two parts, and the pairs of boundary faces with a common area. Faces are positions in `Boundary::faces`.
struct TouchingParts {
  std::array<Index, 2> parts;  ///< ascending
  std::vector<std::array<Index, 2>> faces;
};

struct Interfaces {
  std::vector<TouchingParts> touching;  ///< ascending
  std::vector<Index> part_of_tet;       ///< as `parts_of` numbers them; empty if nothing touches
  bool given_up = false;                ///< too many tetrahedra were to be compared: nothing is known

  /// The position in `touching` of the parts of two tetrahedra; nothing if they do not touch.
  std::optional<std::size_t> between(Index s, Index t) const;
};

inline constexpr std::size_t most_compared_tets = 100'000'000;

/// Finds pairs of parts with the following properties. Some boundary faces of the two lie in one plane, on
/// opposite sides of it, and have an area in common. No tetrahedra of the two overlap; exact predicates
/// decide this for all pairs whose boxes meet. Both parts have positive tetrahedra only.
///
/// `pairs`: boundary faces that meet. `explained`: whether another cause is known for such a pair; it then
/// makes no parts touch. `cracks`: pairs of faces that connect parts, too. The search is given
/// up after `most_compared_tets` pairs of boxes that meet.
Interfaces find_touching_parts(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                               const Boundary& boundary, std::span<const std::array<Index, 2>> pairs,
                               const std::function<bool(Index, Index)>& explained,
                               std::span<const std::array<FaceId, 2>> cracks,
                               const std::vector<Index>& not_positive);

}  // namespace tetproof::verify
