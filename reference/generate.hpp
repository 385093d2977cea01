// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method, steps (i) to (vi), as one function: from a closed surface to a grid of tetrahedra.
#pragma once

#include <array>
#include <optional>

#include "io/triangle_surface.hpp"
#include "reference/engine/adaptation/adapt.hpp"
#include "reference/engine/first_grid/extract.hpp"
#include "reference/follow/follow.hpp"
#include "reference/options.hpp"

namespace tetproof::reference {

/// The grid, and how it was made.
struct Generation {
  Lattice lattice;
  Grid grid;                             ///< the first grid, made by steps (i) to (iv)
  std::optional<Adaptation> adaptation;  ///< present if steps (v) and (vi) were made
  std::optional<Follow> follow;          ///< present if a trace was followed
  const TetMesh& mesh() const { return adaptation ? adaptation->mesh : grid.mesh; }  ///< the result

  std::array<std::int64_t, tables::table3.size()> table3{};  ///< how often each row of Table 3 was applied
  /// Intersection points that Table 3 ignored: features thinner than the lattice (reading D11).
  std::int64_t dropped_intersections = 0;
  /// Lattice vertices moved to the surface because they were within `on_surface` of it (reading D4).
  std::int64_t moved_to_surface = 0;
  /// Lattice vertices moved to the surface because rounding had inverted a tetrahedron (reading D4).
  std::int64_t mended = 0;
  std::int64_t mapped = 0;  ///< surface points moved to the parametric surface (reading D12)
  /// Surface points left in place, because moving them would have inverted a tetrahedron or made the boundary
  /// meet itself (reading D12).
  std::int64_t not_mapped = 0;
  std::int64_t not_positive = 0;  ///< tetrahedra that are not exactly positive: 0 unless `literal`
};

/// Steps (i) to (vi) for a surface that is closed, 2-manifold and free of self-intersections (see
/// verify/surface.hpp). Its orientation does not matter, and vertices that no triangle names do not count.
/// Throws InputError for options out of range, std::logic_error for a surface that is not closed. The same
/// input gives the same result on any number of threads.
Generation generate(const TriangleSurface& surface, const Options& options);

}  // namespace tetproof::reference
