// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the flips that two traces make after the same insertion, and checks what they say of themselves.
#pragma once

#include "verify/compare/tolerance.hpp"
#include "verify/compare/trace_splits.hpp"

namespace tetproof::verify {

/// "2-3 flip of the face A B C and the edge D E", each point by its coordinates.
std::string says(const trace::Flip& flip);

/// The tetrahedra that a flip replaces, and those that it makes.
std::vector<TetKey> old_tets(const FlipKey& flip);
std::vector<TetKey> new_tets(const FlipKey& flip);

/// What is wrong with the qualities that a flip states, as its points give them; empty if nothing is.
/// `improve`: the measure, as in `trace::Settings`.
std::string wrong_quality(const trace::Flip& flip, const std::string& improve, const Tolerance& tolerance);

/// Two traces whose flips after insertion n differ at position `at`: `a` is the reference's split.
struct FlipDifference {
  std::string what;  ///< which flip, and what each trace does there
  Says reference, other;
};
FlipDifference flip_difference(std::int64_t n, std::size_t at, const Split& a, const Split& b);

}  // namespace tetproof::verify
