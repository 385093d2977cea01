// SPDX-License-Identifier: GPL-3.0-or-later
// Step (vi), taken apart: the choice by eq. (3.5) and when to stop, the split, the flips. What drives it may
// be the paper (adapt) or another implementation (follow).
#pragma once

#include "reference/engine/adaptation/adapt.hpp"

namespace tetproof::reference {

/// The best candidate, and the reason to stop instead, if there is one.
struct Choice {
  std::optional<Candidate> best;
  std::optional<Stop> stop;
};

class Insertion {
 public:
  /// Step (v). Throws as `adapt` does.
  Insertion(const Grid& first_grid, const TriangleSurface& surface, const AdaptOptions& options,
            const TrueSurface* true_surface, const Listener& listener);
  Insertion(const Insertion&) = delete;  // the grid refers to the weighting
  Insertion& operator=(const Insertion&) = delete;

  const WeightedGrid& grid() const { return *grid_; }
  const Adaptation& so_far() const { return result_; }

  /// Eq. (3.5) and the rules for stopping, in the order: points, E_avg, stalled, no gain, dilution.
  /// Candidates that would degenerate are refused on the way (reading D18).
  Choice choose();

  /// Splits the chosen tetrahedron. Returns the set O_i of section 4, the pieces and the neighbours that the
  /// tetrahedron had; empty without improvement.
  std::vector<Index> insert(const Candidate& chosen);
  /// Whether the split made a solid angle below the tolerance (reading D21).
  bool needs_improvement() const;
  double smallest_new_solid_angle() const { return smallest_new_solid_angle_; }  ///< of 1 (4 pi)
  /// Makes a flip; returns the updated set.
  std::vector<Index> flip(const Flip& flip, std::vector<Index> set);
  /// After the flips of an insertion.
  void end_step();

  Adaptation finish(Stop stop);

 private:
  std::optional<Stop> stop_by_progress() const;

  AdaptOptions options_;
  Listener listener_;
  Weighting weighting_;
  std::optional<WeightedGrid> grid_;
  Adaptation result_;
  double e_avg_goal_ = 0, least_e_avg_ = 0, smallest_new_solid_angle_ = 1;
  std::int64_t least_at_ = 0;  // the insertion that set it
  Index first_of_step_ = 0;    // the number of the first tetrahedron of the last insertion
};

}  // namespace tetproof::reference
