// SPDX-License-Identifier: GPL-3.0-or-later
// Following a trace, first half: its settings and its first grid with the weights of step (v). Not installed.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "io/trace.hpp"
#include "reference/engine/adaptation/insertion.hpp"
#include "reference/follow/follow_points.hpp"

namespace tetproof::reference {

/// What a trace says up to its first decision of step (vi).
struct TraceStart {
  trace::FirstGrid first_grid;
  std::vector<trace::Weight> weights;
  std::map<Corners, std::size_t>
      named;  ///< each weight by the sorted points of its tetrahedron, once `adopt` knows them
  std::optional<trace::Record> next;  ///< the first record of step (vi)
};

/// Reads it. Throws Divergence where the settings are not those of our run, InputError without step (v).
TraceStart read_start(trace::Reader& reader, const trace::Settings& ours);

/// Our first grid with the trace's coordinates. Throws Divergence if its tetrahedra are not those of the
/// trace.
Grid adopt(const Grid& grid, TraceStart& start, TracePoints& points);

/// Throws Divergence at the first weight that is not ours.
void compare_weights(const TraceStart& start, const Insertion& ours, const TracePoints& points);

/// Whether two average errors agree: one far below the mean volume is known to the rounding of volumes only.
double rounding_of_averages(const Insertion& insertion);
bool same_average(const Insertion& insertion, double a, double b);

}  // namespace tetproof::reference
