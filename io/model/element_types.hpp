// SPDX-License-Identifier: GPL-3.0-or-later
// The element types of documents: those of .msh files, with their numbers in Gmsh, and a few that only VTK
// has.
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
  int type;  ///< Gmsh's number, or one of those below that Gmsh does not have
  Shape shape;
  int dim;
  int nodes;    ///< number of nodes of an element
  int corners;  ///< number of corners, which come first; the other nodes lie on edges, on faces or inside
};

/// The type with the number `type`; null if it is unknown or if its number of nodes varies.
const ElementType* element_type(std::int64_t type);

/// The dimension of a type's elements; 2 for a type that is not known, as polygons have.
int dimension_of_type(int type);

/// What elements of this type are called: "tetrahedra", "polygons"; "elements" if there is no such word.
const char* name_of_elements(int type);

inline constexpr int point1 = 15, line2 = 1, line3 = 8, triangle3 = 2, quadrangle4 = 3, tetrahedron4 = 4,
                     triangle6 = 9, tetrahedron10 = 11;
/// A polygon with any number of nodes. `element_type` does not know it, because each block gives the number.
inline constexpr int polygon = 34;
/// Other types whose number of nodes varies.
inline constexpr int polyhedron = 35, polygon_border = 69;

/// A line through any number of nodes. Gmsh has no such type; its numbers end at 140.
inline constexpr int polyline = 1000;
/// The Bezier element with as many control points as Gmsh's type `gmsh` has nodes: a line, a triangle or a
/// tetrahedron of order 2 to 10. The corners lie on the element, other control points need not, so that it
/// must never be taken for an element of that type.
inline constexpr int bezier(int gmsh) {
  return 2000 + gmsh;
}
inline constexpr bool is_bezier(int type) {
  return type > bezier(0);
}
/// Whether Gmsh has this number for a type, or may have it in a later version.
inline constexpr bool is_of_gmsh(int type) {
  return type < polyline;
}

/// Gmsh's type for the complete element of a shape (line, triangle, quadrangle or tetrahedron) and an order
/// from 1 to 10; 0 for others. The order of such a type; 0 for others.
int complete_type(Shape shape, int order);
int order_of_complete(int type);

/// Whether .msh 2 gives the number of nodes before the nodes of such an element.
inline constexpr bool has_counted_nodes(int type) {
  return type == polygon || type == polyhedron || type == polygon_border;
}

}  // namespace tetproof::io
