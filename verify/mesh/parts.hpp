// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a mesh that faces connect. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/mesh/faces.hpp"

namespace tetproof::verify {

/// The part of each tetrahedron: two tetrahedra belong to one part if a chain of common faces connects them,
/// or of pairs in `also`. Parts are numbered from 0 by their first tetrahedra; `excluded` tetrahedra (empty:
/// none) have -1. Sorts all faces: 16 bytes for each.
std::vector<Index> parts_of(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                            std::span<const std::array<FaceId, 2>> also);

}  // namespace tetproof::verify
