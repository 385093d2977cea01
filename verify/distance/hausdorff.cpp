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

constexpr std::size_t chunk = 256;  // triangles of A; each chunk starts without a guess

// The bounds that one query to the tree gives for a triangle of A. If the guessed triangle of B is within
// `enough`, no query is made.
struct First {
  double lower, upper;
  Index nearest;
};

First first_look(const TriangleTree& a, const TriangleTree& b, Index t, Index guess, double enough) {
  const std::array<Point, 3> corners = a.corners(t);
  if (guess >= 0) {
    double squared = 0;
    for (const Point& p : corners) squared = std::max(squared, b.frame(guess).squared_distance(p));
    if (const double upper = std::sqrt(squared) + distance_slack; upper <= enough) return {0, upper, guess};
  }
  const TriangleTree::Nearest nearest = b.nearest((corners[0] + corners[1] + corners[2]) / 3, guess);
  const TriangleFrame& frame = b.frame(nearest.triangle);
  double squared = 0;
  for (const Point& p : corners) squared = std::max(squared, frame.squared_distance(p));
  First first{std::max(0.0, std::sqrt(nearest.squared) - distance_slack), std::sqrt(squared) + distance_slack,
              nearest.triangle};
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
  const double scale = a.units().scale;
  const double least_error = 4 * distance_slack;
  double error = std::max(question.options.error / scale, least_error);
  const double accepted = question.only_decide ? question.allowed.value() / scale : 0;

  // Every eighth triangle comes first. The lower bound that they find saves most of the others their query:
  // where the sets are far apart a query is expensive, and the bound from the guess is below the largest
  // known distance.
  std::vector<First> first(a.size());
  const auto look = [&](bool samples, double enough) {
    tbb::parallel_for(std::size_t{0}, (a.size() + chunk - 1) / chunk, [&](std::size_t c) {
      Index guess = -1;
      for (std::size_t t = c * chunk; t < std::min(a.size(), (c + 1) * chunk); ++t) {
        const bool sample = t % 8 == 0;
        if (sample == samples) first[t] = first_look(a, b, static_cast<Index>(t), guess, enough);
        if (sample || !samples) guess = first[t].nearest;
      }
    });
  };
  look(true, -1);
  double known = 0;
  for (std::size_t t = 0; t < a.size(); t += 8) known = std::max(known, first[t].lower);
  const bool all_nearest = question.nearest && !question.only_decide;
  look(false, all_nearest ? -1 : std::max(known > error ? known + error : -1, accepted));
  result.pieces = static_cast<std::int64_t>(a.size());
  double lower = -1;
  Point point = Point::Zero();
  for (std::size_t t = 0; t < a.size(); ++t) {
    if (question.nearest) (*question.nearest)[t] = first[t].nearest;
    if (first[t].lower <= lower) continue;
    const std::array<Point, 3> corners = a.corners(static_cast<Index>(t));
    lower = first[t].lower;
    point = (corners[0] + corners[1] + corners[2]) / 3;
    result.triangle = static_cast<Index>(t);
    result.nearest = first[t].nearest;
  }

  for (;;) {
    std::vector<PieceWork> works;
    for (std::size_t t = 0; t < a.size(); ++t) {
      if (first[t].upper <= std::max(lower + error, accepted)) continue;
      PieceWork work{.triangle = static_cast<Index>(t), .lower = lower};
      Piece piece{.guess = first[t].nearest};
      for (const Point& p : a.corners(static_cast<Index>(t))) piece.add(p);
      work.pieces.push_back(piece);
      works.push_back(std::move(work));
    }
    // The search goes in rounds, so that a bound found in one triangle helps all others, whatever the order
    // of the threads. A triangle that needs much work waits until the others have had their turn.
    std::vector<std::size_t> open(works.size());
    for (std::size_t i = 0; i < works.size(); ++i) open[i] = i;
    for (std::int64_t budget = 8; !open.empty() && result.pieces < question.options.most_pieces;
         budget *= 4) {
      const PieceSearch search(b, lower, error, accepted);
      const std::size_t part = budget > 1000 ? 1 : 32;
      tbb::parallel_for(std::size_t{0}, (open.size() + part - 1) / part, [&](std::size_t c) {
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
      if (work.pieces.empty())
        first[static_cast<std::size_t>(work.triangle)].upper =
            std::min(first[static_cast<std::size_t>(work.triangle)].upper, work.upper);
    double upper = lower;
    for (const First& f : first) upper = std::max(upper, f.upper);
    result.lower = lower * scale;
    result.upper = upper * scale;
    const bool decided =
        !question.allowed || *question.allowed < result.lower || *question.allowed >= result.upper;
    const bool narrow = result.upper - result.lower <= question.options.relative * result.upper;
    if ((decided && (question.options.relative <= 0 || narrow)) || error <= least_error ||
        result.pieces >= question.options.most_pieces)
      break;
    error = std::max(least_error, std::min(error, upper - lower) / 4);
  }
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
