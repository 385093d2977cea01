// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of solid elements by their nodes, in Gmsh's order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/model/element_types.hpp"

namespace tetproof::io {

/// A face of a solid: corners, seen anticlockwise from outside, then the nodes in the middle of its edges,
/// then the one in its own middle, as far as the solid has them.
struct SolidFace {
  int type = triangle3;  ///< Gmsh's number: a triangle or quadrangle of the first or second order
  int corners = 3;
  std::vector<std::int32_t> nodes;
};

/// The faces of elements of a type: of tetrahedra, hexahedra, prisms and pyramids. Up to the second order
/// with all nodes, above by corners. Empty for other types.
std::span<const SolidFace> solid_faces(int type);

}  // namespace tetproof::io
