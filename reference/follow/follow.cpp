// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>

#include "reference/follow/follow_first_steps.hpp"
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

// Checks the numbers that the end of the trace states, and that nothing follows it. With each tie another
// split may have been refused first.
void check_end_record(trace::Reader& reader, const trace::End& theirs, const trace::End& ours,
                      bool same_average, std::int64_t ties) {
  const auto expect = [](std::int64_t found, std::int64_t of_ours, std::string_view name) {
    if (found != of_ours) throw Divergence{fmt::format("the end: {} {}, not {}", of_ours, name, found)};
  };
  expect(theirs.insertions, ours.insertions, "insertions");
  expect(theirs.flips, ours.flips, "flips");
  if (std::abs(theirs.refused - ours.refused) > ties) expect(theirs.refused, ours.refused, "refused splits");
  expect(theirs.points, ours.points, "points");
  expect(theirs.tets, ours.tets, "tetrahedra");
  if (!same_average)
    throw Divergence{fmt::format("the end: E_avg is {:.12g}, not {:.12g}", ours.e_avg, theirs.e_avg)};
  if (const auto more = reader.next())
    throw Divergence{fmt::format("a '{}' record after the end", trace::name_of(*more))};
}

// Follows the records of step (vi) up to the end of the trace. Returns the reason to stop that it gives.
Stop follow_steps(Replay& replay) {
  while (replay.record) {
    if (const auto* end = std::get_if<trace::End>(&*replay.record)) {
      const Stop stop = checked_end(replay, *end);
      const Adaptation& so_far = replay.insertion->so_far();
      const double e_avg = replay.weighted().e_avg();
      check_end_record(replay.reader, *end,
                       {.stopped = end->stopped,
                        .insertions = so_far.insertions,
                        .flips = so_far.flips,
                        .refused = so_far.refused,
                        .points = replay.grid().points(),
                        .tets = replay.grid().tets(),
                        .e_avg = e_avg},
                       replay.same_average(end->e_avg, e_avg), replay.outcome.ties);
      return stop;
    }
    if (std::holds_alternative<trace::Flip>(*replay.record))
      throw Divergence{fmt::format("insertion {}: a flip, although no new solid angle is below the tolerance",
                                   replay.insertion->so_far().insertions)};
    const auto* theirs = std::get_if<trace::Insertion>(&*replay.record);
    if (!theirs)
      throw Divergence{
          fmt::format("step (vi): a record of an earlier step, '{}'", trace::name_of(*replay.record))};
    replay_insertion(replay, *theirs);
  }
  fail_truncated(replay.reader);
}

// The trace of a grid that is not adapted: after steps (i) to (iv) it ends.
void follow_to_the_end(trace::Reader& reader, const trace::Record& next, const Grid& grid) {
  const auto* end = std::get_if<trace::End>(&next);
  if (!end)
    throw Divergence{fmt::format("the first grid {}, so that it is not adapted; the trace has a '{}' record",
                                 grid.mesh.tets.empty() ? "is empty" : "is the result",
                                 trace::name_of(next))};
  if (end->stopped != "not-asked")
    throw Divergence{fmt::format("the end: stopped: not-asked, not {}", end->stopped)};
  check_end_record(reader, *end, {.points = std::ssize(grid.mesh.points), .tets = std::ssize(grid.mesh.tets)},
                   end->e_avg == 0, 0);
}

}  // namespace

std::optional<Adaptation> follow(const OwnRun& own, const AdaptOptions* options, const std::string& path,
                                 const Listener& listener, Follow& outcome) {
  trace::Reader reader(path);
  std::unique_ptr<Replay> replay;
  const auto make_replay = [&] {
    replay.reset(new Replay{*options, reader, TracePoints(own.grid.mesh), outcome, {}, {}, {}});
  };
  const auto start_with = [&](const Grid& first_grid) {
    replay->insertion.emplace(first_grid, own.surface, *options, own.true_surface, listener);
    replay->add_tets_from(0);
  };
  Stop stopped = Stop::diverged;
  try {
    std::optional<trace::Record> next =
        check_first_steps(reader, own.first_steps, own.settings, outcome.not_checked);
    if (!options) {
      follow_to_the_end(reader, *next, own.grid);
      return std::nullopt;
    }
    TraceStart start = read_start(reader, next);
    if (!next) fail_truncated(reader);
    make_replay();
    start_with(adopt(own.grid, start, replay->points));
    compare_weights(start, *replay->insertion, replay->points);
    replay->record = std::move(next);
    stopped = follow_steps(*replay);
  } catch (const Divergence& divergence) {
    outcome.admissible = false;
    outcome.line = divergence.line ? divergence.line : reader.line();
    outcome.what = divergence.what;
    if (!options) return std::nullopt;
    if (!replay) make_replay();
    if (!replay->insertion) start_with(own.grid);
  }
  return replay->insertion->finish(stopped);
}

}  // namespace tetproof::reference
