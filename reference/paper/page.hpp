// SPDX-License-Identifier: GPL-3.0-or-later
// The method as the paper lists it, steps (i) to (vi). README.md says in which order to read this folder.
#pragma once

#include "reference/paper/section3_insertion.hpp"

namespace tetproof::reference::paper {

class Page : public Insertion {
 public:
  using Insertion::Insertion;

  /// Makes the grid: `first_grid_` after step (iv), the present grid at the end. Every decision goes to
  /// `options.listener.record`, as a record of the trace.
  void run() {
    make_lattice();               // (i)
    characterize();               // (ii), (iii)
    const Grid grid = extract();  // (iv)
    record_first_steps({cells_, planes_, initial_, after_, settled_, mended_, cuts_, rows_},
                       options_.listener.record);
    points_ = grid.mesh.points;
    surface_points_ = grid.surface_points;
    for (const Tet& v : grid.mesh.tets) add(v);
    if (is_parametric() && not_positive_ == 0) map_grid();
    first_grid_ = {.mesh = {.points = points_, .tets = grid.mesh.tets}, .surface_points = surface_points_};
    adapted_ = options_.adapt && !tets_.empty() && not_positive_ == 0;
    if (adapted_) {
      weigh_grid();     // (v)
      insert_points();  // (vi)
    }
    record(trace::End{stopped_, insertions_, flips_, refused_, std::ssize(points_), size(),
                      adapted_ ? e_avg() : 0});
  }

  Grid first_grid_;
  bool adapted_ = false;  ///< whether steps (v) and (vi) were made
};

}  // namespace tetproof::reference::paper
