// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether two splits that differ may both be right: a tie, or a decision of rounding.
#pragma once

#include "verify/compare/trace_splits.hpp"

namespace tetproof::verify {

/// The magnitudes that rounding errors are relative to.
struct Magnitudes {
  double length = 0;  ///< the magnitude of the coordinates [length]
  double volume = 0;  ///< the mean volume of the first grid [length^3]
};

/// The tetrahedra that an insertion makes, before any flip.
std::vector<trace::Tet> pieces(const trace::Insertion& insertion);

/// Whether a piece of the split is so thin that rounding decides if the split is refused (reading D18).
bool refused_by_rounding(const Split& split, const Magnitudes& sizes);

/// For two splits of one tetrahedron by the same row of Table 4 whose points lie in different edges or faces:
/// whether these edges are equally long, or these faces equally large.
bool equally_large(const Split& a, const Split& b, const Magnitudes& sizes);

}  // namespace tetproof::verify
