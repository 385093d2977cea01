// SPDX-License-Identifier: GPL-3.0-or-later
// The voxels whose centres are in one of several boxes. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {

/// Each box is given by its least and largest corners, and is enlarged by `room` [length] on all sides. A
/// centre within rounding of an enlarged box's side may count as inside or not; if `room` is 0, boxes are
/// closed and the answer is exact.
VoxelBits voxels_in_boxes(const std::vector<std::array<Eigen::Vector3d, 2>>& boxes, double room,
                          const VoxelLattice& lattice);

}  // namespace tetproof::verify
