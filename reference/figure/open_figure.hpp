// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of figures. Not installed.
#pragma once

#include "reference/figure/figure.hpp"

namespace tetproof::reference {

inline constexpr int drawing_side = 760;  ///< pixels along the longer side of a drawing
/// The colours of edges of tetrahedra, and of lines on the surface.
inline constexpr const char *edge_colour = "#16323d", *surface_line = "#c00020";

/// The figure of a grid that is cut open. `options.view` is set.
std::string open_figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options);

}  // namespace tetproof::reference
