// SPDX-License-Identifier: GPL-3.0-or-later
// Suspects: all that one check found, before root causes are told from consequences. Internal.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "verify/report.hpp"

namespace tetproof::verify {

/// A finding of another check, by its position among that check's suspects.
struct Cause {
  Check check;
  std::size_t suspect;
};

struct Suspects {
  std::size_t count = 0;
  /// The tetrahedra, vertices and faces of the i-th suspect.
  std::function<Finding(std::size_t)> finding = nullptr;
  /// Completes the finding of the i-th suspect. Called only for the suspects that are reported; null if their
  /// findings are complete.
  std::function<void(std::size_t, Finding&)> describe = nullptr;
  std::size_t beyond = 0;  ///< further suspects, which were counted and not kept
  /// The known cause of the i-th suspect: a hanging node, crossed diagonals, a crack, a region. Null if no
  /// cause is known for any.
  std::function<std::optional<Cause>(std::size_t)> cause = nullptr;

  /// Names a cause for the suspects for which none is known.
  void add_cause(std::function<std::optional<Cause>(std::size_t)> more) {
    if (!cause) {
      cause = std::move(more);
      return;
    }
    cause = [first = std::move(cause), more = std::move(more)](std::size_t i) {
      const std::optional<Cause> known = first(i);
      return known ? known : more(i);
    };
  }

  /// Suspects whose findings are complete.
  static Suspects complete(std::vector<Finding> findings) {
    const std::size_t count = findings.size();
    return {.count = count,
            .finding = [findings = std::move(findings)](std::size_t i) { return findings[i]; }};
  }
};

}  // namespace tetproof::verify
