// SPDX-License-Identifier: GPL-3.0-or-later
// A run as records of the trace (corpus/vectors/TRACE.md): its settings, the decisions of steps (i) to (iv),
// its end. The records of steps (v) and (vi) are in engine/adaptation/adaptation_records.hpp.
#pragma once

#include <functional>

#include "io/trace.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {

using Recorder = std::function<void(const trace::Record&)>;

/// The first record of the trace, from the options. The caller fills in the names of the program and the
/// surface.
trace::Settings settings_of(const Options& options, const TriangleSurface& surface);

/// The decisions of steps (i) to (iv), in the order of the format.
void record_lattice(const Lattice& lattice, const Recorder& record);
void record_characterization(const Lattice& lattice, const Indicators& indicators,
                             const SurfaceVertices& settled, const std::vector<Vertex>& mended,
                             const Recorder& record);
void record_rows(const Lattice& lattice, const Grid& grid, const Recorder& record);
void record_mapped(const std::vector<MappedPoint>& mapped, const Recorder& record);

/// The last record of the trace.
trace::Record end_of(const Generation& made);

}  // namespace tetproof::reference
