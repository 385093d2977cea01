// SPDX-License-Identifier: GPL-3.0-or-later
// One insertion with its flips, as a trace has it, and why two that differ may both be right.
#pragma once

#include <optional>

#include "verify/compare/compare_first_grid.hpp"

namespace tetproof::verify {

/// A flip by its points' numbers, however they are ordered.
using FlipKey = std::array<int, 6>;

struct Flipped {
  trace::Flip flip;
  FlipKey key;
  std::int64_t line;
};

/// An insertion and the flips that follow it.
struct Split {
  trace::Insertion insertion;
  std::int64_t line = 0;
  TetKey tet{};
  std::vector<int> replaced{};  ///< numbers of points, ascending
  int point = -1;               ///< the new point's number
  std::vector<Flipped> flips{};

  double e_avg() const { return flips.empty() ? insertion.e_avg : flips.back().flip.e_avg; }
};

/// What rounding is measured in.
struct Magnitudes {
  double length = 0;  ///< the magnitude of the coordinates
  double volume = 0;  ///< the mean volume of the first grid
};

/// Whether the split's pieces are so thin that rounding decides if it is refused (reading D18).
bool refused_by_rounding(const Split& split, const Magnitudes& sizes);

/// Two splits of one tetrahedron by the same row of Table 4 put their points in different edges or faces:
/// whether these are equally long or large.
bool equally_large(const Split& a, const Split& b, const Magnitudes& sizes);

/// Why two sequences of flips after the same insertion may differ at `at`; nothing if one of them is wrong.
std::optional<std::string> flips_tie(const Split& a, const Split& b, std::size_t at,
                                     const trace::Settings& settings, const Magnitudes& sizes);

}  // namespace tetproof::verify
