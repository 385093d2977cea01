// SPDX-License-Identifier: GPL-3.0-or-later
// The inside volume of a closed surface by counting voxels: an account that shares nothing with the exact
// volumes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "io/error.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::verify {

struct VoxelSets;  // OpenVDB's trees, which stay out of this header

/// The number of voxels along the longest side must be in this range.
inline constexpr int least_voxels = 2, most_voxels = 1024;

/// Cubes of one size laid over a surface's box, with at least one layer around it, and what each of them is.
struct VoxelVolume {
  double inside = 0;  ///< volume of the voxels whose centre is inside [length^3]
  /// |inside - enclosed volume| is at most this: the volume of the voxels that the surface meets
  double error_bound = 0;
  double voxel_size = 0;                             ///< side of a voxel [length]
  std::array<int, 3> voxels{};                       ///< along x, y, z
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< lower corner of voxel (0,0,0), exact
  std::int64_t inside_count = 0;                     ///< voxels whose centre is inside
  std::int64_t met_count = 0;                        ///< voxels that the surface meets
  std::shared_ptr<const VoxelSets> sets;             ///< which they are
};

/// Counts about `voxels_along_longest_side` voxels along the longest side of the surface's box (their size is
/// rounded up to 12 significant bits, so that planes and centres are exact).
///
/// A centre is inside if the surface encloses it an odd number of times, whatever its orientation, nesting or
/// thickness: the parity of exactly decided crossings along the voxels' rows (a centre on the surface counts
/// as one or the other). A voxel that the surface does not meet is wholly inside or wholly outside, as its
/// centre is: hence the bound. The difference to the account with half as many voxels is an estimate of the
/// error beside it. Same result for any number of threads, any numbering and any orientation.
///
/// Doubles cannot lay these voxels: the surface is too large, too small or too far from the origin for them.
struct VoxelRangeError : InputError {
  using InputError::InputError;
};

/// The surface must be closed (`judge_surface`). InputError if a row shows that it is not, if it is empty,
/// not finite or flat as a point, lies more than 1e10 voxels from the origin, or if the number of voxels is
/// outside [least_voxels, most_voxels]. Memory: 2 bits a voxel while working, less after (34 MB with 512
/// cubed).
VoxelVolume voxel_volume(const TriangleSurface& surface, int voxels_along_longest_side);

/// Is the centre of voxel (i,j,k) inside? False outside the lattice.
bool is_inside(const VoxelVolume& volume, int i, int j, int k);
/// Is voxel (i,j,k), taken with its faces, among those the surface meets (a superset, by at most 1e-11 voxel
/// sizes)?
bool meets_surface(const VoxelVolume& volume, int i, int j, int k);
/// The centre of voxel (i,j,k), exact.
Eigen::Vector3d voxel_centre(const VoxelVolume& volume, int i, int j, int k);

}  // namespace tetproof::verify
