// SPDX-License-Identifier: GPL-3.0-or-later
// Why two splits that differ may both be right: ties and decisions of rounding.
#pragma once

#include "verify/compare/trace_splits.hpp"

namespace tetproof::verify {

/// What rounding is measured in.
struct Magnitudes {
  double length = 0;  ///< the magnitude of the coordinates
  double volume = 0;  ///< the mean volume of the first grid
};

/// The tetrahedra that an insertion makes, before any flip.
std::vector<trace::Tet> pieces(const trace::Insertion& insertion);

/// Whether the split's pieces are so thin that rounding decides if it is refused (reading D18).
bool refused_by_rounding(const Split& split, const Magnitudes& sizes);

/// Two splits of one tetrahedron by the same row of Table 4 put their points in different edges or faces:
/// whether these are equally long or large.
bool equally_large(const Split& a, const Split& b, const Magnitudes& sizes);

}  // namespace tetproof::verify
