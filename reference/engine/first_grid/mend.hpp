// SPDX-License-Identifier: GPL-3.0-or-later
// What reading D4 does where rounding has inverted a tetrahedron: the lattice vertex at its shortest cut goes
// to the surface.
#pragma once

#include <vector>

#include "reference/engine/first_grid/extract.hpp"

namespace tetproof::reference {

/// The tetrahedra that are not exactly positive, ascending.
std::vector<Index> not_positive(const TetMesh& mesh);

/// For each of these tetrahedra the lattice vertex nearest to the shortest cut of its lattice tetrahedron,
/// with the closest point of the surface, ascending.
std::vector<NearVertex> vertices_to_mend(const Lattice& lattice, const TriangleSurface& surface,
                                         const Indicators& indicators, const SurfaceVertices& settled,
                                         const Grid& grid, const std::vector<Index>& tets);

}  // namespace tetproof::reference
