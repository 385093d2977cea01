// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the trace of another implementation: replays its decisions of step (vi) and checks each of them.
#pragma once

#include <string>

#include "reference/engine/adaptation/adapt.hpp"

namespace tetproof::reference {

/// The result of following a trace.
struct Follow {
  /// Whether eq. (3.5), Table 4, section 4 and the readings allow every decision of the trace.
  bool admissible = true;
  std::int64_t line = 0;  ///< the line of the trace with the first decision that is not admissible
  std::string what;       ///< that decision, and what the method does instead
  std::int64_t ties = 0;  ///< decisions that differ from ours but are as good, to a relative 1e-12
};

/// Replays steps (v) and (vi) of the trace at `path` (corpus/vectors/TRACE.md) on the first grid, up to the
/// first decision that is not admissible. A point of the trace is identified with a point of our grid if they
/// are closer than 1e-9 of the grid's diagonal. From then on the coordinates of the trace are used, so that
/// both sides decide with the same numbers. Throws InputError if the file is not a trace, or has no step (v).
Adaptation follow(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                  const TrueSurface* true_surface, const trace::Settings& settings, const std::string& path,
                  const Listener& listener, Follow& outcome);

}  // namespace tetproof::reference
