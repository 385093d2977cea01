// SPDX-License-Identifier: GPL-3.0-or-later
// The element types of .msh files, by Gmsh's numbers.
#pragma once

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
  int nodes;    ///< of each element
  int corners;  ///< the first so many nodes; the others stand on edges, on faces or inside
};

/// The type with Gmsh's number `type`; null when it is not known, or its number of nodes varies.
const ElementType* element_type(int type);

inline constexpr int point1 = 15, line2 = 1, line3 = 8, triangle3 = 2, quadrangle4 = 3, tetrahedron4 = 4,
                     triangle6 = 9, tetrahedron10 = 11;
/// A polygon of any number of nodes; `element_type` does not know it, since a block says how many.
inline constexpr int polygon = 34;
/// Others whose number of nodes varies.
inline constexpr int polyhedron = 35, polygon_border = 69;
/// Whether .msh 2 tells the number of nodes in front of them.
inline constexpr bool has_counted_nodes(int type) {
  return type == polygon || type == polyhedron || type == polygon_border;
}

}  // namespace tetproof::io
