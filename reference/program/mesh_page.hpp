// SPDX-License-Identifier: GPL-3.0-or-later
// The page of tetproof-mesh: the judge's page of the grid, and how the grid was made. Not installed.
#pragma once

#include <string>
#include <vector>

#include "reference/generate.hpp"
#include "verify/report_page.hpp"

namespace tetproof::reference {

/// What the page shows besides the report.
struct MeshPage {
  const Generation& made;
  const TriangleSurface& surface;
  std::string surface_name, grid_name;  ///< the second may be empty
  std::vector<double> e_avg;            ///< after each insertion and its flips, eq. (3.5) [length^3]
};

/// The grid with the surface in three dimensions, some tetrahedra of growing distance from the surface, plane
/// cuts across the three axes, the average error over the insertions, volumes over distance beside eq. (3.1),
/// and how often each row of Tables 2, 3 and 4 was used.
std::string mesh_page(const verify::Report& report, const MeshPage& page);

}  // namespace tetproof::reference
