// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of complete tetrahedra of any order, in Gmsh's and in VTK's order.
#pragma once

#include <vector>

namespace tetproof::io {

/// For tetrahedra of this order, from 1: node k of VTK's Lagrange and Bezier tetrahedra is Gmsh's node
/// `vtk_tetrahedron(order)[k]`. Lines and triangles have the same order in both.
std::vector<int> vtk_tetrahedron(int order);

}  // namespace tetproof::io
