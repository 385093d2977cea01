// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iv): the second triangulation, which fills the part of the lattice inside the surface, by Tables 1
// and 2.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/engine/first_grid/indicators.hpp"

namespace tetproof::reference {

/// What a point of the grid is.
enum class Origin : std::uint8_t { lattice_vertex, cut, centroid };

struct Grid {
  TetMesh mesh;
  std::vector<Origin> origins;  ///< of each point
  /// Of each point: the number of its lattice vertex, of its cut, or (for a centroid) of its lattice
  /// tetrahedron.
  std::vector<std::int64_t> sources;
  std::vector<std::uint8_t> on_surface;  ///< of each point: whether it is a surface point of the paper
  /// Of each tetrahedron: the lattice tetrahedron that it is part of, 6 * cell + position in `kuhn_tets`.
  std::vector<std::uint32_t> lattice_tet;
  static constexpr std::uint8_t case_5_dropped = 255;
  /// Of each lattice tetrahedron: its row in `tables::table2`, or `case_5_dropped` (reading D10).
  std::vector<std::uint8_t> lattice_rows;
  std::array<std::int64_t, tables::table2.size()> rows{};  ///< how often each row of Table 2 was used
  /// Tetrahedra left out because a cut at a lattice vertex made two of their vertices the same (reading D7).
  std::int64_t collapsed = 0;
};

/// Cuts every lattice tetrahedron by its row of Table 2. `keep_case_5` decides from the centroid whether a
/// tetrahedron with four vertices on the surface is kept (reading D10). Points and tetrahedra are numbered as
/// reading D3 says.
Grid extract(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
             Diagonals diagonals, const std::function<bool(const Eigen::Vector3d& centroid)>& keep_case_5);

}  // namespace tetproof::reference
