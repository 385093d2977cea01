// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks: faces in the same place whose tetrahedra would share them, had they not each points of their own.
// Internal.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "verify/mesh/faces.hpp"

namespace tetproof::verify {

struct Cracks {
  /// Faces of one tetrahedron each whose vertices have the same coordinates and which are seen from opposite
  /// sides; the lower first, ascending. Where three or more faces lie in one place none is listed.
  std::vector<std::array<FaceId, 2>> pairs;
  /// The mesh with the cracks closed: of points in one place, on cracked faces, every tetrahedron names the
  /// first. Points and tetrahedra keep their positions. Absent without cracks.
  std::optional<TetMesh> closed;
};

/// `boundary`: the faces of one tetrahedron only; `same_place`: sets of points with equal coordinates, each
/// ascending. 24 bytes a boundary face with such a point.
Cracks find_cracks(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                   std::span<const FaceId> boundary, const std::vector<std::vector<Index>>& same_place);

}  // namespace tetproof::verify
