// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the volume inside a closed surface by counting voxels. This account shares nothing with the exact
// volumes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "io/error.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::verify {

struct VoxelSets;  // OpenVDB's trees, which this header does not include

/// The range of the number of voxels along the longest side.
inline constexpr int least_voxels = 2, most_voxels = 1024;

/// Cubes of one size that cover a surface's box and at least one layer around it, each inside or outside.
struct VoxelVolume {
  double inside = 0;  ///< volume of the voxels whose centre is inside [length^3]
  /// The volume of the voxels that the surface meets: |inside - enclosed volume| is at most this.
  double error_bound = 0;
  double voxel_size = 0;                             ///< side of a voxel [length]
  std::array<int, 3> voxels{};                       ///< along x, y, z
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< lower corner of voxel (0,0,0), exact
  std::int64_t inside_count = 0;                     ///< voxels whose centre is inside
  std::int64_t met_count = 0;                        ///< voxels that the surface meets
  std::shared_ptr<const VoxelSets> sets;             ///< the voxels that are inside, and those that are met
};

/// The surface is too large, too small or too far from the origin to lay these voxels in doubles.
struct VoxelRangeError : InputError {
  using InputError::InputError;
};

/// Counts about `voxels_along_longest_side` voxels along the longest side of the surface's box. Their size is
/// rounded up to 12 significant bits, so that planes and centres are exact.
///
/// A centre is inside if the surface encloses it an odd number of times, whatever the orientation, nesting or
/// thickness of the surface. The parity of crossings along the voxels' rows tells, and crossings are decided
/// exactly; a centre on the surface counts as inside or outside. A voxel that the surface does not meet is
/// wholly inside or wholly outside, as its centre is: hence the error bound. The difference from the account
/// with half as many voxels is an estimate of the error. The result is the same for any number of threads,
/// any numbering and any orientation.
///
/// The surface must be closed (`judge_surface`). InputError if a row shows that it is not, if it is empty,
/// not finite or as flat as a point, if it lies more than 1e10 voxels from the origin (`VoxelRangeError`), or
/// if the number of voxels is outside [least_voxels, most_voxels]. Memory: 2 bits a voxel while working, less
/// afterwards (34 MB with 512 cubed).
VoxelVolume voxel_volume(const TriangleSurface& surface, int voxels_along_longest_side);

/// Whether the centre of voxel (i,j,k) is inside. False outside the lattice.
bool is_inside(const VoxelVolume& volume, int i, int j, int k);
/// Whether the surface meets voxel (i,j,k), its faces included. May be true if it misses the voxel by at most
/// 1e-11 voxel sizes.
bool meets_surface(const VoxelVolume& volume, int i, int j, int k);
/// The centre of voxel (i,j,k), exact.
Eigen::Vector3d voxel_centre(const VoxelVolume& volume, int i, int j, int k);

}  // namespace tetproof::verify
