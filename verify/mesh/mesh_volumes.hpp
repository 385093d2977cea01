// SPDX-License-Identifier: GPL-3.0-or-later
// The volumes that the sheets of a mesh's boundary enclose, and the volume of the mesh. Internal.
#pragma once

#include "verify/mesh/boundary.hpp"
#include "verify/mesh/volumes.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Exact volumes of the boundary's sheets. The last set holds the faces that do not match. Faces that two
/// tetrahedra share with opposite orientations cancel, so the sum over all sets is the sum of the
/// tetrahedra's signed volumes.
struct MeshVolumes {
  ExactVolumes sets;
  std::vector<int> all;  ///< weights: one for each set
};

inline MeshVolumes mesh_volumes(const TetMesh& mesh, const Boundary& boundary) {
  const std::size_t sheets = boundary.sheets.sheets.size();
  std::vector<Index> set_of = boundary.sheets.of_triangle;
  set_of.resize(boundary.triangles.size(), static_cast<Index>(sheets));
  return {ExactVolumes(mesh.points, boundary.triangles, set_of, sheets + 1), std::vector<int>(sheets + 1, 1)};
}

/// The number of boundary faces and the volume, rounded once. If the boundary is closed and all faces match,
/// also the components, cavities and genus. Other counts of the shape are left at 0.
Shape shape_of(const Boundary& boundary, const MeshVolumes& volumes);

}  // namespace tetproof::verify
