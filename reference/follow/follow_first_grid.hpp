// SPDX-License-Identifier: GPL-3.0-or-later
// The second part of following a trace: its first grid with the weights of step (v). Not installed.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "io/trace.hpp"
#include "reference/engine/adaptation/insertion.hpp"
#include "reference/follow/follow_points.hpp"

namespace tetproof::reference {

/// The records of step (v) of a trace, with their lines.
struct TraceStart {
  trace::FirstGrid first_grid;
  std::int64_t first_grid_line = 0;
  std::vector<trace::Weight> weights;
  std::vector<std::int64_t> lines;  ///< of the weights
  /// The position in `weights` for each tetrahedron, by the sorted numbers of its points. Filled by `adopt`.
  std::map<Corners, std::size_t> named;
};

/// Reads step (v) of a trace; `next` is its first record there, and afterwards the
/// first record of step (vi). Throws InputError if it has no step (v), and
/// Divergence if it has two `first_grid` records, or records of an earlier step.
TraceStart read_start(trace::Reader& reader, std::optional<trace::Record>& next);

/// Our first grid with the coordinates of the trace. Throws Divergence if its tetrahedra are not those of the
/// trace.
Grid adopt(const Grid& grid, TraceStart& start, TracePoints& points);

/// Throws Divergence at the first weight of the trace that differs from ours.
void compare_weights(const TraceStart& start, const Insertion& ours, const TracePoints& points);

/// The rounding error of an average error [length^3], which comes from the rounding of volumes. It matters
/// where the average is far below the mean volume.
double rounding_of_averages(const Insertion& insertion);
/// Whether two average errors agree up to rounding.
bool same_average(const Insertion& insertion, double a, double b);

}  // namespace tetproof::reference
