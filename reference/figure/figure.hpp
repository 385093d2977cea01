// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a grid as SVG, in the manner of the paper's figures 3 to 6: the cut of a plane, and the grid
// cut open, with whole tetrahedra.
#pragma once

#include <optional>
#include <string>

#include "reference/figure/plane_cut.hpp"

namespace tetproof::reference {

enum class FigureColour {
  volume,  ///< volume over the grid's mean volume, in classes bounded by powers of two
  quality  ///< the smallest solid angle, as a fraction of 4 pi (section 4)
};

struct FigureOptions {
  Plane plane{Eigen::Vector3d::UnitX(), 0};
  /// The direction from which the grid, cut open by the plane, is seen; of any length. Without it, the figure
  /// shows the plane's cut.
  std::optional<Eigen::Vector3d> view{};
  FigureColour colour = FigureColour::volume;
  std::string title{};
};

/// Reads a direction: "3d", which shows three sides of a box, or "X,Y,Z". Throws InputError for any other
/// text, and for a direction of length 0.
Eigen::Vector3d parse_view(const std::string& text);

/// The plane through the middle of the surface's box that is normal to the axis nearest to the direction; of
/// several axes the first.
Plane plane_for_view(const Eigen::Vector3d& view, const TriangleSurface& surface);

/// The figure as SVG 1.1, with a legend and a caption. The same input gives the same bytes. Throws InputError
/// if there is nothing to draw.
///
/// Without a view: the triangles and quadrilaterals in which the plane cuts the tetrahedra, coloured by
/// class; over them the outline of the surface.
///
/// With a view, in parallel projection: the tetrahedra that are wholly on the plane's far side
/// (cut_open.hpp), coloured by class, their faces on the surface in a colour of their own, and the outline of
/// the part of the surface that is on the near side. If the plane is seen from the edge, its positive side is
/// the near one.
std::string figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options);

}  // namespace tetproof::reference
