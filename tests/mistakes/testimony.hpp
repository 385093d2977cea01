// SPDX-License-Identifier: GPL-3.0-or-later
// What the comparison of two traces and the replay say about a page with a mistake.
#pragma once

#include <vector>

#include "reference/generate.hpp"
#include "tests/mistakes/mistaken.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::mistakes {

struct Testimony {
  std::vector<trace::Record> reference;  ///< of the fast engine, which makes no mistake
  std::vector<trace::Record> mistaken;   ///< of the page
  verify::TraceComparison comparison;    ///< of the two
  reference::Follow follow;              ///< of the page's decisions by the fast engine
};

/// Both engines on one surface; the page makes the mistake. The options must adapt the grid.
Testimony testify(const TriangleSurface& surface, const reference::Options& options, Mistake mistake);

}  // namespace tetproof::mistakes
