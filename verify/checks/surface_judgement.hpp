// SPDX-License-Identifier: GPL-3.0-or-later
// A judged surface with its exact volumes and its voxels, for comparing meshes with it. Internal.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verify/mesh/volumes.hpp"
#include "verify/surface.hpp"
#include "verify/voxels/surface_voxels.hpp"

namespace tetproof::verify {

struct SurfaceJudgement {
  SurfaceReport report;
  SurfaceNumbering numbering;
  /// The unit of length for what doubles could not hold otherwise: 2^exponent, below or at the longest side
  /// of the surface's box.
  int exponent = 0;
  double area = 0;                      ///< [units^2]
  std::optional<ExactVolumes> volumes;  ///< one set for each component; absent with a fault
  std::vector<Index> component_of;      ///< the component of each triangle
  std::vector<int> weights;             ///< of the components, for the volume inside an odd number of them
  /// Empty at first.
  std::shared_ptr<KeptVoxels> voxels = std::make_shared<KeptVoxels>();
};

SurfaceJudgement judge(const TriangleSurface& surface, SurfaceNumbering numbering);

}  // namespace tetproof::verify
