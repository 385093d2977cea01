// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a comparison as a page of HTML: what differs, with both sides in place.
#pragma once

#include <string>

#include "io/triangle_surface.hpp"
#include "verify/compare_grids.hpp"
#include "verify/compare_traces.hpp"

namespace tetproof::verify {

/// The place where two traces part: both records as a table, and the tetrahedra, faces and points that they
/// name in three dimensions, each side in its colour; with the surface, if one is given. Like all pages, it
/// is one file that opens from disk, and the same input gives the same bytes.
std::string comparison_page(const TraceComparison& comparison, const TriangleSurface* surface = nullptr);

/// What only one of two grids has: the first of it as tables and in three dimensions.
std::string comparison_page(const GridComparison& comparison);

}  // namespace tetproof::verify
