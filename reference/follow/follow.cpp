// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "io/error.hpp"
#include "reference/follow/replay.hpp"

namespace tetproof::reference {
namespace {

// Whether the rule of dilution may stop at a tetrahedron that ties with the best one.
bool dilutes_by_tie(const Replay& replay, const Candidate& best) {
  const WeightedGrid& grid = replay.weighted();
  return std::any_of(replay.tets.begin(), replay.tets.end(), [&](const auto& named) {
    const Weight& w = grid.weight(named.second);
    return w.volume <= w.desired * (1 + tie) &&
           grid.e_avg_after(grid.candidate(named.second)) <= replay.just_above(grid.e_avg_after(best));
  });
}

// The reason to stop that the trace gives, if it is admissible. Throws Divergence if it is not.
Stop checked_end(Replay& replay, const trace::End& end) {
  Insertion& insertion = *replay.insertion;
  const Choice ours = insertion.choose();
  const std::string name = fmt::format("the end after insertion {}", insertion.so_far().insertions);
  if (ours.stop && end.stopped == name_of(*ours.stop)) return *ours.stop;
  // Rounding may decide whether the last split lowers E_avg, and whether the last tetrahedron is too large.
  const WeightedGrid& grid = replay.weighted();
  if (ours.best && end.stopped == name_of(Stop::no_gain) &&
      replay.just_above(grid.e_avg_after(*ours.best)) >= grid.e_avg()) {
    ++replay.outcome.ties;
    return Stop::no_gain;
  }
  if (ours.best && end.stopped == name_of(Stop::dilution) && !replay.options.past_dilution &&
      dilutes_by_tie(replay, *ours.best)) {
    ++replay.outcome.ties;
    return Stop::dilution;
  }
  if (ours.stop)
    throw Divergence{fmt::format("{}: stopped: {}, not {}", name, name_of(*ours.stop), end.stopped)};
  throw Divergence{fmt::format(
      "{}: stopped: {}, but the tetrahedron at {} can still be split, E_avg {:.12g}, E'avg {:.12g}", name,
      end.stopped, text(grid.grid().corner_points(ours.best->tet)), grid.e_avg(),
      grid.e_avg_after(*ours.best))};
}

// Follows the records of step (vi) up to the end of the trace. Returns the reason to stop that it gives.
Stop follow_steps(Replay& replay) {
  while (replay.record) {
    if (const auto* end = std::get_if<trace::End>(&*replay.record)) return checked_end(replay, *end);
    if (std::holds_alternative<trace::Flip>(*replay.record))
      throw Divergence{fmt::format("insertion {}: a flip, although no new solid angle is below the tolerance",
                                   replay.insertion->so_far().insertions)};
    if (const auto* theirs = std::get_if<trace::Insertion>(&*replay.record))
      replay_insertion(replay, *theirs);
    else
      replay.next();
  }
  throw InputError(fmt::format("{}:{}: expected an 'end' record, found the end of the file",
                               replay.reader.path(), replay.reader.line()));
}

}  // namespace

Adaptation follow(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                  const TrueSurface* true_surface, const trace::Settings& settings, const std::string& path,
                  const Listener& listener, Follow& outcome) {
  check(options);
  Replay replay{.options = options,
                .reader = trace::Reader(path),
                .points = TracePoints(grid.mesh),
                .outcome = outcome,
                .record = {},
                .insertion = {},
                .tets = {}};
  const auto start_with = [&](const Grid& first_grid) {
    replay.insertion.emplace(first_grid, surface, options, true_surface, listener);
    replay.add_tets_from(0);
  };
  Stop stopped = Stop::diverged;
  try {
    TraceStart start = read_start(replay.reader, settings);
    start_with(adopt(grid, start, replay.points));
    compare_weights(start, *replay.insertion, replay.points);
    replay.record = std::move(start.next);
    stopped = follow_steps(replay);
  } catch (const Divergence& divergence) {
    outcome.admissible = false;
    outcome.line = replay.reader.line();
    outcome.what = divergence.what;
  }
  if (!replay.insertion) start_with(grid);
  return replay.insertion->finish(stopped);
}

}  // namespace tetproof::reference
