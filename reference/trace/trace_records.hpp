// SPDX-License-Identifier: GPL-3.0-or-later
// What each step decided, as records of the trace (corpus/vectors/TRACE.md).
#pragma once

#include <functional>

#include "io/trace.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {

using Recorder = std::function<void(const trace::Record&)>;

/// The options as the trace's first record; the program and the surface are for the caller to name.
trace::Settings settings_of(const Options& options, const TriangleSurface& surface);

/// Steps (i) to (iv), in the order of the format.
void record_lattice(const Lattice& lattice, const Recorder& record);
void record_characterization(const Lattice& lattice, const Indicators& indicators,
                             const SurfaceVertices& settled, const std::vector<Vertex>& mended,
                             const Recorder& record);
void record_rows(const Lattice& lattice, const Grid& grid, const Recorder& record);
void record_mapped(const std::vector<MappedPoint>& mapped, const Recorder& record);

/// Step (v).
void record_first_grid(const WeightedGrid& grid, const Weighting& weighting, double mean_volume,
                       const Recorder& record);

/// Step (vi).
trace::Record record_of(const Candidate& chosen, const std::array<Eigen::Vector3d, 4>& corners,
                        std::int64_t n, double e_avg);
trace::Record record_of(const Flip& flip, const WeightedGrid& grid, Criterion criterion);
trace::Record end_of(const Generation& made);

}  // namespace tetproof::reference
