// SPDX-License-Identifier: GPL-3.0-or-later
// Which of VTK's cells is which of Gmsh's elements.
#pragma once

#include <cstddef>
#include <cstdint>

#include "io/document.hpp"

namespace tetproof::io {

/// VTK's numbers of cells that are several elements, or one after a change of order.
enum VtkCellType : std::int64_t {
  vtk_poly_vertex = 2,
  vtk_poly_line = 4,
  vtk_strip = 6,
  vtk_polygon = 7,
  vtk_pixel = 8,
  vtk_voxel = 11
};

/// How VTK has the elements of a block: its number of the cell type, and how many of their nodes (all, or the
/// corners where it has no such element of higher order). Type 0: not at all.
struct VtkCell {
  int type = 0, nodes = 0;
};
VtkCell vtk_cell(const ElementBlock& block);

/// Gmsh's type for VTK's, by the number of nodes where that tells; 0: none.
int gmsh_type_of_cell(std::int64_t vtk, std::size_t nodes);
/// Whether VTK's cells of this type all have as many nodes: another number is a contradiction.
bool has_fixed_size(std::int64_t vtk);

}  // namespace tetproof::io
