// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a trace that is being followed through step (vi), and the replay of one insertion with its
// flips. Not installed.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "reference/follow/follow.hpp"
#include "reference/follow/follow_first_grid.hpp"

namespace tetproof::reference {

/// Our own run, kept in step with the trace.
struct Replay {
  const AdaptOptions& options;
  trace::Reader& reader;
  TracePoints points;
  Follow& outcome;
  std::optional<trace::Record> record;  ///< the next record of the trace; none: the file has ended
  std::optional<Insertion> insertion;
  std::map<Corners, Index> tets;  ///< the number of each present tetrahedron, by its sorted corners

  void next() { record = reader.next(); }
  const WeightedGrid& weighted() const { return insertion->grid(); }
  const Triangulation& grid() const { return insertion->grid().grid(); }
  /// Enters the tetrahedra with the numbers from `first` on into `tets`.
  void add_tets_from(Index first) {
    for (Index t = first; t < grid().numbers(); ++t) tets.emplace(sorted(grid().corners(t)), t);
  }
  bool same_average(double a, double b) const { return reference::same_average(*insertion, a, b); }
  /// The largest average error that still ties with `e_avg`.
  double just_above(double e_avg) const { return e_avg * (1 + tie) + rounding_of_averages(*insertion); }
};

/// Checks one insertion of the trace and makes it, with the flips that follow it. Throws Divergence if it, or
/// one of the flips, is not admissible.
void replay_insertion(Replay& replay, const trace::Insertion& theirs);

/// Checks the flips of the trace after insertion `n` and makes them: each must be the best one (readings D21,
/// D22), and none may be missing. `set` is the set O_i. Throws Divergence.
void replay_flips(Replay& replay, std::vector<Index> set, std::int64_t n);

}  // namespace tetproof::reference
