// SPDX-License-Identifier: GPL-3.0-or-later
// The account of each region of a mesh. Internal.
#pragma once

#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// `regions` names the region of each tetrahedron; those that are excluded (empty: none) belong to none. By
/// their tags; empty for fewer than two. Linear time, however many regions there are.
std::vector<RegionAccount> account_of_regions(const TetMesh& mesh, const std::vector<std::int64_t>& regions,
                                              const std::vector<std::uint8_t>& excluded);

}  // namespace tetproof::verify
