// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's voxels, made once for all that ask for them. Internal.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "verify/voxel_volume.hpp"
#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {

/// A closed surface in the lattice that `lay_voxels` lays over it.
struct SurfaceVoxels {
  VoxelLattice lattice;
  VoxelBits inside;    ///< voxels whose centres are inside
  VoxelBits met;       ///< voxels that the surface meets
  VoxelVolume volume;  ///< what they add up to
  /// How much the inside volume differs from that of half as many voxels. Their lattice has planes of its own
  /// (the phases of `VoxelLattice` are parts of its voxels), so its voxels are not made of these ones. Absent
  /// where the half is below `least_voxels`.
  std::optional<double> error_estimate;
};

/// Keeps the voxels that were made last. May be asked from several threads.
class KeptVoxels {
 public:
  /// The voxels of `surface`, which is the same in every call. Throws as `voxel_volume`.
  std::shared_ptr<const SurfaceVoxels> of(const TriangleSurface& surface, int voxels_along_longest_side);

 private:
  std::mutex mutex_;
  int number_ = 0;
  std::shared_ptr<const SurfaceVoxels> voxels_;
};

}  // namespace tetproof::verify
