// SPDX-License-Identifier: GPL-3.0-or-later
// The decisions of steps (v) and (vi) as records of the trace (corpus/vectors/TRACE.md).
#pragma once

#include <functional>

#include "io/trace.hpp"
#include "reference/engine/adaptation/improve.hpp"

namespace tetproof::reference {

/// Step (v): the record of the first grid, and one of the weight of each tetrahedron, are passed to `record`.
void record_first_grid(const WeightedGrid& grid, const Weighting& weighting, double mean_volume,
                       double e_avg_goal, const std::function<void(const trace::Record&)>& record);

/// Step (vi): the record of insertion number `n`, from 1, that splits the tetrahedron with these corners.
/// `e_avg` is E_avg after it.
trace::Record record_of(const Candidate& chosen, const std::array<Eigen::Vector3d, 4>& corners,
                        std::int64_t n, double e_avg);

/// Section 4: the record of a flip that has been made. `grid` is the grid after it.
trace::Record record_of(const Flip& flip, const WeightedGrid& grid, Criterion criterion);

}  // namespace tetproof::reference
