// SPDX-License-Identifier: GPL-3.0-or-later
// In which order formats list the nodes of an element.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tetproof::io {

enum class NodeOrder { vtk, medit, tetgen };

/// Of elements with Gmsh's type `type`: the format's node k is Gmsh's node `node_order(type, format)[k]`.
/// Empty: the same order as Gmsh's.
///
/// VTK's vtkWedge has the triangle 0 1 2 turned outwards, Gmsh's prism inwards: two corners of each triangle
/// change places. Its quadratic wedges keep Gmsh's corners, which is how their shape functions are, and how
/// Gmsh and meshio write them.
///
/// Medit's hexahedra, prisms and pyramids of second order are in Gmsh's order, as Gmsh writes them: the
/// format names no order of its own.
std::span<const int> node_order(int type, NodeOrder format);

/// The same for an order that a file tells by the place of each node, two steps from corner to corner, as
/// Medit's TetrahedraP2Ordering does: barycentric coordinates in triangles and tetrahedra, those and the
/// height in prisms, Cartesian ones in lines, quadrangles and hexahedra. Empty if they are not the places of
/// all nodes, or the type is another.
std::vector<int> order_of_lattice(int type, const std::vector<std::int64_t>& places);

}  // namespace tetproof::io
