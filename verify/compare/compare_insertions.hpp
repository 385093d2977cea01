// SPDX-License-Identifier: GPL-3.0-or-later
// Compares step (vi) and section 4 of two traces: insertions one by one, their flips, and the end.
#pragma once

#include "verify/compare/compare_first_grid.hpp"

namespace tetproof::verify {

/// Reads both traces up to the first difference or up to their ends, and fills in `result`. `steps` and
/// `first` belong to the reference; the new points are added to those of `first`.
void compare_insertions(TraceStream& other, TraceStream& reference, const FirstSteps& steps, FirstGrid& first,
                        TraceComparison& result);

}  // namespace tetproof::verify
