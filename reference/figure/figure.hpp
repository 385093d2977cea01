// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a plane's cut through a grid, as SVG, in the manner of the paper's figures 3 to 6.
#pragma once

#include <string>

#include "reference/figure/plane_cut.hpp"

namespace tetproof::reference {

enum class FigureColour {
  volume,  ///< volume over the grid's mean volume, in classes bounded by powers of two
  quality  ///< the smallest solid angle, as a fraction of 4 pi (section 4)
};

struct FigureOptions {
  Plane plane{Eigen::Vector3d::UnitX(), 0};
  FigureColour colour = FigureColour::volume;
  std::string title;
};

/// The cut as SVG 1.1: the triangles and quadrilaterals in which the plane cuts the tetrahedra, coloured by
/// class; over them the outline of the surface; a legend; and a caption with the numbers of polygons. The
/// same input gives the same bytes. Throws InputError if the plane misses the grid.
std::string figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options);

}  // namespace tetproof::reference
