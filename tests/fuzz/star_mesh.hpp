// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of star-shaped solids that are certain to be right.
#pragma once

#include <stdexcept>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::test {

/// Why a solid is not meshed.
struct NotStarShaped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Joins every triangle of a part to one point that sees the part's whole inside. Proved exactly: each
/// tetrahedron is positive, so that nothing overlaps, and the boundary is the surface, triangle by triangle.
/// NotStarShaped: a part has no such point, or bounds a cavity; `fill_cavities` leaves the latter out.
TetMesh star_mesh(const TriangleSurface& surface, bool fill_cavities = false);

}  // namespace tetproof::test
