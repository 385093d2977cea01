// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/element_types.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace tetproof::io {
namespace {

// Type, shape, dimension, nodes, corners; sorted by type. Types whose number of nodes varies (polygons,
// polyhedra and the borders that cut them) are not listed: only the file gives the number. `other`: a type
// without meaningful corners.
// clang-format off
constexpr ElementType types[] = {
    {1, Shape::line, 1, 2, 2}, {2, Shape::triangle, 2, 3, 3}, {3, Shape::quadrangle, 2, 4, 4},
    {4, Shape::tetrahedron, 3, 4, 4}, {5, Shape::hexahedron, 3, 8, 8}, {6, Shape::prism, 3, 6, 6},
    {7, Shape::pyramid, 3, 5, 5}, {8, Shape::line, 1, 3, 2}, {9, Shape::triangle, 2, 6, 3},
    {10, Shape::quadrangle, 2, 9, 4}, {11, Shape::tetrahedron, 3, 10, 4}, {12, Shape::hexahedron, 3, 27, 8},
    {13, Shape::prism, 3, 18, 6}, {14, Shape::pyramid, 3, 14, 5}, {15, Shape::point, 0, 1, 1},
    {16, Shape::quadrangle, 2, 8, 4}, {17, Shape::hexahedron, 3, 20, 8}, {18, Shape::prism, 3, 15, 6},
    {19, Shape::pyramid, 3, 13, 5}, {20, Shape::triangle, 2, 9, 3}, {21, Shape::triangle, 2, 10, 3},
    {22, Shape::triangle, 2, 12, 3}, {23, Shape::triangle, 2, 15, 3}, {24, Shape::triangle, 2, 15, 3},
    {25, Shape::triangle, 2, 21, 3}, {26, Shape::line, 1, 4, 2}, {27, Shape::line, 1, 5, 2},
    {28, Shape::line, 1, 6, 2}, {29, Shape::tetrahedron, 3, 20, 4}, {30, Shape::tetrahedron, 3, 35, 4},
    {31, Shape::tetrahedron, 3, 56, 4}, {32, Shape::tetrahedron, 3, 22, 4}, {33, Shape::tetrahedron, 3, 28, 4},
    {36, Shape::quadrangle, 2, 16, 4}, {37, Shape::quadrangle, 2, 25, 4}, {38, Shape::quadrangle, 2, 36, 4},
    {39, Shape::quadrangle, 2, 12, 4}, {40, Shape::quadrangle, 2, 16, 4}, {41, Shape::quadrangle, 2, 20, 4},
    {42, Shape::triangle, 2, 28, 3}, {43, Shape::triangle, 2, 36, 3}, {44, Shape::triangle, 2, 45, 3},
    {45, Shape::triangle, 2, 55, 3}, {46, Shape::triangle, 2, 66, 3}, {47, Shape::quadrangle, 2, 49, 4},
    {48, Shape::quadrangle, 2, 64, 4}, {49, Shape::quadrangle, 2, 81, 4}, {50, Shape::quadrangle, 2, 100, 4},
    {51, Shape::quadrangle, 2, 121, 4}, {52, Shape::triangle, 2, 18, 3}, {53, Shape::triangle, 2, 21, 3},
    {54, Shape::triangle, 2, 24, 3}, {55, Shape::triangle, 2, 27, 3}, {56, Shape::triangle, 2, 30, 3},
    {57, Shape::quadrangle, 2, 24, 4}, {58, Shape::quadrangle, 2, 28, 4}, {59, Shape::quadrangle, 2, 32, 4},
    {60, Shape::quadrangle, 2, 36, 4}, {61, Shape::quadrangle, 2, 40, 4}, {62, Shape::line, 1, 7, 2},
    {63, Shape::line, 1, 8, 2}, {64, Shape::line, 1, 9, 2}, {65, Shape::line, 1, 10, 2},
    {66, Shape::line, 1, 11, 2}, {67, Shape::other, 1, 2, 2}, {68, Shape::other, 2, 3, 3},
    {70, Shape::other, 1, 2, 2}, {71, Shape::tetrahedron, 3, 84, 4}, {72, Shape::tetrahedron, 3, 120, 4},
    {73, Shape::tetrahedron, 3, 165, 4}, {74, Shape::tetrahedron, 3, 220, 4}, {75, Shape::tetrahedron, 3, 286, 4},
    {79, Shape::tetrahedron, 3, 34, 4}, {80, Shape::tetrahedron, 3, 40, 4}, {81, Shape::tetrahedron, 3, 46, 4},
    {82, Shape::tetrahedron, 3, 52, 4}, {83, Shape::tetrahedron, 3, 58, 4}, {84, Shape::other, 1, 1, 1},
    {85, Shape::other, 2, 1, 1}, {86, Shape::other, 2, 1, 1}, {87, Shape::other, 3, 1, 1},
    {88, Shape::other, 3, 1, 1}, {89, Shape::other, 3, 1, 1}, {90, Shape::prism, 3, 40, 6},
    {91, Shape::prism, 3, 75, 6}, {92, Shape::hexahedron, 3, 64, 8}, {93, Shape::hexahedron, 3, 125, 8},
    {94, Shape::hexahedron, 3, 216, 8}, {95, Shape::hexahedron, 3, 343, 8}, {96, Shape::hexahedron, 3, 512, 8},
    {97, Shape::hexahedron, 3, 729, 8}, {98, Shape::hexahedron, 3, 1000, 8}, {99, Shape::hexahedron, 3, 32, 8},
    {100, Shape::hexahedron, 3, 44, 8}, {101, Shape::hexahedron, 3, 56, 8}, {102, Shape::hexahedron, 3, 68, 8},
    {103, Shape::hexahedron, 3, 80, 8}, {104, Shape::hexahedron, 3, 92, 8}, {105, Shape::hexahedron, 3, 104, 8},
    {106, Shape::prism, 3, 126, 6}, {107, Shape::prism, 3, 196, 6}, {108, Shape::prism, 3, 288, 6},
    {109, Shape::prism, 3, 405, 6}, {110, Shape::prism, 3, 550, 6}, {111, Shape::prism, 3, 24, 6},
    {112, Shape::prism, 3, 33, 6}, {113, Shape::prism, 3, 42, 6}, {114, Shape::prism, 3, 51, 6},
    {115, Shape::prism, 3, 60, 6}, {116, Shape::prism, 3, 69, 6}, {117, Shape::prism, 3, 78, 6},
    {118, Shape::pyramid, 3, 30, 5}, {119, Shape::pyramid, 3, 55, 5}, {120, Shape::pyramid, 3, 91, 5},
    {121, Shape::pyramid, 3, 140, 5}, {122, Shape::pyramid, 3, 204, 5}, {123, Shape::pyramid, 3, 285, 5},
    {124, Shape::pyramid, 3, 385, 5}, {125, Shape::pyramid, 3, 21, 5}, {126, Shape::pyramid, 3, 29, 5},
    {127, Shape::pyramid, 3, 37, 5}, {128, Shape::pyramid, 3, 45, 5}, {129, Shape::pyramid, 3, 53, 5},
    {130, Shape::pyramid, 3, 61, 5}, {131, Shape::pyramid, 3, 69, 5}, {132, Shape::other, 3, 1, 1},
    {133, Shape::other, 0, 1, 1}, {134, Shape::other, 1, 2, 2}, {135, Shape::other, 2, 3, 3},
    {136, Shape::other, 3, 4, 4}, {137, Shape::tetrahedron, 3, 16, 4}, {138, Shape::other, 2, 4, 4},
    {139, Shape::other, 3, 5, 5}, {140, Shape::other, 2, 4, 4},
};
// clang-format on

static_assert(std::size(types) == 134);
static_assert(std::is_sorted(std::begin(types), std::end(types),
                             [](const ElementType& a, const ElementType& b) { return a.type < b.type; }));

// The complete types by order, from 1.
struct Family {
  Shape shape;
  std::array<int, 10> types;
};
constexpr Family families[] = {{Shape::line, {1, 8, 26, 27, 28, 62, 63, 64, 65, 66}},
                               {Shape::triangle, {2, 9, 21, 23, 25, 42, 43, 44, 45, 46}},
                               {Shape::quadrangle, {3, 10, 36, 37, 38, 47, 48, 49, 50, 51}},
                               {Shape::tetrahedron, {4, 11, 29, 30, 31, 71, 72, 73, 74, 75}}};

const ElementType* gmsh_type(std::int64_t type) {
  const auto* found = std::lower_bound(std::begin(types), std::end(types), type,
                                       [](const ElementType& a, std::int64_t b) { return a.type < b; });
  return found != std::end(types) && found->type == type ? found : nullptr;
}

// The Bezier elements, with their own numbers.
const std::vector<ElementType>& bezier_types() {
  static const std::vector<ElementType> all = [] {
    std::vector<ElementType> list;
    for (const Family& family : families)
      for (std::size_t k = 1; family.shape != Shape::quadrangle && k < family.types.size(); ++k) {
        list.push_back(*gmsh_type(family.types[k]));
        list.back().type = bezier(list.back().type);
      }
    return list;
  }();
  return all;
}

}  // namespace

const ElementType* element_type(std::int64_t type) {
  if (type <= polyline) return gmsh_type(type);
  for (const ElementType& known : bezier_types())
    if (known.type == type) return &known;
  return nullptr;
}

int dimension_of_type(int type) {
  const ElementType* known = element_type(type);
  return known ? known->dim : type == polyhedron ? 3 : type == polyline ? 1 : 2;
}

int complete_type(Shape shape, int order) {
  for (const Family& family : families)
    if (family.shape == shape && order >= 1 && order <= static_cast<int>(family.types.size()))
      return family.types[static_cast<std::size_t>(order) - 1];
  return 0;
}

int order_of_complete(int type) {
  for (const Family& family : families)
    for (std::size_t k = 0; k < family.types.size(); ++k)
      if (family.types[k] == type) return static_cast<int>(k) + 1;
  return 0;
}

const char* name_of_elements(int type) {
  static constexpr const char* names[] = {"points",    "lines",  "triangles", "quadrangles", "tetrahedra",
                                          "hexahedra", "prisms", "pyramids",  "polygons",    "elements"};
  static_assert(std::size(names) == static_cast<std::size_t>(Shape::other) + 1);
  if (type == polygon) return "polygons";
  if (type == polyhedron) return "polyhedra";
  if (type == polyline) return "polylines";
  const ElementType* known = element_type(type);
  if (known && is_bezier(type))
    return known->shape == Shape::line       ? "Bezier curves"
           : known->shape == Shape::triangle ? "Bezier triangles"
                                             : "Bezier tetrahedra";
  return names[static_cast<std::size_t>(known ? known->shape : Shape::other)];
}

}  // namespace tetproof::io
