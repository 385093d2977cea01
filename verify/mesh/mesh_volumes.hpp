// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh's boundary encloses: the volume of each sheet and of the mesh. Internal.
#pragma once

#include "verify/mesh/boundary.hpp"
#include "verify/mesh/volumes.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Exact volumes of the boundary's sheets and, as the last set, of the faces that do not match. Faces that
/// two tetrahedra share with opposite orientations cancel, so that the sum over all sets is the sum of the
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

/// Components, cavities and genus of a boundary that is closed and all of whose faces match, and its volume
/// rounded once. Of the counts, the boundary's faces alone.
Shape shape_of(const Boundary& boundary, const MeshVolumes& volumes);

}  // namespace tetproof::verify
