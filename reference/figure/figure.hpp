// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's figures 3 to 6: a plane's cut through a grid, as an SVG picture.
#pragma once

#include <string>

#include "reference/figure/plane_cut.hpp"

namespace tetproof::reference {

enum class FigureColour {
  volume,  ///< in classes of powers of two of the grid's mean volume
  quality  ///< the smallest solid angle, as a part of the whole sphere (section 4)
};

struct FigureOptions {
  Plane plane{Eigen::Vector3d::UnitX(), 0};
  FigureColour colour = FigureColour::volume;
  std::string title;
};

/// The cut as SVG 1.1: tetrahedra's triangles and quadrilaterals by colour classes, the surface's outline
/// over them, a legend, and a caption that counts. The same input gives the same bytes. Throws InputError if
/// the plane misses the grid.
std::string figure(const TetMesh& mesh, const TriangleSurface& surface, const FigureOptions& options);

}  // namespace tetproof::reference
