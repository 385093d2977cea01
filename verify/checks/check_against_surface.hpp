// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a mesh with the surface that it should fill. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/checks/record.hpp"
#include "verify/mesh/boundary.hpp"
#include "verify/mesh/mesh_volumes.hpp"
#include "verify/mesh/unjudged_places.hpp"

namespace tetproof::verify {

/// The mesh that is compared, and what is known of it.
struct JudgedMesh {
  const TetMesh& mesh;
  const std::vector<std::uint8_t>& excluded;  ///< tetrahedra without geometry; empty: none
  const Boundary& boundary;
  const MeshVolumes& volumes;
  const UnjudgedPlaces& unjudged;
  const Options& options;
};

/// All checks that need a surface, and the volumes of surface and voxels.
void check_against_surface(const JudgedMesh& mesh, const JudgedSurface& surface, Record& record);

/// How many cavities a mesh of the region has.
std::size_t right_cavities(Region region, const SurfaceReport& surface);

}  // namespace tetproof::verify
