// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the flips that two traces make after the same insertion.
#pragma once

#include "verify/compare/compare_splits.hpp"

namespace tetproof::verify {

/// "2-3 flip of the face A B C and the edge D E", each point by its coordinates.
std::string says(const trace::Flip& flip);

/// The first flip that differs.
struct FlipDifference {
  std::string what;  ///< which flip, and what each trace does there
  Says reference, other;
  /// Why both may be right: equally good flips, or a decision of rounding. Absent: one of them is wrong.
  std::optional<std::string> tie;
};

/// Whether both traces make the same flips, in whatever order.
bool same_flips(const Split& a, const Split& b);

/// Finds the first flip that differs after insertion n; `a` is the reference's split, `b` the other's. Only
/// for splits whose flips are not the same.
FlipDifference first_flip_difference(std::int64_t n, const Split& a, const Split& b,
                                     const trace::Settings& settings, const Magnitudes& sizes);

}  // namespace tetproof::verify
