// SPDX-License-Identifier: GPL-3.0-or-later
// Of a set of voxels those deeper than a distance below a surface, and the regions that they form. Internal.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "verify/distance/triangle_tree.hpp"
#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {

/// Voxels that touch each other, be it in a corner.
struct VoxelRegion {
  std::int64_t voxels = 0;
  /// Those of them, and those next to them, that may lie in the region in part: what `met` says, or a depth
  /// within half a voxel's diagonal of the limit.
  std::int64_t unsure = 0;
  Eigen::Vector3d deepest = Eigen::Vector3d::Zero();  ///< a centre [length], the deepest of those looked at
  double depth = 0;                                   ///< there, at least [length]
  Index nearest = -1;                                 ///< the triangle nearest to it; -1: there are none
};

/// Regions of the voxels of `set` whose centres are farther than `depth` [length] from the triangles, the
/// largest first; and of each of `points` [length] the region that its voxel belongs to or touches, or -1.
struct DeepVoxels {
  std::vector<VoxelRegion> regions;
  std::vector<std::int32_t> region_at;
};
/// `met`: voxels that the boundary of what is looked for may cut; asked for only if any voxel is that deep.
DeepVoxels deep_voxels(const VoxelLattice& lattice, const VoxelBits& set, const TriangleTree& tree,
                       double depth, const std::function<VoxelBits()>& met,
                       std::span<const Eigen::Vector3d> points);

}  // namespace tetproof::verify
