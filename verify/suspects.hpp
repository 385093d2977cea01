// SPDX-License-Identifier: GPL-3.0-or-later
// From what the checks suspect to what the report says: root causes first, what follows from them under them.
// Internal.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Everything one check found, not yet told apart into causes and consequences.
struct Suspects {
  std::size_t count = 0;
  std::function<Finding(std::size_t)> finding = nullptr;  ///< tetrahedra, vertices and faces of the i-th
  std::function<void(std::size_t, Finding&)> describe =
      nullptr;             ///< adds the rest; called for those that are reported
  std::size_t beyond = 0;  ///< more that were counted and not kept
};

inline constexpr std::size_t most_findings = 100;

/// Settles all checks of a report in their order. `suspects` has one entry for each check; those of skipped
/// checks are empty. A suspect follows from an earlier check's finding if the table in suspects.cpp says that
/// the one can cause the other, and they share a tetrahedron, or a vertex.
void settle(const TetMesh& mesh, std::vector<Suspects>& suspects, Report& report);

}  // namespace tetproof::verify
