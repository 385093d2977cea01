// SPDX-License-Identifier: GPL-3.0-or-later
// The operations of step (vi): the choice by eq. (3.5) with the rules for stopping, the split, the flips.
// `adapt` runs them as the paper does; `follow` runs them as the trace of another implementation says.
#pragma once

#include "reference/engine/adaptation/adapt.hpp"

namespace tetproof::reference {

/// The best candidate, if there is one, and the reason to stop instead, if there is one.
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
  double e_avg_goal() const { return e_avg_goal_; }  ///< [length^3]; 0: none

  /// Applies eq. (3.5) and the rules for stopping, in the order: points, E_avg, stalled, no gain, dilution.
  /// Before the last two rules, candidates whose split would degenerate are refused (reading D18).
  Choice choose();

  /// Splits the chosen tetrahedron. Returns the set O_i of section 4: the pieces, and the neighbours that the
  /// tetrahedron had. The set is empty if no improvement is asked for.
  std::vector<Index> insert(const Candidate& chosen);
  /// Whether the split made a solid angle below the tolerance (reading D21).
  bool needs_improvement() const;
  /// The smallest solid angle that the split made, as a fraction of 4 pi.
  double smallest_new_solid_angle() const { return smallest_new_solid_angle_; }
  /// Makes a flip. Returns the updated set O_i.
  std::vector<Index> flip(const Flip& flip, std::vector<Index> set);
  /// Ends a step. To be called after the flips of an insertion.
  void end_step();

  /// The result. Nothing else may be called afterwards.
  Adaptation finish(Stop stop);

 private:
  std::optional<Stop> stop_by_progress() const;

  AdaptOptions options_;
  Listener listener_;
  Weighting weighting_;
  std::optional<WeightedGrid> grid_;
  Adaptation result_;
  double e_avg_goal_ = 0, least_e_avg_ = 0, smallest_new_solid_angle_ = 1;
  std::int64_t least_at_ = 0;  // the number of the insertion that set least_e_avg_
  Index first_of_step_ = 0;    // the number of the first piece of the last insertion
};

}  // namespace tetproof::reference
