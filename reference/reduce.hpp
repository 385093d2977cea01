// SPDX-License-Identifier: GPL-3.0-or-later
// The reduction of the surface before the grid is made: the paper's reference [4], here by a library.
#pragma once

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// The surface with at most so many triangles: edges are collapsed, cheapest first (Lindstrom and Turk), as
/// long as the topology allows it, so that components, genus and closedness stay. Where it does not allow as
/// few, or the surface would intersect itself (it is thinner than the new triangles are long), the result has
/// more. Unchanged if it has no more to begin with, or if nothing can be taken away; otherwise without
/// parametric definition, since its vertices are new. Throws InputError for fewer than 4 triangles and for a
/// surface that is not finite, open or not 2-manifold.
TriangleSurface reduce(const TriangleSurface& surface, int triangles);

}  // namespace tetproof::reference
