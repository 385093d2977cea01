// SPDX-License-Identifier: GPL-3.0-or-later
// The element types of .msh files, by Gmsh's numbers.
#pragma once

namespace tetproof::io {

enum class Shape { point, line, triangle, quadrangle, tetrahedron, hexahedron, prism, pyramid, other };

struct ElementType {
  int type;  ///< Gmsh's number
  Shape shape;
  int dim;
  int nodes;    ///< of each element
  int corners;  ///< the first so many nodes; the others stand on edges, on faces or inside
};

/// The type with Gmsh's number `type`; null when it is not known, or its number of nodes varies.
const ElementType* element_type(int type);

inline constexpr int triangle3 = 2, tetrahedron4 = 4, triangle6 = 9, tetrahedron10 = 11;

}  // namespace tetproof::io
