// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra that stand several times, each time with points of their own. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// Finds sets of tetrahedra whose four vertices have the same coordinates, but not the same numbers. Each set
/// ascends; the sets are sorted by their first tetrahedron. Of tetrahedra with the same four numbers only the
/// first is listed. `same_place`: sets of points with equal coordinates, each ascending; without any, nothing
/// is searched. The `excluded` tetrahedra (empty: none) are left out.
std::vector<std::vector<Index>> find_copies(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded,
                                            const std::vector<std::vector<Index>>& same_place);

}  // namespace tetproof::verify
