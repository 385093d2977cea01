// SPDX-License-Identifier: GPL-3.0-or-later
// Another implementation's decisions of step (vi), replayed and checked one by one.
#pragma once

#include <string>

#include "reference/engine/adaptation/adapt.hpp"

namespace tetproof::reference {

/// What following a trace came to.
struct Follow {
  bool admissible =
      true;               ///< every decision is one that eq. (3.5), Table 4, section 4 and the readings allow
  std::int64_t line = 0;  ///< of the trace, where the first that is not stands
  std::string what;       ///< which decision, and what the method asks for
  std::int64_t ties = 0;  ///< decisions that differ from ours and are as good to 1e-12, relative
};

/// Replays steps (v) and (vi) of a trace (corpus/vectors/TRACE.md) on the first grid, up to the first
/// decision that is not admissible. Points of the trace are those of our grid if they are closer than 1e-9 of
/// its diagonal; from then on the trace's coordinates are used, so that both sides decide with the same
/// numbers. Throws InputError for a file that is no trace, or one without step (v).
Adaptation follow(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                  const TrueSurface* true_surface, const trace::Settings& settings, const std::string& path,
                  const Listener& listener, Follow& outcome);

}  // namespace tetproof::reference
