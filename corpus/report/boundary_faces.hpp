// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a mesh with their tetrahedra, and counts of the parts of its boundary. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// All faces by their vertices, and those of one tetrahedron: the boundary. It knows nothing of the judge.
class BoundaryFaces {
 public:
  explicit BoundaryFaces(const TetMesh& mesh);
  /// The tetrahedra of a face, ascending; of a face that the mesh does not have: none.
  const std::vector<Index>& tets(std::array<Index, 3> face) const;
  /// Outward if the tetrahedra are positive, in the order of their tetrahedra. Without faces that name a
  /// vertex twice or one that does not exist.
  const std::vector<std::array<Index, 3>>& boundary() const { return boundary_; }

 private:
  std::map<std::array<Index, 3>, std::vector<Index>> tets_;
  std::vector<std::array<Index, 3>> boundary_;
};

struct FaceCounts {
  std::int64_t components = 0;  ///< parts that hang together by edges
  std::int64_t euler = 0;       ///< vertices - edges + triangles
};
FaceCounts face_counts(std::span<const std::array<Index, 3>> triangles);

/// The number of parts that the triangles at a vertex form, where triangles hang together by edges at it.
std::int64_t fans_at(std::span<const std::array<Index, 3>> triangles, Index vertex);

}  // namespace tetproof::corpus
