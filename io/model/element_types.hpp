// SPDX-License-Identifier: GPL-3.0-or-later
// The element types of .msh files and their numbers in Gmsh.
#pragma once

#include <cstdint>

namespace tetproof::io {

enum class Shape {
  point,
  line,
  triangle,
  quadrangle,
  tetrahedron,
  hexahedron,
  prism,
  pyramid,
  polygon,
  other
};

struct ElementType {
  int type;  ///< Gmsh's number
  Shape shape;
  int dim;
  int nodes;    ///< number of nodes of an element
  int corners;  ///< number of corners, which come first; the other nodes lie on edges, on faces or inside
};

/// The type with Gmsh's number `type`; null if it is unknown or if its number of nodes varies.
const ElementType* element_type(std::int64_t type);

/// What elements of this type are called: "tetrahedra", "polygons"; "elements" if there is no such word.
const char* name_of_elements(int type);

inline constexpr int point1 = 15, line2 = 1, line3 = 8, triangle3 = 2, quadrangle4 = 3, tetrahedron4 = 4,
                     triangle6 = 9, tetrahedron10 = 11;
/// A polygon with any number of nodes. `element_type` does not know it, because each block gives the number.
inline constexpr int polygon = 34;
/// Other types whose number of nodes varies.
inline constexpr int polyhedron = 35, polygon_border = 69;
/// Whether .msh 2 gives the number of nodes before the nodes of such an element.
inline constexpr bool has_counted_nodes(int type) {
  return type == polygon || type == polyhedron || type == polygon_border;
}

}  // namespace tetproof::io
