// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_splits.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "verify/compare/rounding.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

std::vector<Tet> pieces(const Insertion& insertion) {
  std::vector<Tet> all;
  for (const int i : insertion.replaced) {
    all.push_back(insertion.tet);
    all.back()[i] = insertion.point;
  }
  return all;
}

double measure(const Insertion& insertion) {  // of the edge or face that holds the point
  const auto corner = [&](std::size_t i) { return insertion.tet[insertion.replaced[i]]; };
  if (insertion.replaced.size() == 2) return (corner(1) - corner(0)).norm();
  if (insertion.replaced.size() == 3)
    return std::sqrt((corner(1) - corner(0)).cross(corner(2) - corner(0)).norm());
  return 0;
}

bool by_solid_angle(const Settings& settings) {
  return settings.improve != "aspect-ratio";
}

// By which the best flip is chosen (reading D22): of solid angles in tan(Omega/2).
double gain(const Flip& flip, const Settings& settings) {
  const auto measure = [&](double quality) {
    return by_solid_angle(settings) ? std::tan(2 * std::numbers::pi * quality) : quality;
  };
  return measure(flip.quality_after) - measure(flip.quality_before);
}

// What good qualities are of the order of: tan(Omega/2) has no unit, D/A is one over a length.
double healthy(const Flip& flip, const Settings& settings) {
  if (by_solid_angle(settings)) return 1;
  double longest = 0;
  for (const Point& a : flip.face)
    for (const Point& b : flip.edge) longest = std::max(longest, (a - b).norm());
  return 1 / longest;
}

// Up to which a gain is rounding.
double slack(const Flip& flip, const Settings& settings) {
  return tie *
         std::max({healthy(flip, settings), std::abs(flip.quality_before), std::abs(flip.quality_after)});
}

// Whether one of the flip's new tetrahedra is so thin that rounding decides if the hull is convex. Its solid
// angle must not say otherwise; the D/A of a needle may have any size.
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

}  // namespace

bool refused_by_rounding(const Split& split, const Magnitudes& sizes) {
  const std::vector<Tet> all = pieces(split.insertion);
  return std::any_of(all.begin(), all.end(),
                     [&](const Tet& piece) { return thinner_than_rounding(piece, sizes.length); });
}

bool equally_large(const Split& a, const Split& b, const Magnitudes& sizes) {
  const double one = measure(a.insertion), two = measure(b.insertion);
  return a.replaced.size() == b.replaced.size() &&
         std::abs(one - two) <= tie * std::max(one, two) + 1e-15 * sizes.length;
}

std::optional<std::string> flips_tie(const Split& a, const Split& b, std::size_t at, const Settings& settings,
                                     const Magnitudes& sizes) {
  const Flip* const one = at < a.flips.size() ? &a.flips[at].flip : nullptr;
  const Flip* const two = at < b.flips.size() ? &b.flips[at].flip : nullptr;
  // The one that the other side should have made: the better one, or the only one.
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
  if (decided_by_rounding(better, settings, sizes)) return "decided by rounding: tetrahedra thinner than it";
  if (at > 0) return std::nullopt;
  double smallest = 1;
  for (const Tet& piece : pieces(a.insertion)) smallest = std::min(smallest, smallest_solid_angle(piece));
  if (std::abs(smallest - settings.improve_below) <= tie)
    return fmt::format(
        "a tie: the smallest solid angle of the new tetrahedra is {:.6g}, just the one below "
        "which flips are asked for",
        smallest);
  return std::nullopt;
}

}  // namespace tetproof::verify
