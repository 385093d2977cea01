// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the voxels of a set that are farther from a surface than a distance, and the regions that they form.
// Internal.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "verify/distance/triangle_tree.hpp"
#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {

/// Voxels that are connected by faces, edges or corners.
struct VoxelRegion {
  std::int64_t voxels = 0;
  /// Voxels of the region or next to it that may lie in it in part: voxels of `met`, and voxels whose depth
  /// is within half a voxel's diagonal of the limit.
  std::int64_t unsure = 0;
  Eigen::Vector3d deepest = Eigen::Vector3d::Zero();  ///< the deepest of the centres looked at [length]
  double depth = 0;                                   ///< its depth, or less [length]
  Index nearest = -1;                                 ///< the triangle nearest to it; -1: there are none
};

/// The regions of the voxels of `set` whose centres are farther than `depth` [length] from the triangles, the
/// largest first. For each of `points` [length] the region that its voxel belongs to or touches, or -1.
struct DeepVoxels {
  std::vector<VoxelRegion> regions;
  std::vector<std::int32_t> region_at;
};
/// `met` gives the voxels that the boundaries of the set may cut. It is called only if a voxel is that deep.
DeepVoxels deep_voxels(const VoxelLattice& lattice, const VoxelBits& set, const TriangleTree& tree,
                       double depth, const std::function<VoxelBits()>& met,
                       std::span<const Eigen::Vector3d> points);

}  // namespace tetproof::verify
