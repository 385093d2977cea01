// SPDX-License-Identifier: GPL-3.0-or-later
// Sound meshes of blocks and balls, to plant defects in.
#pragma once

#include <array>
#include <cstdint>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// A block of cells of size 1, each cut into six tetrahedra around its diagonal. `jitter`: how far each
/// coordinate is moved at random, of the cell's size; up to 0.1 all tetrahedra stay positive.
TetMesh block_mesh(std::array<int, 3> cells, double jitter = 0, std::uint64_t seed = 1);

/// A ball: an octahedron around an inner point, and further layers around it, each as octahedron of the next
/// size; 8 tetrahedra, and 24 for each further layer. `jitter` as above, of a layer's thickness.
TetMesh ball_mesh(int layers, double jitter = 0, std::uint64_t seed = 1);

/// The same mesh in another size, at another place: points * scale + shift.
TetMesh moved(TetMesh mesh, double scale, const Eigen::Vector3d& shift);

}  // namespace tetproof::corpus
