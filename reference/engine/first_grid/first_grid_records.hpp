// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's decisions of steps (i) to (iv), for the trace. Not installed.
#pragma once

#include "reference/engine/first_grid/extract.hpp"
#include "reference/trace/first_steps.hpp"

namespace tetproof::reference {

/// `mended`: the vertices of `settled` that rounding made so (reading D4).
FirstSteps first_steps(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
                       const std::vector<Vertex>& mended, const Grid& grid);

}  // namespace tetproof::reference
