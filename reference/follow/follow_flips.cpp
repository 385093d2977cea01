// SPDX-License-Identifier: GPL-3.0-or-later
// Replays flips: section 4.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/follow/replay.hpp"

namespace tetproof::reference {
namespace {

std::string describe(const Triangulation& grid, const Flip& flip) {
  return fmt::format(
      "{} flip of face {} and edge {}", flip.two_to_three() ? "2-3" : "3-2",
      text(std::array{grid.point(flip.face[0]), grid.point(flip.face[1]), grid.point(flip.face[2])}),
      text(std::array{grid.point(flip.edge[0]), grid.point(flip.edge[1])}));
}

// The order of magnitude of qualities around this flip: tan(Omega/2) has no unit, D/A has the unit 1/length.
double scale(const Replay& replay, const Flip& flip) {
  if (replay.options.improve == Criterion::solid_angle) return 1;
  const Triangulation& grid = replay.grid();
  return 1 / (grid.point(flip.face[0]) - grid.point(flip.face[1])).norm();
}

// The possible flip that is the trace's, which must be as good as the best one. Throws Divergence.
Flip checked_flip(Replay& replay, const trace::Flip& theirs, const std::vector<Index>& set,
                  const std::string& name) {
  const Triangulation& grid = replay.grid();
  const Criterion criterion = replay.options.improve;
  std::array<Index, 3> face;
  std::array<Index, 2> edge;
  try {
    for (int i = 0; i < 3; ++i) face[i] = replay.points.find(theirs.face[i]);
    for (int i = 0; i < 2; ++i) edge[i] = replay.points.find(theirs.edge[i]);
  } catch (const Divergence& unknown) {
    throw Divergence{name + unknown.what};
  }
  std::sort(face.begin(), face.end());
  std::sort(edge.begin(), edge.end());
  const std::optional<Flip> best = best_flip(grid, set, criterion);
  const auto possible = possible_flips(grid, set, criterion);
  const auto same = std::find_if(possible.begin(), possible.end(), [&](const Flip& flip) {
    return flip.face == face && flip.edge == edge && flip.two_to_three() == theirs.two_to_three;
  });
  const std::string kind = theirs.two_to_three ? "2-3" : "3-2";
  const std::string ours = best ? "the method makes the " + describe(grid, *best) : "the method makes none";
  if (same == possible.end())
    throw Divergence{
        fmt::format("{}the {} flip of face {} and edge {} is not one of a strictly convex hexahedron "
                    "within O_i; {}",
                    name, kind, text(theirs.face), text(theirs.edge), ours)};
  const double slack = tie * scale(replay, *same);
  if (!(same->gain() > -slack) || (best && same->gain() < best->gain() - slack))
    throw Divergence{
        fmt::format("{}the {} flip of face {} and edge {} takes the smallest quality from {:.6g} to "
                    "{:.6g}; {}",
                    name, kind, text(theirs.face), text(theirs.edge), same->before, same->after, ours)};
  const auto stated = [&](double theirs_is, double ours_is, const char* when) {
    const double shown = criterion == Criterion::solid_angle ? solid_angle_of(ours_is) : ours_is;
    if (std::abs(theirs_is - shown) > agree * std::abs(shown) + slack)
      throw Divergence{fmt::format("{}the smallest quality {} the {} flip is {:.12g}, not {:.12g}", name,
                                   when, kind, shown, theirs_is)};
  };
  stated(theirs.quality_before, same->before, "before");
  stated(theirs.quality_after, same->after, "after");
  if (!best || best->vertices() != same->vertices()) ++replay.outcome.ties;
  return *same;
}

}  // namespace

void replay_flips(Replay& replay, std::vector<Index> set, std::int64_t n) {
  Insertion& insertion = *replay.insertion;
  const std::string name = fmt::format("flip after insertion {}: ", n);
  const double below = replay.options.improve_below;
  const bool by_tie = std::abs(insertion.smallest_new_solid_angle() - below) <= tie * below;
  const auto their_flip = [&] { return replay.record ? std::get_if<trace::Flip>(&*replay.record) : nullptr; };
  if (!insertion.needs_improvement() && !(by_tie && their_flip())) return;
  if (by_tie && !their_flip()) return;
  for (; const trace::Flip* theirs = their_flip(); replay.next()) {
    const Flip flip = checked_flip(replay, *theirs, set, name);
    for (const Index t : flip.old) replay.tets.erase(sorted(replay.grid().corners(t)));
    const Index first = replay.grid().numbers();
    set = insertion.flip(flip, std::move(set));
    replay.add_tets_from(first);
    const double e_avg = replay.weighted().e_avg();
    if (!replay.same_average(theirs->e_avg, e_avg))
      throw Divergence{fmt::format("{}E_avg is {:.12g} after it, not {:.12g}", name, e_avg, theirs->e_avg)};
  }
  const std::optional<Flip> left = best_flip(replay.grid(), set, replay.options.improve);
  if (left && left->gain() > tie * scale(replay, *left))
    throw Divergence{fmt::format("{}the method still makes the {}, from {:.6g} to {:.6g}", name,
                                 describe(replay.grid(), *left), left->before, left->after)};
}

}  // namespace tetproof::reference
