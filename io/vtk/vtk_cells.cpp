// SPDX-License-Identifier: GPL-3.0-or-later
// The table of VTK's cells and Gmsh's elements. Facts: vtkCellType.h of VTK 9.1.
#include "io/vtk/vtk_cells.hpp"

#include <utility>

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
// Lagrange cells of order 1 and 2 list their nodes in the same order. They are read, not written; from order 3 on
// they are written, too. Lagrange quadrilaterals of higher order have another order of nodes.
constexpr Cell lagrange[] = {{3, 70, 4}, {10, 70, 9}};
// The cells that have a type for each order.
struct Family {
  Shape shape;
  int lagrange, bezier;
};
constexpr Family families[] = {{Shape::line, 68, 75}, {Shape::triangle, 69, 76}, {Shape::tetrahedron, 71, 78}};
// Types that documents do not have, or have only for some numbers of nodes.
constexpr std::pair<int, std::string_view> names[] = {
    {0, "empty cell"}, {15, "pentagonal prism"}, {16, "hexagonal prism"}, {30, "quadratic linear quad"},
    {31, "quadratic linear wedge"}, {33, "biquadratic quadratic hexahedron"}, {34, "biquadratic triangle"},
    {36, "quadratic polygon"}, {37, "triquadratic pyramid"}, {41, "convex point set"}, {42, "polyhedron"},
    {51, "parametric curve"}, {52, "parametric surface"}, {53, "parametric triangle surface"},
    {54, "parametric quad surface"}, {55, "parametric tetrahedral region"}, {56, "parametric hexahedral region"},
    {60, "higher-order edge"}, {61, "higher-order triangle"}, {62, "higher-order quad"},
    {63, "higher-order polygon"}, {64, "higher-order tetrahedron"}, {65, "higher-order wedge"},
    {66, "higher-order pyramid"}, {67, "higher-order hexahedron"}, {68, "Lagrange curve"},
    {69, "Lagrange triangle"}, {70, "Lagrange quadrilateral"}, {71, "Lagrange tetrahedron"},
    {72, "Lagrange hexahedron"}, {73, "Lagrange wedge"}, {74, "Lagrange pyramid"}, {75, "Bezier curve"},
    {76, "Bezier triangle"}, {77, "Bezier quadrilateral"}, {78, "Bezier tetrahedron"}, {79, "Bezier hexahedron"},
    {80, "Bezier wedge"}, {81, "Bezier pyramid"}};
// clang-format on

// The type of VTK's linear cell of a shape.
int linear_cell(Shape shape) {
  constexpr int types[] = {1, 3, 5, 9, 10, 12, 13, 14};
  return shape <= Shape::pyramid ? types[static_cast<int>(shape)] : 0;
}

}  // namespace

VtkCell vtk_cell(const ElementBlock& block) {
  if (block.type == polyline) return {static_cast<int>(vtk_poly_line), block.nodes_each};
  if (block.type == polyhedron && !block.faces.empty())
    return {static_cast<int>(vtk_polyhedron), block.nodes_each};
  if (block.type == polygon) return {static_cast<int>(vtk_polygon), block.nodes_each};
  for (const Cell& cell : cells)
    if (cell.gmsh == block.type && cell.nodes == block.nodes_each) return {cell.vtk, cell.nodes};
  const ElementType* type = element_type(block.type);
  if (!type || type->nodes != block.nodes_each) return {};
  for (const Family& family : families)
    if (family.shape == type->shape && (is_bezier(type->type) || order_of_complete(type->type) > 2))
      return {is_bezier(type->type) ? family.bezier : family.lagrange, type->nodes};
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
  for (const Family& family : families)
    for (int order = 1; const int type = complete_type(family.shape, order); ++order) {
      if (static_cast<std::size_t>(element_type(type)->nodes) != nodes) continue;
      if (vtk == family.lagrange) return type;
      if (vtk == family.bezier) return order == 1 ? type : bezier(type);
    }
  return 0;
}

std::string_view name_of_cell(std::int64_t vtk) {
  for (const auto& [type, name] : names)
    if (type == vtk) return name;
  return "no known type";
}

bool has_fixed_size(std::int64_t vtk) {
  return vtk == 1 || vtk == 3 || vtk == 5 || vtk == vtk_polygon || (vtk >= vtk_pixel && vtk <= 14) ||
         (vtk >= 21 && vtk <= 29) || vtk == 32 || vtk == 35;
}

}  // namespace tetproof::io
