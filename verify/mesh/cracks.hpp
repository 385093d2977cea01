// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks: coincident faces that are not shared, because each side has its own copies of the points. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "verify/mesh/faces.hpp"

namespace tetproof::verify {

struct Cracks {
  /// Pairs of boundary faces whose vertices have the same coordinates and whose tetrahedra lie on opposite
  /// sides. The lower face comes first; the list is ascending. Where three or more faces coincide, none is
  /// listed.
  std::vector<std::array<FaceId, 2>> pairs;
  /// The mesh with the cracks closed: where several points on cracked faces coincide, every tetrahedron names
  /// the first of them. Points and tetrahedra keep their positions. Absent if there are no cracks.
  std::optional<TetMesh> closed;
};

/// `boundary`: the faces of exactly one tetrahedron. `same_place`: sets of points with equal coordinates,
/// each ascending. Needs 24 bytes for each boundary face that has such a point.
Cracks find_cracks(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                   std::span<const FaceId> boundary, const std::vector<std::vector<Index>>& same_place);

}  // namespace tetproof::verify
