// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method in its order, steps (i) to (vi): a closed surface goes in, a grid of tetrahedra comes
// out.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "io/triangle_surface.hpp"
#include "reference/engine/adaptation/adapt.hpp"
#include "reference/engine/first_grid/extract.hpp"
#include "reference/follow/follow.hpp"

namespace tetproof::reference {

struct Options {
  Region region = Region::inside;
  std::array<int, 3> cells{24, 0,
                           0};  ///< one number along the longest side and zeros, or all three (reading D1)
  double box_scale = 1.2;       ///< of the surface's box about its centre, more than 1 (reading D1)
  double on_surface = 1e-6;     ///< in shortest cell edges, 0 .. 0.15: a vertex closer than this goes to the
                                ///< surface (reading D4)
  Diagonals diagonals = Diagonals::lowest;
  bool literal = false;    ///< as printed: case 5 always kept, on_surface 0, rounding reported and not mended
                           ///< (readings D4, D10)
  bool parametric = true;  ///< follow the surface's parametric definition, if it has one (reading D12)
  std::optional<AdaptOptions> adapt;  ///< steps (v) and (vi); without, or from a first grid that is empty or
                                      ///< not positive, the first grid is the result
  std::string
      follow;  ///< a trace whose decisions are replayed and checked instead of making our own; needs `adapt`
  Listener listener;
};

/// The grid, and how it came about.
struct Generation {
  Lattice lattice;
  Grid grid;                             ///< the first one, of steps (i) to (iv)
  std::optional<Adaptation> adaptation;  ///< steps (v) and (vi), if they were made
  std::optional<Follow> follow;          ///< if a trace was followed
  const TetMesh& mesh() const { return adaptation ? adaptation->mesh : grid.mesh; }  ///< the result

  std::array<std::int64_t, tables::table3.size()> table3{};  ///< how often each row was applied
  std::int64_t dropped_intersections =
      0;  ///< that Table 3 gave up: features thinner than the lattice (reading D11)
  std::int64_t moved_to_surface = 0;  ///< lattice vertices within `on_surface` of it (reading D4)
  std::int64_t mended =
      0;  ///< vertices taken to the surface because rounding had inverted a tetrahedron (reading D4)
  std::int64_t mapped = 0;        ///< surface points moved to the parametric surface (reading D12)
  std::int64_t not_mapped = 0;    ///< that had to stay, or a tetrahedron would have turned over
  std::int64_t not_positive = 0;  ///< tetrahedra that are not exactly positive: 0 unless `literal`
};

/// Steps (i) to (vi) for a surface that is closed, 2-manifold and free of self-intersections (see
/// verify/surface.hpp); orientation does not matter. Throws InputError for options out of range,
/// std::logic_error for a surface that is not closed. The same input gives the same result on any number of
/// threads.
Generation generate(const TriangleSurface& surface, const Options& options);

}  // namespace tetproof::reference
