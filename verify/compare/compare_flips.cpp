// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_flips.hpp"

#include <algorithm>
#include <numbers>

#include "verify/compare/rounding.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

std::vector<FlipKey> sorted_keys(const Split& split) {
  std::vector<FlipKey> all;
  for (const Flipped& flip : split.flips) all.push_back(flip.key);
  std::sort(all.begin(), all.end());
  return all;
}

bool by_solid_angle(const Settings& settings) {
  return settings.improve != "aspect-ratio";
}

// The gain by which the best flip is chosen (reading D22). Solid angles are measured as tan(Omega/2).
double gain(const Flip& flip, const Settings& settings) {
  const auto measure = [&](double quality) {
    return by_solid_angle(settings) ? std::tan(2 * std::numbers::pi * quality) : quality;
  };
  return measure(flip.quality_after) - measure(flip.quality_before);
}

// The magnitude of good qualities: tan(Omega/2) has no unit, D/A is one over a length.
double healthy(const Flip& flip, const Settings& settings) {
  if (by_solid_angle(settings)) return 1;
  double longest = 0;
  for (const Point& a : flip.face)
    for (const Point& b : flip.edge) longest = std::max(longest, (a - b).norm());
  return 1 / longest;
}

// A gain up to this size is rounding.
double slack(const Flip& flip, const Settings& settings) {
  return tie *
         std::max({healthy(flip, settings), std::abs(flip.quality_before), std::abs(flip.quality_after)});
}

// Whether one of the flip's new tetrahedra is so thin that rounding decides if the hull is convex. Not if its
// solid angle is clearly positive. D/A gives no such hint: that of a needle may have any size.
bool decided_by_rounding(const Flip& flip, const Settings& settings, const Magnitudes& sizes) {
  if (by_solid_angle(settings) && flip.quality_after > 1e-6) return false;
  for (int i = 0; i < 3; ++i)
    if (flip.two_to_three
            ? thinner_than_rounding({flip.edge[0], flip.edge[1], flip.face[i], flip.face[(i + 1) % 3]},
                                    sizes.length)
            : i < 2 && thinner_than_rounding({flip.face[0], flip.face[1], flip.face[2], flip.edge[i]},
                                             sizes.length))
      return true;
  return false;
}

// Why the two sequences of flips may differ at position `at`; nothing if one of them is wrong.
std::optional<std::string> flips_tie(const Split& a, const Split& b, std::size_t at, const Settings& settings,
                                     const Magnitudes& sizes) {
  const Flip* const one = at < a.flips.size() ? &a.flips[at].flip : nullptr;
  const Flip* const two = at < b.flips.size() ? &b.flips[at].flip : nullptr;
  // The flip that the other side should have made: the better one, or the only one.
  const Flip& better = one && (!two || gain(*one, settings) >= gain(*two, settings)) ? *one : *two;
  const double by = better.quality_after - better.quality_before;
  if (one && two &&
      std::abs(gain(*one, settings) - gain(*two, settings)) <=
          std::max({tie * std::abs(gain(*one, settings)), tie * std::abs(gain(*two, settings)),
                    slack(*one, settings), slack(*two, settings)}))
    return fmt::format("a tie: both raise the smallest quality by {:.6g}", by);
  if (gain(better, settings) < -slack(better, settings)) return std::nullopt;
  if (gain(better, settings) <= slack(better, settings))
    return fmt::format("a tie: the flip's gain of {:.3g} is rounding", by);
  if (decided_by_rounding(better, settings, sizes))
    return "decided by rounding: the flip makes tetrahedra thinner than rounding";
  if (at > 0) return std::nullopt;
  double smallest = 1;
  for (const Tet& piece : pieces(a.insertion)) smallest = std::min(smallest, smallest_solid_angle(piece));
  if (std::abs(smallest - settings.improve_below) <= tie)
    return fmt::format(
        "a tie: the smallest solid angle of the new tetrahedra is {:.6g}, equal to the limit below which "
        "flips are made",
        smallest);
  return std::nullopt;
}

}  // namespace

std::string says(const Flip& flip) {
  return fmt::format("{} flip of the face {} {} {} and the edge {} {}", flip.two_to_three ? "2-3" : "3-2",
                     short_text(flip.face[0]), short_text(flip.face[1]), short_text(flip.face[2]),
                     short_text(flip.edge[0]), short_text(flip.edge[1]));
}

bool same_flips(const Split& a, const Split& b) {
  return sorted_keys(a) == sorted_keys(b);
}

FlipDifference first_flip_difference(std::int64_t n, const Split& a, const Split& b, const Settings& settings,
                                     const Magnitudes& sizes) {
  std::size_t i = 0;
  while (i < a.flips.size() && i < b.flips.size() && a.flips[i].key == b.flips[i].key) ++i;
  const Flipped* const one = i < a.flips.size() ? &a.flips[i] : nullptr;
  const Flipped* const two = i < b.flips.size() ? &b.flips[i] : nullptr;
  const auto side = [](const Flipped* flipped, std::int64_t line) {
    return flipped ? Says{flipped->line,
                          fmt::format("{}; smallest quality {:.6g} to {:.6g}", says(flipped->flip),
                                      flipped->flip.quality_before, flipped->flip.quality_after),
                          to_line(flipped->flip)}
                   : Says{line, "no further flip"};
  };
  const auto short_name = [](const Flipped& flipped) {
    const Flip& flip = flipped.flip;
    const Point c = (flip.face[0] + flip.face[1] + flip.face[2] + flip.edge[0] + flip.edge[1]) / 5;
    return fmt::format("makes the {} flip at ({:.4g}, {:.4g}, {:.4g})", flip.two_to_three ? "2-3" : "3-2",
                       c.x(), c.y(), c.z());
  };
  const std::string what =
      one && two ? fmt::format("insertion {}, flip {}: reference {}, other {}", n, i + 1, short_name(*one),
                               short_name(*two))
      : one      ? fmt::format("insertion {}, flip {}: reference {}, other makes no further flip", n, i + 1,
                               short_name(*one))
                 : fmt::format("insertion {}, flip {}: other {}, reference makes no further flip", n, i + 1,
                               short_name(*two));
  return {what, side(one, a.line), side(two, b.line), flips_tie(a, b, i, settings, sizes)};
}

}  // namespace tetproof::verify
