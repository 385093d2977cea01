// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's two readers have in common: cells and arrays as a file has them, and how they join a document.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {

/// Cells and arrays in VTK's terms, read from a file and not yet checked.
struct VtkPiece {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::int64_t> connectivity, ends;  ///< `ends`: of each cell in `connectivity`
  std::vector<std::int64_t> types;
  std::vector<Column> point_data, cell_data;
};

/// Appends a piece to the document. Polylines, strips, and cells of many vertices become as many elements as
/// they have parts; pixels and voxels quadrangles and hexahedra. Cells of types that no document has
/// (polyhedra, elements of order 3 and more) are left out with a warning. Cell data "entity" (or
/// "CellEntityIds", as Gmsh calls it) and "group", "group 2", ... become what their names say; strings become
/// integers with labels. `whole`: the file has this piece only, and numbers that no point has are kept.
/// InputError naming the cell where numbers contradict each other.
void add_vtk_piece(Document& document, VtkPiece&& piece, bool whole);

/// An array of neither points nor cells: a table with one column of the same name.
void add_vtk_field(Document& document, Column&& column);

}  // namespace tetproof::io
