// SPDX-License-Identifier: GPL-3.0-or-later
// The table of VTK's cells and Gmsh's elements.
#include "io/vtk/vtk_cells.hpp"

#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

struct Cell {
  int gmsh, vtk, nodes;
};
// clang-format off
constexpr Cell cells[] = {{15, 1, 1}, {1, 3, 2}, {2, 5, 3}, {3, 9, 4}, {4, 10, 4}, {5, 12, 8}, {6, 13, 6}, {7, 14, 5},
                          {8, 21, 3}, {9, 22, 6}, {16, 23, 8}, {10, 28, 9}, {11, 24, 10}, {17, 25, 20}, {12, 29, 27},
                          {18, 26, 15}, {13, 32, 18}, {19, 27, 13}, {26, 35, 4}};
// Lagrange's of order 1 and 2, which have the same order of nodes: they are read, not written.
constexpr Cell lagrange[] = {{1, 68, 2}, {8, 68, 3}, {2, 69, 3}, {9, 69, 6}, {3, 70, 4}, {10, 70, 9}, {4, 71, 4},
                             {11, 71, 10}};
// clang-format on

// The type of VTK's linear cell of a shape.
int linear_cell(Shape shape) {
  constexpr int types[] = {1, 3, 5, 9, 10, 12, 13, 14};
  return shape <= Shape::pyramid ? types[static_cast<int>(shape)] : 0;
}

}  // namespace

VtkCell vtk_cell(const ElementBlock& block) {
  if (block.type == polygon) return {static_cast<int>(vtk_polygon), block.nodes_each};
  for (const Cell& cell : cells)
    if (cell.gmsh == block.type && cell.nodes == block.nodes_each) return {cell.vtk, cell.nodes};
  const ElementType* type = element_type(block.type);
  if (!type || type->nodes != block.nodes_each) return {};
  const int linear = linear_cell(type->shape);
  return linear == 0 ? VtkCell{} : VtkCell{linear, type->corners};
}

int gmsh_type_of_cell(std::int64_t vtk, std::size_t nodes) {
  const auto is_it = [&](const Cell& cell) {
    return cell.vtk == vtk && static_cast<std::size_t>(cell.nodes) == nodes;
  };
  for (const Cell& cell : cells)
    if (is_it(cell)) return cell.gmsh;
  for (const Cell& cell : lagrange)
    if (is_it(cell)) return cell.gmsh;
  return 0;
}

bool has_fixed_size(std::int64_t vtk) {
  return vtk == 1 || vtk == 3 || vtk == 5 || vtk == vtk_polygon || (vtk >= vtk_pixel && vtk <= 14) ||
         (vtk >= 21 && vtk <= 29) || vtk == 32 || vtk == 35;
}

}  // namespace tetproof::io
