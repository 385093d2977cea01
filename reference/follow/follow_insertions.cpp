// SPDX-License-Identifier: GPL-3.0-or-later
// Replays insertions: the choice by eq. (3.5), the split by Table 4.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "reference/follow/replay.hpp"

namespace tetproof::reference {
namespace {

// The trace's split of tetrahedron `tet`, whose corners it names in the order `named`. Throws Divergence if
// Table 4 does not allow it.
Candidate candidate_of(const Replay& replay, const trace::Insertion& theirs, const Corners& named, Index tet,
                       const std::string& name) {
  const WeightedGrid& grid = replay.weighted();
  std::vector<Index> replaced;
  for (const int at : theirs.replaced) {
    if (at < 0 || at > 3)
      throw Divergence{name + "'replaced' names a corner that a tetrahedron does not have"};
    replaced.push_back(named[at]);
  }
  std::sort(replaced.begin(), replaced.end());
  const std::vector<Split> splits = splits_by_table4(grid.grid(), tet, tie);
  const Split& prescribed = splits.front();
  const std::string row(tables::table4[prescribed.row].name);
  if (theirs.row != row)
    throw Divergence{fmt::format("{}the tetrahedron at {} is row {} of Table 4, not {}", name,
                                 text(theirs.tet), row, theirs.row)};
  for (Split split : splits) {
    std::vector<Index> ours;
    for (int k = 0; k < split.pieces; ++k) ours.push_back(grid.grid().corners(tet)[split.replaced[k]]);
    std::sort(ours.begin(), ours.end());
    if (ours != replaced) continue;
    const Candidate own = grid.candidate(tet);
    const bool moves = own.moved && !grid.crosses_boundary(own);
    const Eigen::Vector3d expected = moves ? own.split.point : split.point;
    if (!((theirs.point - expected).norm() <= replay.points.reach()))
      throw Divergence{
          fmt::format("{}row {} of Table 4 puts the point of the tetrahedron at {} at {}, not {}", name, row,
                      text(theirs.tet), text(expected), text(theirs.point))};
    split.point = theirs.point;
    Candidate found = grid.candidate(tet, split);
    found.moved = moves;
    return found;
  }
  throw Divergence{
      fmt::format("{}row {} of Table 4 puts the point of the tetrahedron at {} at {}, on another edge or "
                  "face than {}",
                  name, row, text(theirs.tet), text(prescribed.point), text(theirs.point))};
}

// Checks that the trace's split `c` is one that eq. (3.5) and the rules for stopping allow. `ours` is our own
// choice.
void check_choice(const Replay& replay, const trace::Insertion& theirs, const Candidate& c,
                  const Choice& ours, const std::string& describe_ours, const std::string& name) {
  const WeightedGrid& grid = replay.weighted();
  const double e_avg = grid.e_avg_after(c);
  if (!grid.is_positive(c))
    throw Divergence{name + "the split of the tetrahedron at " + text(theirs.tet) + " degenerates (D18); " +
                     describe_ours};
  if (ours.stop == Stop::points || ours.stop == Stop::e_avg || ours.stop == Stop::stalled)
    throw Divergence{fmt::format("{}the method has stopped: {}", name, name_of(*ours.stop))};
  if (!ours.best || e_avg > replay.just_above(grid.e_avg_after(*ours.best)))
    throw Divergence{fmt::format("{}splitting the tetrahedron at {} by row {} gives E'avg {:.12g}; {}", name,
                                 text(theirs.tet), theirs.row, e_avg, describe_ours)};
  if (!(e_avg < replay.just_above(grid.e_avg())))
    throw Divergence{fmt::format("{}no split lowers E_avg any more: {:.12g} before, {:.12g} after", name,
                                 grid.e_avg(), e_avg)};
  const Weight& weight = grid.weight(c.tet);
  if (!replay.options.past_dilution && weight.volume <= weight.desired * (1 - tie))
    throw Divergence{
        fmt::format("{}the method has stopped: dilution; the tetrahedron has volume {:.12g} and should "
                    "have {:.12g} (D17)",
                    name, weight.volume, weight.desired)};
  // The trace states the average after the split. `e_avg` differs from it if L+3 is taken literally.
  const double after = average_error_after_split(grid.sum(), c.change, grid.grid().tets(), c.split.pieces);
  if (!replay.same_average(theirs.e_avg, after))
    throw Divergence{fmt::format("{}E'avg, eq. (3.5), is {:.12g}, not {:.12g}", name, after, theirs.e_avg)};
}

// Whether two candidates split the same tetrahedron at the same edge or face.
bool same_split(const Candidate& a, const Candidate& b) {
  const auto replaced = [](const Candidate& c) {
    std::vector<int> all(c.split.replaced.begin(), c.split.replaced.begin() + c.split.pieces);
    std::sort(all.begin(), all.end());
    return all;
  };
  return a.tet == b.tet && replaced(a) == replaced(b);
}

}  // namespace

void replay_insertion(Replay& replay, const trace::Insertion& theirs) {
  const WeightedGrid& grid = replay.weighted();
  const std::int64_t n = replay.insertion->so_far().insertions + 1;
  const std::string name = fmt::format("insertion {}: ", n);
  if (theirs.n != n) throw Divergence{fmt::format("{}the trace calls it {}", name, theirs.n)};
  const Choice ours = replay.insertion->choose();
  const std::string describe_ours =
      ours.best ? fmt::format("the method splits the tetrahedron at {} by row {}, E'avg {:.12g}",
                              text(grid.grid().corner_points(ours.best->tet)),
                              tables::table4[ours.best->split.row].name, grid.e_avg_after(*ours.best))
                : "no tetrahedron is left to split";

  Corners named;
  try {
    for (int v = 0; v < 4; ++v) named[v] = replay.points.find(theirs.tet[v]);
  } catch (const Divergence& unknown) {
    throw Divergence{name + unknown.what + "; " + describe_ours};
  }
  const auto found = replay.tets.find(sorted(named));
  if (found == replay.tets.end())
    throw Divergence{name + "there is no tetrahedron at " + text(theirs.tet) + "; " + describe_ours};
  const Candidate c = candidate_of(replay, theirs, named, found->second, name);
  check_choice(replay, theirs, c, ours, describe_ours, name);
  if (!same_split(c, *ours.best)) ++replay.outcome.ties;

  const Eigen::Vector3d place = theirs.point;
  replay.tets.erase(found);
  const Index first = grid.grid().numbers();
  std::vector<Index> set = replay.insertion->insert(c);
  replay.points.add(place, grid.grid().points() - 1);
  replay.add_tets_from(first);
  replay.next();
  replay_flips(replay, std::move(set), n);
  replay.insertion->end_step();
}

}  // namespace tetproof::reference
