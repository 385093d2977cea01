// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the tetrahedra that contain given points, exactly. Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// For each point, the tetrahedra that contain it inside or on their boundary, ascending. Flat and `excluded`
/// tetrahedra (empty: none) contain nothing; negative ones count like positive ones.
std::vector<std::vector<Index>> tets_at(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                                        std::span<const Eigen::Vector3d> points);

}  // namespace tetproof::verify
