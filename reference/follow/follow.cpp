// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/follow/follow.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/error.hpp"
#include "reference/follow/follow_first_grid.hpp"

namespace tetproof::reference {
namespace {

class Follower {
 public:
  Follower(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
           const TrueSurface* true_surface, const trace::Settings& settings, const std::string& path,
           const Listener& listener, Follow& outcome)
      : grid_(grid),
        surface_(surface),
        options_(options),
        true_surface_(true_surface),
        settings_(settings),
        listener_(listener),
        reader_(path),
        points_(grid.mesh),
        outcome_(outcome) {}

  Adaptation run() {
    try {
      TraceStart start = read_start(reader_, settings_);
      start_with(adopt(grid_, start, points_));
      compare_weights(start, *insertion_, points_);
      record_ = std::move(start.next);
      while (record_) step();
      throw InputError(fmt::format("{}:{}: expected an 'end' record, found the end of the file",
                                   reader_.path(), reader_.line()));
    } catch (const Divergence& divergence) {
      outcome_.admissible = false;
      outcome_.line = reader_.line();
      outcome_.what = divergence.what;
    } catch (const Ended&) {
    }
    if (!insertion_) start_with(grid_);
    return insertion_->finish(stopped_);
  }

 private:
  struct Ended {};

  void next() { record_ = reader_.next(); }

  void start_with(const Grid& grid) {
    insertion_.emplace(grid, surface_, options_, true_surface_, listener_);
    for (Index t = 0; t < insertion_->grid().grid().numbers(); ++t)
      tets_.emplace(sorted(insertion_->grid().grid().corners(t)), t);
  }

  bool same_average(double a, double b) const { return reference::same_average(*insertion_, a, b); }
  double just_above(double e_avg) const { return e_avg * (1 + tie) + rounding_of_averages(*insertion_); }

  void step() {
    if (const auto* end = std::get_if<trace::End>(&*record_)) {
      check_end(*end);
      throw Ended{};
    }
    if (std::holds_alternative<trace::Flip>(*record_))
      throw Divergence{fmt::format("insertion {}: a flip that no solid angle below the tolerance asks for",
                                   insertion_->so_far().insertions)};
    if (const auto* theirs = std::get_if<trace::Insertion>(&*record_)) {
      insert(*theirs);
    } else {
      next();
    }
  }

  void check_end(const trace::End& end) {
    const Choice ours = insertion_->choose();
    const std::string name = fmt::format("the end after insertion {}", insertion_->so_far().insertions);
    if (ours.stop && end.stopped == name_of(*ours.stop)) {
      stopped_ = *ours.stop;
      return;
    }
    // Rounding may decide whether the last split lowers E_avg, or the last tetrahedron is too large.
    const WeightedGrid& grid = insertion_->grid();
    if (ours.best && end.stopped == name_of(Stop::no_gain) &&
        just_above(grid.e_avg_after(*ours.best)) >= grid.e_avg()) {
      ++outcome_.ties;
      stopped_ = Stop::no_gain;
      return;
    }
    if (ours.best && end.stopped == name_of(Stop::dilution) && !options_.past_dilution &&
        dilutes_by_tie(*ours.best)) {
      ++outcome_.ties;
      stopped_ = Stop::dilution;
      return;
    }
    if (ours.stop)
      throw Divergence{fmt::format("{}: stopped: {}, not {}", name, name_of(*ours.stop), end.stopped)};
    throw Divergence{fmt::format(
        "{}: stopped: {}, but the tetrahedron at {} can still be split, E_avg {:.12g}, E'avg {:.12g}", name,
        end.stopped, text(grid.grid().corner_points(ours.best->tet)), grid.e_avg(),
        grid.e_avg_after(*ours.best))};
  }

  // Whether a tetrahedron as good as the best is not larger than it should be.
  bool dilutes_by_tie(const Candidate& best) const {
    const WeightedGrid& grid = insertion_->grid();
    return std::any_of(tets_.begin(), tets_.end(), [&](const auto& named) {
      const Weight& w = grid.weight(named.second);
      return w.volume <= w.desired * (1 + tie) &&
             grid.e_avg_after(grid.candidate(named.second)) <= just_above(grid.e_avg_after(best));
    });
  }

  void insert(const trace::Insertion& theirs) {
    const WeightedGrid& grid = insertion_->grid();
    const std::string name = fmt::format("insertion {}: ", insertion_->so_far().insertions + 1);
    const Choice ours = insertion_->choose();
    const auto describe_ours = [&] {
      if (!ours.best) return std::string("no tetrahedron is left to split");
      return fmt::format("the method splits the tetrahedron at {} by row {}, E'avg {:.12g}",
                         text(grid.grid().corner_points(ours.best->tet)),
                         tables::table4[ours.best->split.row].name, grid.e_avg_after(*ours.best));
    };

    Corners named;
    try {
      for (int v = 0; v < 4; ++v) named[v] = points_.find(theirs.tet[v]);
    } catch (const Divergence& unknown) {
      throw Divergence{name + unknown.what + "; " + describe_ours()};
    }
    const auto found = tets_.find(sorted(named));
    if (found == tets_.end())
      throw Divergence{name + "there is no tetrahedron at " + text(theirs.tet) + "; " + describe_ours()};
    const Index tet = found->second;
    const Candidate c = candidate(theirs, named, tet, name);
    const double e_avg = grid.e_avg_after(c);

    if (!grid.is_positive(c))
      throw Divergence{name + "the split of the tetrahedron at " + text(theirs.tet) + " degenerates (D18); " +
                       describe_ours()};
    if (ours.stop == Stop::points || ours.stop == Stop::e_avg || ours.stop == Stop::stalled)
      throw Divergence{fmt::format("{}the method has stopped: {}", name, name_of(*ours.stop))};
    if (!ours.best || e_avg > just_above(grid.e_avg_after(*ours.best)))
      throw Divergence{fmt::format("{}splitting the tetrahedron at {} by row {} gives E'avg {:.12g}; {}",
                                   name, text(theirs.tet), theirs.row, e_avg, describe_ours())};
    if (!(e_avg < just_above(grid.e_avg())))
      throw Divergence{fmt::format("{}no split lowers E_avg any more: {:.12g} before, {:.12g} after", name,
                                   grid.e_avg(), e_avg)};
    const Weight& weight = grid.weight(tet);
    if (!options_.past_dilution && weight.volume <= weight.desired * (1 - tie))
      throw Divergence{
          fmt::format("{}the method has stopped: dilution; the tetrahedron has volume {:.12g} and should "
                      "have {:.12g} (D17)",
                      name, weight.volume, weight.desired)};
    if (tet != ours.best->tet) ++outcome_.ties;

    if (!same_average(theirs.e_avg, e_avg))
      throw Divergence{fmt::format("{}E'avg, eq. (3.5), is {:.12g}, not {:.12g}", name, e_avg, theirs.e_avg)};
    const Eigen::Vector3d place = theirs.point;
    const std::int64_t n = insertion_->so_far().insertions + 1;
    tets_.erase(found);
    const Index first = grid.grid().numbers();
    std::vector<Index> set = insertion_->insert(c);
    points_.add(place, grid.grid().points() - 1);
    know_tets_from(first);
    next();
    flips(std::move(set), n);
    insertion_->end_step();
  }

  // The trace's split of a tetrahedron, if Table 4 allows it.
  Candidate candidate(const trace::Insertion& theirs, const Corners& named, Index tet,
                      const std::string& name) {
    const WeightedGrid& grid = insertion_->grid();
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
      const Eigen::Vector3d expected =
          own.moved && !grid.crosses_boundary(own) ? own.split.point : split.point;
      if (!((theirs.point - expected).norm() <= points_.reach()))
        throw Divergence{
            fmt::format("{}row {} of Table 4 puts the point of the tetrahedron at {} at {}, not {}", name,
                        row, text(theirs.tet), text(expected), text(theirs.point))};
      split.point = theirs.point;
      return grid.candidate(tet, split);
    }
    throw Divergence{
        fmt::format("{}row {} of Table 4 puts the point of the tetrahedron at {} at {}, on another edge or "
                    "face than {}",
                    name, row, text(theirs.tet), text(prescribed.point), text(theirs.point))};
  }

  void know_tets_from(Index first) {
    const Triangulation& grid = insertion_->grid().grid();
    for (Index t = first; t < grid.numbers(); ++t) tets_.emplace(sorted(grid.corners(t)), t);
  }

  // The flips after an insertion: each the best, none missing (readings D21, D22).
  void flips(std::vector<Index> set, std::int64_t n) {
    const std::string name = fmt::format("flip after insertion {}: ", n);
    const double angle = insertion_->smallest_new_solid_angle();
    const bool by_tie = std::abs(angle - options_.improve_below) <= tie * options_.improve_below;
    const auto* theirs = record_ ? std::get_if<trace::Flip>(&*record_) : nullptr;
    if (!insertion_->needs_improvement() && !(by_tie && theirs)) return;
    if (by_tie && !theirs) return;
    for (; record_ && (theirs = std::get_if<trace::Flip>(&*record_)); next()) {
      const Triangulation& grid = insertion_->grid().grid();
      std::array<Index, 3> face;
      std::array<Index, 2> edge;
      try {
        for (int i = 0; i < 3; ++i) face[i] = points_.find(theirs->face[i]);
        for (int i = 0; i < 2; ++i) edge[i] = points_.find(theirs->edge[i]);
      } catch (const Divergence& unknown) {
        throw Divergence{name + unknown.what};
      }
      std::sort(face.begin(), face.end());
      std::sort(edge.begin(), edge.end());
      const std::optional<Flip> best = best_flip(grid, set, options_.improve);
      const auto possible = possible_flips(grid, set, options_.improve);
      const auto same = std::find_if(possible.begin(), possible.end(), [&](const Flip& flip) {
        return flip.face == face && flip.edge == edge && flip.two_to_three() == theirs->two_to_three;
      });
      const std::string kind = theirs->two_to_three ? "2-3" : "3-2";
      const std::string ours = best ? fmt::format("the method makes the {} flip of {}",
                                                  best->two_to_three() ? "2-3" : "3-2", describe(*best))
                                    : "the method makes none";
      if (same == possible.end())
        throw Divergence{
            fmt::format("{}the {} flip of face {} and edge {} is not one of a strictly convex hexahedron "
                        "within O_i; {}",
                        name, kind, text(theirs->face), text(theirs->edge), ours)};
      const double slack = tie * scale(*same);
      if (!(same->gain() > -slack) || (best && same->gain() < best->gain() - slack))
        throw Divergence{
            fmt::format("{}the {} flip of face {} and edge {} takes the smallest quality from {:.6g} to "
                        "{:.6g}; {}",
                        name, kind, text(theirs->face), text(theirs->edge), same->before, same->after, ours)};
      if (!best || best->vertices() != same->vertices()) ++outcome_.ties;
      for (const Index t : same->old) tets_.erase(sorted(grid.corners(t)));
      const Index first = grid.numbers();
      set = insertion_->flip(*same, std::move(set));
      know_tets_from(first);
      if (!same_average(theirs->e_avg, insertion_->grid().e_avg()))
        throw Divergence{fmt::format("{}E_avg is {:.12g} after it, not {:.12g}", name,
                                     insertion_->grid().e_avg(), theirs->e_avg)};
    }
    const std::optional<Flip> left = best_flip(insertion_->grid().grid(), set, options_.improve);
    if (left && left->gain() > tie * scale(*left))
      throw Divergence{fmt::format("{}the method still makes the {} flip of {}, from {:.6g} to {:.6g}", name,
                                   left->two_to_three() ? "2-3" : "3-2", describe(*left), left->before,
                                   left->after)};
  }

  std::string describe(const Flip& flip) const {
    const Triangulation& grid = insertion_->grid().grid();
    return fmt::format(
        "face {} and edge {}",
        text(std::array{grid.point(flip.face[0]), grid.point(flip.face[1]), grid.point(flip.face[2])}),
        text(std::array{grid.point(flip.edge[0]), grid.point(flip.edge[1])}));
  }

  // What qualities are of the order of: tan(Omega/2) has no unit, D/A is one over a length.
  double scale(const Flip& flip) const {
    if (options_.improve == Criterion::solid_angle) return 1;
    const Triangulation& grid = insertion_->grid().grid();
    return 1 / (grid.point(flip.face[0]) - grid.point(flip.face[1])).norm();
  }

  const Grid& grid_;
  const TriangleSurface& surface_;
  const AdaptOptions& options_;
  const TrueSurface* true_surface_;
  const trace::Settings& settings_;
  const Listener& listener_;
  trace::Reader reader_;
  TracePoints points_;
  Follow& outcome_;
  std::optional<trace::Record> record_;
  std::optional<Insertion> insertion_;
  std::map<Corners, Index> tets_;  // alive, by sorted corners
  Stop stopped_ = Stop::diverged;
};

}  // namespace

Adaptation follow(const Grid& grid, const TriangleSurface& surface, const AdaptOptions& options,
                  const TrueSurface* true_surface, const trace::Settings& settings, const std::string& path,
                  const Listener& listener, Follow& outcome) {
  check(options);
  return Follower(grid, surface, options, true_surface, settings, path, listener, outcome).run();
}

}  // namespace tetproof::reference
