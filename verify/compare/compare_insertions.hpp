// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi) and section 4 of two traces: insertion by insertion, flips, and the end.
#pragma once

#include "verify/compare/compare_first_grid.hpp"

namespace tetproof::verify {

/// Reads both traces to where they part, or to their ends, and tells `result`. `steps` and `first`: the
/// reference's; the first grid's points get company.
void compare_insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
                        TraceComparison& result);

}  // namespace tetproof::verify
