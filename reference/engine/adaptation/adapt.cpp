// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/adapt.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/engine/adaptation/insertion.hpp"

namespace tetproof::reference {

std::string_view name_of(Stop stop) {
  switch (stop) {
    case Stop::no_gain:
      return "no-gain";
    case Stop::dilution:
      return "dilution";
    case Stop::stalled:
      return "stalled";
    case Stop::points:
      return "points";
    case Stop::e_avg:
      return "e-avg";
    case Stop::diverged:
      return "diverged";
  }
  throw std::logic_error("a reason to stop without a name");
}

void find_worst(Adaptation& made) {
  made.smallest_solid_angle = made.smallest_aspect_ratio = made.smallest_d_over_sqrt_a = HUGE_VAL;
  for (const auto& [a, b, c, d] : made.mesh.tets) {
    const auto& x = made.mesh.points;
    const std::array corners{x[a], x[b], x[c], x[d]};
    const auto lower = [](double& least, double value) { least = std::min(least, value); };
    lower(made.smallest_solid_angle, solid_angle_of(smallest_solid_angle(corners)));
    lower(made.smallest_aspect_ratio, aspect_ratio(corners));
    lower(made.smallest_d_over_sqrt_a, dimensionless_aspect_ratio(corners));
  }
}

Adaptation adapt(const Grid& first_grid, const TriangleSurface& surface, const AdaptOptions& options,
                 const TrueSurface* true_surface, const Listener& listener) {
  check(options);
  Insertion insertion(first_grid, surface, options, true_surface, listener);  // (v)
  for (;;) {                                                                  // (vi)
    const Choice choice = insertion.choose();
    if (choice.stop) return insertion.finish(*choice.stop);
    std::vector<Index> set = insertion.insert(*choice.best);
    if (insertion.needs_improvement())  // section 4
      while (const std::optional<Flip> flip = best_flip(insertion.grid().grid(), set, options.improve))
        set = insertion.flip(*flip, std::move(set));
    insertion.end_step();
  }
}

}  // namespace tetproof::reference
