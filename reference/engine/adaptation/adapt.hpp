// SPDX-License-Identifier: GPL-3.0-or-later
// Steps (v) and (vi): the grid adapts to distance and curvature, and is improved where that hurt.
#pragma once

#include <functional>
#include <string>

#include "io/trace.hpp"
#include "reference/engine/adaptation/improve.hpp"
#include "reference/engine/adaptation/parametric.hpp"

namespace tetproof::reference {

/// A volume, in multiples of the first grid's mean volume or absolute [length^3] (reading D13).
struct VolumeSetting {
  double value;
  bool absolute = false;
};

struct AdaptOptions {
  static constexpr std::int64_t automatic = -1;
  std::int64_t points = automatic;  ///< to insert at most; automatic: until no split lowers E_avg
  VolumeSetting v0{0.2}, v1{2};     ///< eq. (3.1), positive
  double d1 = 0;               ///< eq. (3.1) [length]; 0: the largest d_i of the first grid (reading D13)
  double p = 1;                ///< eq. (3.1), positive
  VolumeSetting e_avg{0};      ///< stop when E_avg is not above this (reading D17); 0: never
  bool past_dilution = false;  ///< do not stop at reading D17's second rule; needs a number of points
  bool curvature = false;      ///< weight the distance, eq. (3.6)
  Criterion improve = Criterion::solid_angle;
  double improve_below =
      0.002;  ///< solid angle, of 1 (4 pi), that makes an improvement necessary (reading D21)
  bool check_every_step = false;  ///< all invariants after every step: quadratic time, for tests
};

/// Throws InputError for options out of range.
void check(const AdaptOptions& options);

/// Readings D17 and D23; `diverged` where a trace was followed as far as it was admissible.
enum class Stop { no_gain, dilution, stalled, points, e_avg, diverged };
std::string_view name_of(Stop stop);

struct Adaptation {
  TetMesh mesh;  ///< points of the first grid, then the new ones; tetrahedra by number
  std::vector<std::uint8_t> on_surface;  ///< of each point
  VolumeLaw law{};                       ///< as used, absolute
  double mean_volume = 0;                ///< of the first grid [length^3]
  bool with_curvature = false;
  double kappa_min = 0, kappa_max = 0;  ///< with curvature [1/length]
  double kappa_outlier_ratio = 1;       ///< with curvature: kappa_max over the 99th percentile (reading D15)
  double e_avg_first = 0, e_avg_last = 0;
  std::int64_t insertions = 0, refused = 0, flips = 0;
  std::int64_t left =
      0;  ///< points not moved to the parametric surface, or the boundary would cross itself (D12)
  std::array<std::int64_t, tables::table4.size()> rows{};  ///< insertions by each row of Table 4
  Stop stopped = Stop::no_gain;
  double smallest_solid_angle = 0;    ///< of the grid at the end, of 1 (4 pi)
  double smallest_aspect_ratio = 0;   ///< D/A [1/length]
  double smallest_d_over_sqrt_a = 0;  ///< without a unit (reading E5)
};

/// What is told on the way; any of them may be empty.
struct Listener {
  std::function<void(std::string_view)> phase;       ///< the name of each phase as it begins
  std::function<void(const trace::Record&)> record;  ///< every decision, for the trace
  std::function<void(const WeightedGrid&)>
      after_step;  ///< the first grid, and the grid after each insertion and its flips
};

/// Steps (v) and (vi) on the grid of steps (i) to (iv). `true_surface` may be null. The grid must not be
/// empty, and be positive throughout. Throws InputError for options out of range, or volumes that ask for
/// more than 2e8 tetrahedra.
Adaptation adapt(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                 const TrueSurface* true_surface, const Listener& listener);

}  // namespace tetproof::reference
