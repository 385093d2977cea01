// SPDX-License-Identifier: GPL-3.0-or-later
// Mending of tetrahedra that rounding has inverted: the lattice vertex nearest to the shortest cut is moved
// to the surface (reading D4).
#pragma once

#include <vector>

#include "reference/engine/first_grid/extract.hpp"

namespace tetproof::reference {

/// The tetrahedra that are not exactly positive, ascending.
std::vector<Index> not_positive(const TetMesh& mesh);

/// For each tetrahedron of `tets`: the lattice vertex nearest to the shortest cut of its lattice tetrahedron,
/// with its closest point of the surface. Ascending, each vertex once; without those that are settled
/// already.
std::vector<NearVertex> vertices_to_mend(const Lattice& lattice, const TriangleSurface& surface,
                                         const Indicators& indicators, const SurfaceVertices& settled,
                                         const Grid& grid, const std::vector<Index>& tets);

}  // namespace tetproof::reference
