// SPDX-License-Identifier: GPL-3.0-or-later
// The paper a second time, as naively as it can be written: every question is answered by going through
// everything. It shares no code with reference/ and is the witness that tells whether the trace and its
// comparison find what they claim.
#pragma once

#include <vector>

#include "io/tet_mesh.hpp"
#include "io/trace.hpp"
#include "io/triangle_surface.hpp"
#include "tests/second/settings.hpp"

namespace tetproof::second {

struct Run {
  TetMesh first;                       ///< after step (iv)
  TetMesh grid;                        ///< at the end
  std::vector<trace::Record> records;  ///< what `--trace` writes, in its order
  int mended = 0;                      ///< lattice vertices taken to the surface because of rounding (D4)
};

/// Steps (i) to (vi). The surface must be closed and free of self-intersections. Throws std::runtime_error
/// where a case comes up that this implementation does not cover.
Run run(const TriangleSurface& surface, const Settings& settings, const std::string& surface_name);

}  // namespace tetproof::second
