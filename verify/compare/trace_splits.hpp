// SPDX-License-Identifier: GPL-3.0-or-later
// An insertion with its flips, read from a trace.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "verify/compare/trace_differences.hpp"
#include "verify/compare/trace_points.hpp"

namespace tetproof::verify {

/// A tetrahedron as the numbers of its four points, ascending.
using TetKey = std::array<int, 4>;
TetKey sorted(std::array<int, 4> points);

/// A flip as its points' numbers: the face's three, ascending; the edge's two, ascending; 1 for a 2-3 flip.
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

  /// After the last flip.
  double e_avg() const { return flips.empty() ? insertion.e_avg : flips.back().flip.e_avg; }
};

/// The number of the new point of the other trace's insertion into this tetrahedron; -1 if there is none yet.
using PartnerPoint = std::function<int(const TetKey&)>;

/// Reads insertion n with its flips; nothing at the end of the insertions. The new point gets its partner's
/// number, or a new one. Throws InputError for a record out of order.
std::optional<Split> read_split(TraceStream& stream, Side side, std::int64_t n, TracePoints& points,
                                const PartnerPoint& partner);

}  // namespace tetproof::verify
