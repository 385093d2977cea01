// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/hausdorff.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/error.hpp"
#include "verify/distance/directed_distance.hpp"
#include "verify/distance/piece_search.hpp"
#include "verify/triangles/on_triangle.hpp"

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

constexpr std::size_t chunk = 256;  // triangles of A; in each chunk the first has no guess

// How closely a triangle of A is looked at first.
struct Look {
  double within;  // [units] the nearest triangle of B is wanted if it is as near as this; negative: never
  double enough;  // [units] if the guessed triangle of B is as near as this, no other is searched for
  double share;   // a triangle of B that is nearer by this share of the distance may be missed
};

// The bounds that the first look gives for a triangle of A.
struct First {
  double lower, upper;
  Index close;      // the triangle of B that gives `upper`
  bool is_nearest;  // `close` is within `Look::within`, and no other is nearer
};

First first_look(const TriangleTree& a, const TriangleTree& b, Index t, Index guess, const Look& look) {
  const std::array<Point, 3> corners = a.corners(t);
  const Point middle = (corners[0] + corners[1] + corners[2]) / 3;
  const auto farthest = [&](Index triangle) {
    double squared = 0;
    for (const Point& p : corners) squared = std::max(squared, b.frame(triangle).squared_distance(p));
    return squared;
  };
  TriangleTree::Nearest nearest;
  if (look.within >= 0) nearest = b.nearest_within(middle, look.within, guess);
  const bool is_nearest = nearest.triangle >= 0;
  double lower_share = 1;
  if (!is_nearest) {
    if (guess >= 0)
      if (const double upper = std::sqrt(farthest(guess)) + distance_slack; upper <= look.enough)
        return {0, upper, guess, false};
    nearest = b.nearest(middle, guess, -1, look.share);
    lower_share -= look.share;
  }
  const double squared = farthest(nearest.triangle);
  First first{std::max(0.0, std::sqrt(nearest.squared) * lower_share - distance_slack),
              std::sqrt(squared) + distance_slack, nearest.triangle, is_nearest};
  if (squared < 1e-28) {  // the triangle may lie exactly on the nearest one
    const auto points = [](const TriangleSet& set, Index triangle) {
      const Triangle& v = set.triangles[static_cast<std::size_t>(triangle)];
      return std::array<Point, 3>{set.points[v[0]], set.points[v[1]], set.points[v[2]]};
    };
    const std::array<Point, 3> mine = points(a.set(), t), other = points(b.set(), nearest.triangle);
    const bool on = std::all_of(mine.begin(), mine.end(), [&](const Point& p) {
      return p == other[0] || p == other[1] || p == other[2] || on_triangle(p, other);
    });
    if (on) first.upper = first.lower = 0;
  }
  return first;
}

// Triangles of A are looked at in three steps, and the largest distance that a step finds saves most
// triangles of the next their search: far from B a search is expensive, and the bound from the guess is below
// that distance and the error. `wanted.error` grows where the question allows it.
std::vector<First> look_at_all(const TriangleTree& a, const TriangleTree& b, const DistanceQuestion& question,
                               Wanted& wanted) {
  constexpr std::array<std::size_t, 3> every{512, 8, 1};
  const auto step_of = [&](std::size_t t) { return t % every[0] == 0 ? 0 : t % every[1] == 0 ? 1 : 2; };
  std::vector<First> first(a.size());
  Look how{.within = -1, .enough = -1, .share = 0};
  if (question.nearest && !question.only_decide)
    how.within = question.nearest_within / a.units().scale + distance_slack;
  double known = 0;
  for (int step = 0; step < 3; ++step) {
    if (known > wanted.error) {
      how.enough = known + wanted.error;
      how.share = wanted.share(known);
    }
    if (step == 2) how.enough = std::max(how.enough, wanted.accepted);
    tbb::parallel_for(std::size_t{0}, (a.size() + chunk - 1) / chunk, [&](std::size_t c) {
      keep(question.deadline);
      Index guess = -1;
      for (std::size_t t = c * chunk; t < std::min(a.size(), (c + 1) * chunk); ++t) {
        if (step_of(t) == step) first[t] = first_look(a, b, static_cast<Index>(t), guess, how);
        if (step_of(t) <= step) guess = first[t].close;
      }
    });
    for (std::size_t t = 0; t < a.size(); t += every[static_cast<std::size_t>(step)])
      known = std::max(known, first[t].lower);
    if (question.allowed && known * a.units().scale > *question.allowed)
      wanted.error = std::max(wanted.error, question.far_share * known);
  }
  return first;
}

void check_input(const TriangleSet& set, const char* name) {
  for (std::size_t t = 0; t < set.triangles.size(); ++t)
    for (const Index v : set.triangles[t]) {
      if (v < 0 || static_cast<std::size_t>(v) >= set.points.size())
        throw InputError(fmt::format("triangle {} of {} names point {}, which does not exist", t, name, v));
      if (!set.points[static_cast<std::size_t>(v)].allFinite())
        throw InputError(fmt::format("point {} of {} is not finite", v, name));
    }
}

}  // namespace

DirectedDistance directed_distance(const TriangleTree& a, const TriangleTree& b,
                                   const DistanceQuestion& question) {
  DirectedDistance result;
  if (question.nearest) question.nearest->assign(a.size(), -1);
  if (a.empty()) return result;
  if (b.empty()) {
    result.lower = result.upper = INFINITY;
    return result;
  }
  const HausdorffOptions& options = question.options;
  const double scale = a.units().scale;
  const double least_error = 4 * distance_slack;
  Wanted wanted{.error = std::max(options.error / scale, least_error),
                .relative = 0,
                .accepted = question.only_decide ? question.allowed.value() / scale : 0};
  const bool all_nearest = question.nearest && !question.only_decide;
  const std::vector<First> first_looks = look_at_all(a, b, question, wanted);
  std::vector<double> upper_of(a.size());
  result.pieces = static_cast<std::int64_t>(a.size());
  double lower = -1;
  Point point = Point::Zero();
  for (std::size_t t = 0; t < a.size(); ++t) {
    const First& first = first_looks[t];
    if (all_nearest) (*question.nearest)[t] = first.is_nearest ? first.close : -1;
    upper_of[t] = first.upper;
    if (first.lower <= lower) continue;
    const std::array<Point, 3> corners = a.corners(static_cast<Index>(t));
    lower = first.lower;
    point = (corners[0] + corners[1] + corners[2]) / 3;
    result.triangle = static_cast<Index>(t);
    result.nearest = first.close;
  }

  const auto is_over = [&] {
    return question.only_decide && question.stop_if_larger && lower * scale > question.allowed.value();
  };
  for (;;) {
    std::vector<PieceWork> works;
    for (std::size_t t = 0; t < a.size() && !is_over(); ++t) {
      if (upper_of[t] <= wanted.bound(lower, 0)) continue;
      PieceWork work{.triangle = static_cast<Index>(t), .lower = lower};
      Piece piece{.guess = first_looks[t].close};
      for (const Point& p : a.corners(static_cast<Index>(t))) piece.add(p);
      work.pieces.push_back(piece);
      works.push_back(std::move(work));
    }
    // The search goes in rounds, so that a bound found in one triangle helps all others, whatever the order
    // of the threads. A triangle that needs much work waits until the others have had their turn.
    std::vector<std::size_t> open(works.size());
    for (std::size_t i = 0; i < works.size(); ++i) open[i] = i;
    for (std::int64_t budget = 8; !open.empty() && result.pieces < options.most_pieces && !is_over();
         budget *= 4) {
      const PieceSearch search(b, lower, wanted);
      const std::size_t part = budget > 1000 ? 1 : 32;
      tbb::parallel_for(std::size_t{0}, (open.size() + part - 1) / part, [&](std::size_t c) {
        keep(question.deadline);
        for (std::size_t i = c * part; i < std::min(open.size(), (c + 1) * part); ++i) {
          works[open[i]].looked_at = 0;
          search.run(works[open[i]], budget);
        }
      });
      std::vector<std::size_t> left;
      for (const std::size_t i : open) {
        const PieceWork& work = works[i];
        result.pieces += work.looked_at;
        if (work.lower > lower) {
          lower = work.lower;
          point = work.point;
          result.triangle = work.triangle;
          result.nearest = work.nearest;
        }
        if (!work.pieces.empty()) left.push_back(i);
      }
      open = std::move(left);
    }
    for (const PieceWork& work : works)
      if (double& upper = upper_of[static_cast<std::size_t>(work.triangle)]; work.pieces.empty())
        upper = std::min(upper, work.upper);
    double upper = lower;
    for (const double of : upper_of) upper = std::max(upper, of);
    result.lower = lower * scale;
    result.upper = upper * scale;
    const bool decided =
        !question.allowed || *question.allowed < result.lower || *question.allowed >= result.upper;
    const bool narrow =
        options.relative <= 0 || result.upper - result.lower <= options.relative * result.upper;
    if ((decided && narrow) || wanted.error <= least_error || result.pieces >= options.most_pieces) break;
    // A width that is relative is asked for at once: where the sets coincide, the distance is rounding, and
    // there are many powers of ten between that and the error.
    wanted.relative = decided ? options.relative : 0;
    wanted.error = decided ? least_error : std::max(least_error, std::min(wanted.error, upper - lower) / 4);
  }
  // The searches far from B may have missed the nearest triangle.
  const TriangleTree::Nearest nearest = b.nearest(point, result.nearest);
  result.nearest = nearest.triangle;
  result.lower =
      std::clamp((std::sqrt(nearest.squared) - distance_slack) * scale, result.lower, result.upper);
  result.point = a.units().from(point);
  return result;
}

DirectedDistance directed_hausdorff(std::span<const Eigen::Vector3d> points_a,
                                    std::span<const std::array<Index, 3>> triangles_a,
                                    std::span<const Eigen::Vector3d> points_b,
                                    std::span<const std::array<Index, 3>> triangles_b,
                                    const HausdorffOptions& options) {
  const std::array<TriangleSet, 2> sets{TriangleSet{points_a, triangles_a},
                                        TriangleSet{points_b, triangles_b}};
  check_input(sets[0], "A");
  check_input(sets[1], "B");
  if (!(options.error >= 0))
    throw InputError(fmt::format("error is {}, expected a number >= 0", options.error));
  Units units = units_of(sets);
  if (!units.usable && !(triangles_a.empty() || triangles_b.empty())) {
    if (units.diagonal != 0)
      throw InputError(fmt::format("doubles cannot measure in a box of diagonal {}", units.diagonal));
    units.origin = points_a[static_cast<std::size_t>(triangles_a[0][0])];  // all points coincide
  }
  return directed_distance(TriangleTree(sets[0], units), TriangleTree(sets[1], units), {.options = options});
}

}  // namespace tetproof::verify
