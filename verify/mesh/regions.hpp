// SPDX-License-Identifier: GPL-3.0-or-later
// An account of each region of a mesh: its counts, volume and shape. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// `regions` holds the region's tag of each tetrahedron; `excluded` tetrahedra (empty: none) belong to no
/// region. The accounts are sorted by tag. The result is empty if there are fewer than two regions. Takes O(n
/// log n) time for n tetrahedra, however many regions there are.
std::vector<RegionAccount> account_of_regions(const TetMesh& mesh, const std::vector<std::int64_t>& regions,
                                              const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
