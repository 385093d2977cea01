// SPDX-License-Identifier: GPL-3.0-or-later
// Tells root causes from consequences. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/checks/suspects.hpp"

namespace tetproof::verify {

/// So many findings of a check are reported; the others are counted.
inline constexpr std::size_t most_findings = 100;

/// A number for each check.
using CheckCounts = std::array<std::int64_t, check_count>;

/// Goes through all checks of a report in their order and turns their suspects into findings. `suspects` has
/// one entry for each check; those of skipped checks are empty. A suspect is a consequence of the cause that
/// it names. A suspect that names none is a consequence of an earlier check's finding if the table in
/// root_causes.cpp says that the one can cause the other, and they share a tetrahedron, an edge or a vertex.
/// Returns for each check how many of its consequences have a cause among the `allowed` checks.
CheckCounts separate_causes(const TetMesh& mesh, const std::vector<Suspects>& suspects,
                            const std::array<bool, check_count>& allowed, Report& report);

}  // namespace tetproof::verify
