// SPDX-License-Identifier: GPL-3.0-or-later
// The same surface given to the second implementation and to the reference, and what the comparison of the
// two traces and the replay of the second's decisions say.
#pragma once

#include <string>
#include <vector>

#include "io/trace.hpp"
#include "reference/follow/follow.hpp"
#include "reference/generate.hpp"
#include "tests/second/second.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::second {

struct Testimony {
  Run second;
  std::vector<trace::Record> reference;
  verify::TraceComparison comparison;
  reference::Follow
      follow;  ///< of step (vi), on the reference's first grid; admissible without a word if there is none
  bool followed = false;  ///< is there a step (vi) to follow
};

/// `settings.mistake` is the second's; the reference makes none.
Testimony testify(const TriangleSurface& surface, const Settings& settings);

reference::Options reference_options(const Settings& settings);

}  // namespace tetproof::second
