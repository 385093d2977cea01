// SPDX-License-Identifier: GPL-3.0-or-later
// The exact orientation of every tetrahedron. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

struct Orientations {
  std::vector<Index> negative, flat;  ///< ascending
};

/// Finds the tetrahedra for which (b-a) x (c-a) . (d-a) is negative or zero, exactly. Leaves out the
/// `excluded` tetrahedra (empty: none); all others must name finite points.
Orientations orientations(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
