// SPDX-License-Identifier: GPL-3.0-or-later
// From what the checks suspect to what the report says: root causes first, what follows from them under them.
// Internal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// A finding of another check, by its position among what that check found.
struct Cause {
  Check check;
  std::size_t suspect;
};

/// Everything one check found, not yet told apart into causes and consequences.
struct Suspects {
  std::size_t count = 0;
  std::function<Finding(std::size_t)> finding = nullptr;  ///< tetrahedra, vertices and faces of the i-th
  std::function<void(std::size_t, Finding&)> describe =
      nullptr;             ///< adds the rest; called for those that are reported
  std::size_t beyond = 0;  ///< more that were counted and not kept
  std::function<std::optional<Cause>(std::size_t)> cause =
      nullptr;  ///< of the i-th, where it is known: a hanging node, crossed diagonals, a crack
};

inline constexpr std::size_t most_findings = 100;

/// Settles all checks of a report in their order. `suspects` has one entry for each check; those of skipped
/// checks are empty. A suspect follows from the cause that it names; otherwise it follows from an
/// earlier check's finding if the table in suspects.cpp says that
/// the one can cause the other, and they share a tetrahedron, or a vertex.
void settle(const TetMesh& mesh, std::vector<Suspects>& suspects, Report& report);

}  // namespace tetproof::verify
