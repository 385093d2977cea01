// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a tetrahedral mesh: its triangles, how they hang together, and what they enclose. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/mesh/faces.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::verify {

struct Boundary {
  std::vector<FaceId> faces;  ///< of one tetrahedron only, ascending
  std::vector<Triangle>
      triangles;       ///< theirs, and after them the faces that do not match: together they have no border
  EdgeMatching edges;  ///< of the boundary faces alone, as all that follows
  Sheets groups;       ///< hang together through edges of exactly two boundary faces
  Sheets sheets;       ///< also through the wedges of tetrahedra at other edges
  std::vector<Index>
      pinched;         ///< vertices of several fans, but for the ends of non-manifold edges; ascending
  bool closed = true;  ///< no sheet has an open side

  std::span<const Triangle> boundary_triangles() const { return {triangles.data(), faces.size()}; }
};

Boundary find_boundary(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                       const FaceMatching& matching);

}  // namespace tetproof::verify
