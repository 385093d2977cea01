// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/options.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "io/error.hpp"

namespace tetproof::reference {
namespace {

std::string_view name_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::none:
      return "none";
    case Criterion::solid_angle:
      return "solid-angle";
    case Criterion::aspect_ratio:
      return "aspect-ratio";
  }
  throw std::logic_error("a criterion without a name");
}

}  // namespace

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

void check(const Options& options) {
  if (!(options.on_surface >= 0 && options.on_surface <= 0.15))
    throw InputError(
        fmt::format("the on-surface tolerance must be 0 to 0.15 of the shortest cell edge, found {}",
                    options.on_surface));
  if (options.raise_cells && options.cells[1] != 0)
    throw InputError("the cells can only be raised if one number is given");
  if (options.adapt) check(*options.adapt);
  if (!options.follow.empty() && options.engine == Engine::paper)
    throw InputError("a trace can only be followed with the fast engine");
}

trace::Settings settings_of(const Options& options, bool has_evaluator) {
  trace::Settings settings{.region = options.region == Region::inside ? "inside" : "outside",
                           .box_scale = options.box_scale,
                           .on_surface = options.literal ? 0 : options.on_surface,
                           .diagonals = options.diagonals == Diagonals::lowest ? "lowest" : "shortest",
                           .literal = options.literal,
                           .points = "0"};
  if (options.adapt) {
    settings.p = options.adapt->p;
    settings.curvature = options.adapt->curvature;
    settings.improve = name_of(options.adapt->improve);
    settings.improve_below = options.adapt->improve_below;
    settings.points =
        options.adapt->points == AdaptOptions::automatic ? "auto" : std::to_string(options.adapt->points);
    settings.past_dilution = options.adapt->past_dilution;
  }
  settings.parametric = options.parametric && has_evaluator;
  return settings;
}

}  // namespace tetproof::reference
