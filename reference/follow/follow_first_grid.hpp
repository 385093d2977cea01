// SPDX-License-Identifier: GPL-3.0-or-later
// The first half of following a trace: its settings, and its first grid with the weights of step (v). Not
// installed.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "io/trace.hpp"
#include "reference/engine/adaptation/insertion.hpp"
#include "reference/follow/follow_points.hpp"

namespace tetproof::reference {

/// The content of a trace up to its first decision of step (vi).
struct TraceStart {
  trace::FirstGrid first_grid;
  std::vector<trace::Weight> weights;
  /// The position in `weights` for each tetrahedron, by the sorted numbers of its points. Filled by `adopt`.
  std::map<Corners, std::size_t> named;
  std::optional<trace::Record> next;  ///< the first record of step (vi)
};

/// Reads the start of a trace. Throws Divergence if its settings are not those of our run, InputError if it
/// has no step (v).
TraceStart read_start(trace::Reader& reader, const trace::Settings& ours);

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
