// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the trace of another implementation: replays its decisions of step (vi) and checks each of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/engine/adaptation/adapt.hpp"

namespace tetproof::reference {

/// The result of following a trace.
struct Follow {
  /// Whether eq. (3.5), Table 4, section 4 and the readings allow every decision of the trace.
  bool admissible = true;
  std::int64_t line = 0;  ///< the line of the trace with the first decision that is not admissible
  std::string what;       ///< that decision, and what the method does instead
  std::int64_t ties = 0;  ///< decisions that differ from ours but are as good, to a relative 1e-12
  /// Kinds of records of steps (i) to (iv) that the trace leaves out, so that they were not checked.
  std::vector<std::string> not_checked;
};

/// Our own run up to the first grid, beside which a trace is checked.
struct OwnRun {
  const Grid& grid;  ///< the first grid
  const TriangleSurface& surface;
  const TrueSurface* true_surface;         ///< may be null
  trace::Settings settings;                ///< what was asked for
  std::vector<trace::Record> first_steps;  ///< the records of steps (i) to (iv)
};

/// Checks the trace at `path` (corpus/vectors/TRACE.md) from its first record to its last, or up to the first
/// decision that is not admissible. Steps (i) to (iv) must be those of our run. Steps (v) and (vi) are
/// replayed on its first grid: every point and every tetrahedron that the trace names must be there, and
/// every number that it states is computed again. A point of the trace is identified with a point of our grid
/// if they are closer than 1e-9 of the grid's diagonal; from then on the coordinates of the trace are used,
/// so that both sides decide with the same numbers. `options` null: the grid is not adapted, and the trace
/// must say so. Returns the adapted grid. Throws InputError if the file is not a trace, or has no step (v)
/// although it must.
std::optional<Adaptation> follow(const OwnRun& own, const AdaptOptions* options, const std::string& path,
                                 const Listener& listener, Follow& outcome);

}  // namespace tetproof::reference
