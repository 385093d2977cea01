// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which formats list the nodes of an element.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tetproof::io {

enum class NodeOrder { vtk, medit, tetgen };

/// For elements of the type `type`: node k of the format is Gmsh's node `node_order(type, format)[k]`.
/// Empty: the order is the same as Gmsh's.
///
/// In VTK's vtkWedge the triangle 0 1 2 faces outwards, in Gmsh's prism inwards, so two corners of each
/// triangle change places. VTK's quadratic wedges keep Gmsh's corners: their shape functions are defined so,
/// and Gmsh and meshio write them so.
///
/// Medit's hexahedra, prisms and pyramids of second order have Gmsh's order, as Gmsh writes them: the format
/// does not define an order.
std::span<const int> node_order(int type, NodeOrder format);

/// The same for an order that a file gives as the place of each node, as Medit's TetrahedraP2Ordering does.
/// Places are integers with two steps from corner to corner: barycentric coordinates in triangles and
/// tetrahedra, barycentric coordinates and the height in prisms, Cartesian coordinates in lines, quadrangles
/// and hexahedra. Empty if `places` are not the places of all nodes, or if the type is not one of these.
std::vector<int> order_of_lattice(int type, const std::vector<std::int64_t>& places);

}  // namespace tetproof::io
