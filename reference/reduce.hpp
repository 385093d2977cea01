// SPDX-License-Identifier: GPL-3.0-or-later
// The reduction of the surface to fewer triangles before the grid is made. The paper does it by its reference
// [4], this project by a library.
#pragma once

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// The surface, reduced to at most `triangles` triangles. Edges are collapsed, the cheapest first (Lindstrom
/// and Turk), and only where the topology permits: the surface keeps its components and its genus, and stays
/// closed. The result has more triangles than asked for where the topology permits no further collapse, or
/// where the surface would intersect itself (because it is thinner than the new triangles are long). A
/// surface that has few enough triangles, or of which nothing can be removed, is returned unchanged. Any
/// other result has no parametric definition, because its vertices are new. Throws InputError if `triangles`
/// is below 4, and for a surface that has a vertex that is not finite, is open, or is not 2-manifold.
TriangleSurface reduce(const TriangleSurface& surface, int triangles);

}  // namespace tetproof::reference
