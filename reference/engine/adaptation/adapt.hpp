// SPDX-License-Identifier: GPL-3.0-or-later
// Steps (v) and (vi): the adaptation of the grid to distance and curvature, with the local improvement of
// section 4.
#pragma once

#include <string_view>

#include "reference/engine/adaptation/improve.hpp"
#include "reference/engine/adaptation/parametric.hpp"

namespace tetproof::reference {

/// Why the adaptation ended (readings D17, D23). `diverged`: it followed a trace up to the first decision
/// that is not admissible.
enum class Stop { no_gain, dilution, stalled, points, e_avg, diverged };
std::string_view name_of(Stop stop);

struct Adaptation {
  TetMesh mesh;  ///< the points of the first grid, then the new ones; the tetrahedra ascending by number
  std::vector<std::uint8_t> on_surface;  ///< of each point: whether it is a surface point
  VolumeLaw law{};                       ///< as used, with absolute volumes
  double mean_volume = 0;                ///< of the first grid [length^3]
  bool with_curvature = false;
  double kappa_min = 0, kappa_max = 0;  ///< with curvature [1/length]
  double kappa_outlier_ratio = 1;       ///< with curvature: kappa_max over the 99th percentile (reading D15)
  double e_avg_first = 0, e_avg_last = 0;  ///< E_avg of the first grid and of the last one [length^3]
  std::int64_t insertions = 0, refused = 0, flips = 0;
  /// New points left where Table 4 puts them, because moving them to the parametric surface would make a
  /// tetrahedron not positive or the boundary meet itself (reading D12).
  std::int64_t left = 0;
  std::array<std::int64_t, tables::table4.size()> rows{};  ///< insertions by each row of Table 4
  Stop stopped = Stop::no_gain;
  // The worst tetrahedra of the last grid:
  double smallest_solid_angle = 0;    ///< as a fraction of 4 pi
  double smallest_aspect_ratio = 0;   ///< D/A [1/length]
  double smallest_d_over_sqrt_a = 0;  ///< without a unit (reading E5)
};

/// Fills in the worst tetrahedra of `made.mesh`.
void find_worst(Adaptation& made);

/// Steps (v) and (vi) on the grid of steps (i) to (iv). The grid must not be empty, and all its tetrahedra
/// must be positive. `true_surface` may be null. Throws InputError for options out of range, and for volumes
/// that ask for more than 2e8 tetrahedra.
Adaptation adapt(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                 const TrueSurface* true_surface, const Listener& listener);

}  // namespace tetproof::reference
