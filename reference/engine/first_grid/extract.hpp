// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iv): the second triangulation, the part of the lattice that lies inside, by Tables 1 and 2.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/engine/first_grid/indicators.hpp"

namespace tetproof::reference {

/// Which diagonal cuts a quadrilateral that two lattice tetrahedra share (reading D9). Lengths that differ by
/// less than 1e-12, relative, are equal, and decided as `lowest`.
enum class Diagonals { lowest, shortest };

/// What a point of the grid was made from.
enum class Origin : std::uint8_t { lattice_vertex, cut, centroid };

struct Grid {
  TetMesh mesh;
  std::vector<Origin> origins;  ///< of each point
  std::vector<std::int64_t>
      sources;  ///< of each point: its lattice vertex, the number of its cut, or its lattice tetrahedron
  std::vector<std::uint8_t> on_surface;    ///< of each point: is it a surface point in the paper's sense
  std::vector<std::uint32_t> lattice_tet;  ///< of each tetrahedron: 6 * cell + its place in `kuhn_tets`
  static constexpr std::uint8_t case_5_dropped = 255;
  std::vector<std::uint8_t> lattice_rows;  ///< of each lattice tetrahedron its row in `tables::table2`, or
                                           ///< `case_5_dropped` (reading D10)
  std::array<std::int64_t, tables::table2.size()> rows{};  ///< how often each row of Table 2 was used
  std::int64_t collapsed =
      0;  ///< tetrahedra dropped because a cut at an end point made two of their vertices one (reading D7)
};

/// Cuts every lattice tetrahedron. `keep_case_5` says whether a tetrahedron with four vertices on the surface
/// is kept, from its centroid (reading D10). Numbers of points and tetrahedra as reading D3.
Grid extract(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
             Diagonals diagonals, const std::function<bool(const Eigen::Vector3d& centroid)>& keep_case_5);

}  // namespace tetproof::reference
