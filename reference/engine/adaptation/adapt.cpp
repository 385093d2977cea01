// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/adapt.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "io/error.hpp"
#include "reference/engine/adaptation/insertion.hpp"

namespace tetproof::reference {

void check(const AdaptOptions& options) {
  const auto positive = [](double value, std::string_view name) {
    if (!(value > 0 && std::isfinite(value)))
      throw InputError(fmt::format("{}: expected a positive number, found {}", name, value));
  };
  positive(options.v0.value, "v0");
  positive(options.v1.value, "v1");
  positive(options.p, "p");
  if (options.d1 != 0) positive(options.d1, "d1");
  if (!(options.e_avg.value >= 0))
    throw InputError(fmt::format("e-avg: expected a number, not negative, found {}", options.e_avg.value));
  if (!(options.improve_below >= 0 && options.improve_below <= 1))
    throw InputError(fmt::format("improve-below: expected a solid angle from 0 to 1 (of 4 pi), found {}",
                                 options.improve_below));
  if (options.points < 0 && options.points != AdaptOptions::automatic)
    throw InputError(fmt::format("points: expected a number, not negative, found {}", options.points));
  if (options.past_dilution && options.points == AdaptOptions::automatic)
    throw InputError("past-dilution: expected a number of points with it, found automatic (reading D17)");
}

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
