// SPDX-License-Identifier: GPL-3.0-or-later
// Relates VTK's types of cells to Gmsh's types of elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/document.hpp"

namespace tetproof::io {

/// VTK's numbers of cells that become several elements, or one element with its nodes in another order.
enum VtkCellType : std::int64_t {
  vtk_poly_vertex = 2,
  vtk_poly_line = 4,
  vtk_strip = 6,
  vtk_polygon = 7,
  vtk_pixel = 8,
  vtk_voxel = 11,
  vtk_polyhedron = 42
};

/// The cell that VTK has for the elements of a block: its type, and how many of their nodes it takes: all, or
/// only the corners where VTK has no such element of higher order. Type 0: VTK has none.
struct VtkCell {
  int type = 0, nodes = 0;
};
VtkCell vtk_cell(const ElementBlock& block);

/// The element type for VTK's type and number of nodes; 0: none.
int gmsh_type_of_cell(std::int64_t vtk, std::size_t nodes);
/// Whether all of VTK's cells of this type have the same number of nodes. Another number is a contradiction.
bool has_fixed_size(std::int64_t vtk);
/// What VTK calls a type that documents do not have: "polyhedron", "Lagrange wedge"; "no known type" for
/// others.
std::string_view name_of_cell(std::int64_t vtk);

}  // namespace tetproof::io
