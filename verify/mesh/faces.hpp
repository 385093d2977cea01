// SPDX-License-Identifier: GPL-3.0-or-later
// Matches the faces of tetrahedra: shared faces, boundary faces, and faces that do not match. Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// A face of a tetrahedron: 4 * (position of the tetrahedron) + position in `tet_faces`.
using FaceId = std::uint32_t;
inline constexpr Index tet_of(FaceId face) {
  return static_cast<Index>(face >> 2);
}

inline std::array<Index, 3> vertices_of(const TetMesh& mesh, FaceId face) {
  const std::array<Index, 4>& tet = mesh.tets[face >> 2];
  const std::array<int, 3>& corners = tet_faces[face & 3];
  return {tet[corners[0]], tet[corners[1]], tet[corners[2]]};
}

/// Groups of faces with the same three vertices, stored one after the other.
struct FaceGroups {
  std::vector<FaceId> faces;
  std::vector<std::size_t> starts;  ///< where each group begins in `faces`

  std::size_t size() const { return starts.size(); }
  std::span<const FaceId> operator[](std::size_t i) const {
    const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : faces.size();
    return {faces.data() + starts[i], end - starts[i]};
  }
};

struct FaceMatching {
  std::vector<FaceId> boundary;  ///< faces of exactly one tetrahedron, ascending
  FaceGroups thrice;             ///< faces of three or more tetrahedra
  FaceGroups same_side;          ///< faces of two tetrahedra that induce the same orientation
};

/// Matches the faces of all tetrahedra except the excluded ones (`excluded` empty: none). The four vertices
/// of each tetrahedron must be different positions in `mesh.points`. Takes linear time and 64 bytes for each
/// tetrahedron in addition to the mesh. Throws InputError beyond 2^30 - 1 tetrahedra.
FaceMatching match_faces(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
