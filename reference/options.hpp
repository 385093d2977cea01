// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the method, and what a caller can listen to while it runs. Both engines take them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/trace.hpp"

namespace tetproof::reference {

/// Which part of the scaled box becomes the grid (reading D5).
enum class Region { inside, outside };

/// The rule for the diagonal of a quadrilateral that two lattice tetrahedra share (reading D9). `lowest`: the
/// diagonal that starts at the lower-numbered interior vertex. `shortest`: the shorter diagonal; lengths
/// whose relative difference is below 1e-12 are equal, and then the rule is `lowest`.
enum class Diagonals { lowest, shortest };

/// The quality that a flip must raise (reading D20).
enum class Criterion { none, solid_angle, aspect_ratio };

/// A volume: in multiples of the first grid's mean volume, or absolute [length^3] (reading D13).
struct VolumeSetting {
  double value;
  bool absolute = false;
};

/// The options of steps (v) and (vi).
struct AdaptOptions {
  static constexpr std::int64_t automatic = -1;
  /// The largest number of points to insert. `automatic`: insert until no split lowers E_avg.
  std::int64_t points = automatic;
  VolumeSetting v0{0.2}, v1{2};  ///< eq. (3.1), positive
  double d1 = 0;                 ///< eq. (3.1) [length]; 0: the largest d_i of the first grid (reading D13)
  double p = 1;                  ///< eq. (3.1), positive
  VolumeSetting e_avg{0};        ///< stop when E_avg is at most this (reading D17); 0: never for this reason
  bool past_dilution = false;    ///< go on where reading D17 stops for dilution; needs a number of points
  bool curvature = false;        ///< weight the distance by eq. (3.6)
  Criterion improve = Criterion::solid_angle;
  /// A new solid angle below this makes an improvement necessary (reading D21). As a fraction of the full
  /// solid angle, 4 pi.
  double improve_below = 0.002;
  /// Eq. (3.5) as printed, a mean over L+3 tetrahedra for every split (reading D16). `generate` sets it from
  /// `Options::literal`.
  bool literal = false;
  bool check_every_step = false;  ///< check all invariants after every step: quadratic time, for tests
};

/// The present grid of the fast engine (engine/adaptation/weighted_grid.hpp).
class WeightedGrid;

using Recorder = std::function<void(const trace::Record&)>;

/// Functions that are called while the method runs. Each of them may be empty.
struct Listener {
  std::function<void(std::string_view)> phase;  ///< gets the name of each phase when it begins
  Recorder record;                              ///< gets every decision, as a record of the trace
  /// Gets the first grid, and the grid after each insertion and its flips. Only the fast engine calls it.
  std::function<void(const WeightedGrid&)> after_step;
  /// Gets, after each insertion, how many are made, and how many are wanted: 0 if as many as lower E_avg.
  std::function<void(std::int64_t done, std::int64_t wanted)> inserted;
};

/// Which of the two implementations makes the grid. `paper`: paper/, the paper's text by brute force, to be
/// read beside it. `fast`: engine/, for millions of tetrahedra. Their decisions are equal.
enum class Engine { fast, paper };

struct Options {
  Engine engine = Engine::fast;
  Region region = Region::inside;
  /// Numbers of cells along x, y and z; or one number, for the longest side, followed by two zeros (reading
  /// D1).
  std::array<int, 3> cells{24, 0, 0};
  /// If the grid is empty because the surface is thinner than the lattice, double the one number of cells
  /// until it is not, up to `most_cells`.
  bool raise_cells = false;
  static constexpr int most_cells = 8 * 24;
  /// The factor, more than 1, by which the surface's box is scaled about its centre (reading D1).
  double box_scale = 1.2;
  /// In units of the shortest cell edge, 0 to 0.15: a lattice vertex closer to the surface than this is moved
  /// to the surface (reading D4).
  double on_surface = 1e-6;
  Diagonals diagonals = Diagonals::lowest;
  /// The method as printed: case 5 is always kept, `on_surface` counts as 0, tetrahedra inverted by rounding
  /// are reported instead of mended, and eq. (3.5) is a mean over L+3 tetrahedra for every split (readings
  /// D4, D10, D16).
  bool literal = false;
  bool parametric = true;  ///< use the surface's parametric definition if it has one (reading D12)
  /// Settings of steps (v) and (vi). Without them, the first grid is the result; so it is if the first grid
  /// is empty or has a tetrahedron that is not positive.
  std::optional<AdaptOptions> adapt;
  /// The path of a trace. Its decisions are replayed and checked, and the method makes none of its own. Needs
  /// `adapt` and the fast engine. Empty: no trace is followed.
  std::string follow;
  Listener listener;
};

/// Throws InputError for options out of range.
void check(const AdaptOptions& options);
void check(const Options& options);

/// The first record of the trace, from the options. The caller fills in the names of the program and of the
/// surface. `has_evaluator`: whether the surface has a parametric definition.
trace::Settings settings_of(const Options& options, bool has_evaluator);

}  // namespace tetproof::reference
