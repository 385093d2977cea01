// SPDX-License-Identifier: GPL-3.0-or-later
// The decisions of steps (i) to (iv) as records of the trace (corpus/vectors/TRACE.md), for both engines.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/trace.hpp"
#include "reference/options.hpp"

namespace tetproof::reference {

/// What steps (i) to (iv) decided, by lattice vertex (reading D3).
struct FirstSteps {
  std::array<int, 3> cells;
  const std::array<std::vector<double>, 3>& planes;  ///< the coordinates of the lattice planes [length]
  std::vector<int> initial, after;                   ///< the indicators before and after Table 3
  std::map<int, trace::Point> settled;               ///< vertices that are 0 for good, and their places
  std::set<int> mended;                              ///< those that rounding made so
  std::map<std::pair<int, int>, trace::Point> cuts;  ///< of the edges between -1 and +1, lower vertex first
  std::vector<std::string> rows;  ///< of Table 2, for each lattice tetrahedron; "5-" is reading D10's
};

/// Gives the records to `record`, in the order of the format. Does nothing if `record` is empty.
void record_first_steps(const FirstSteps& steps, const Recorder& record);

}  // namespace tetproof::reference
