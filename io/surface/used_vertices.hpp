// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of a surface that count: those that a triangle names.
#pragma once

#include <optional>

#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// The surface without the vertices that no triangle names, in the same order; nothing if there are none.
/// Such a vertex is no point of the surface: it must not change the box, or the distance to the
/// surface's vertices. Triangles must name vertices that exist.
std::optional<TriangleSurface> without_unused_vertices(const TriangleSurface& surface);
/// The same; `numbering` becomes that of the surface that is returned.
std::optional<TriangleSurface> without_unused_vertices(const TriangleSurface& surface,
                                                       SurfaceNumbering& numbering);

}  // namespace tetproof::io
