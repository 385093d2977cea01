// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh that is cut open: the whole tetrahedra that a plane leaves, and the faces that one then sees.
#pragma once

#include <array>
#include <vector>

#include "reference/figure/plane_cut.hpp"

namespace tetproof::reference {

/// A face of one tetrahedron that is left.
struct OpenFace {
  Index tet;                     ///< the tetrahedron that is left
  std::array<Index, 3> corners;  ///< positions in `points`, anticlockwise seen from outside the tetrahedron
  bool is_cut;  ///< another tetrahedron of the mesh has this face too, and is gone; otherwise it is the
                ///< mesh's boundary
};

struct CutOpen {
  std::vector<Index> tets;      ///< the tetrahedra that are left, ascending
  std::vector<OpenFace> faces;  ///< their faces that no other of them has, in the order of the tetrahedra
};

/// Leaves the tetrahedra of which no point is on the plane's positive side, normal . x > offset. They are
/// left whole, so that the cut is not flat. Sides are decided exactly if the normal is an axis. The points
/// need not be finite: a tetrahedron with a point that is not is gone. All indices must exist.
CutOpen cut_open(const TetMesh& mesh, const Plane& plane);

}  // namespace tetproof::reference
