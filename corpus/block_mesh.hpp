// SPDX-License-Identifier: GPL-3.0-or-later
// Sound meshes of blocks and balls, in which defects are planted.
#pragma once

#include <array>
#include <cstdint>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// A block of cells of size 1, each cut into six tetrahedra around its diagonal. Each coordinate is moved at
/// random by at most `jitter` cell sizes; up to 0.1 all tetrahedra stay positive.
TetMesh block_mesh(std::array<int, 3> cells, double jitter = 0, std::uint64_t seed = 1);

/// A ball: an octahedron around an inner point, then more layers around it, which end at octahedra of size 2,
/// 3, ... It has 8 tetrahedra, and 24 more for each further layer. Each coordinate is moved at random by at
/// most `jitter` thicknesses of a layer.
TetMesh ball_mesh(int layers, double jitter = 0, std::uint64_t seed = 1);

/// The mesh scaled and then shifted: points * scale + shift.
TetMesh moved(TetMesh mesh, double scale, const Eigen::Vector3d& shift);

}  // namespace tetproof::corpus
