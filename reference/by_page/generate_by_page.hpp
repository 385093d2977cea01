// SPDX-License-Identifier: GPL-3.0-or-later
// The grid as paper/ makes it. Not installed: `generate` calls it.
#pragma once

#include "reference/generate.hpp"

namespace tetproof::reference {

/// Steps (i) to (vi) by paper/. Every vertex of the surface must be a triangle's. Of `Generation::grid`,
/// `origins`, `sources` and `lattice_tet` stay empty.
Generation generate_by_page(const TriangleSurface& surface, const Options& options);

}  // namespace tetproof::reference
