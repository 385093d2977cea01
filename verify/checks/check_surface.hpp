// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh against the surface that it should fill: topology and volume. Internal.
#pragma once

#include "verify/checks/judgement.hpp"
#include "verify/checks/surface_judgement.hpp"
#include "verify/mesh/mesh_volumes.hpp"

namespace tetproof::verify {

/// topology, volume-surface, volume-voxel, and the accounts of volume.
void check_against_surface(Judgement& judgement, const MeshVolumes& volumes, const TriangleSurface& surface,
                           const SurfaceJudgement& judged);

/// How many cavities a mesh of the region has.
std::size_t right_cavities(Region region, const SurfaceReport& surface);

}  // namespace tetproof::verify
