// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi) and section 4 of two traces: insertion by insertion, flips, and the end.
#pragma once

#include "verify/compare_first_grid.hpp"

namespace tetproof::verify {

/// Reads both traces to where they part, or to their ends, and tells `result`. `first`: the reference's first
/// grid, whose points get company.
void compare_insertions(TraceStream& other, TraceStream& reference, const trace::Settings& settings,
                        const Tolerance& tolerance, FirstGrid& first, TraceComparison& result);

}  // namespace tetproof::verify
