// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a tetrahedral mesh: its triangles and how they are connected. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/mesh/faces.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

struct Boundary {
  std::vector<FaceId> faces;  ///< the faces of exactly one tetrahedron, ascending
  /// The triangles of `faces`, followed by those of the faces that do not match. Together they have no
  /// border.
  std::vector<Triangle> triangles;

  // The following members describe the triangles of `faces` alone.

  EdgeMatching edges;
  Sheets groups;  ///< connected through edges of exactly two boundary faces
  Sheets sheets;  ///< connected also across the wedges of tetrahedra at non-manifold edges
  /// Vertices with several fans, ascending. The ends of non-manifold edges are not listed.
  std::vector<Index> pinched;
  bool closed = true;  ///< no sheet has an open side

  std::span<const Triangle> boundary_triangles() const { return {triangles.data(), faces.size()}; }
};

/// `matching`: the result of `match_faces` for the same mesh and the same `excluded` tetrahedra.
Boundary find_boundary(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                       const FaceMatching& matching);

}  // namespace tetproof::verify
