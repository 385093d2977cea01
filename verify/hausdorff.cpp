// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/hausdorff.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/error.hpp"
#include "verify/directed_distance.hpp"
#include "verify/on_triangle.hpp"

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

// A convex polygon in a triangle of A. A cut puts new corners off the line between the old ones by less than
// 4 2^-53, so that a piece of `cuts` cuts leaves out what is that often as far from it.
constexpr int most_corners = 12;
constexpr double cut_slack = 4 * 0x1p-53;
constexpr int most_cuts = 200;

struct Piece {
  Eigen::Matrix<double, 3, most_corners> corner = Eigen::Matrix<double, 3, most_corners>::Zero();
  int corners = 0;
  int cuts = 0;
  Index guess = -1;    // a triangle of B to judge it by
  bool asked = false;  // `guess` is nearest to its middle
  int walks = 0;       // how often it was handed to a neighbour without getting smaller for sure

  double slack() const { return distance_slack + cuts * cut_slack; }
  void add(const Point& p) { corner.col(corners++) = p; }
  Point middle() const {
    Point sum = Point::Zero();
    for (int i = 0; i < corners; ++i) sum += corner.col(i);
    return sum / corners;
  }
};

// The part where `height` of the corners is at most 0, and the rest. Both have at most one corner more. False
// if the line is crossed more than twice: rounding has bent a piece of hardly any width.
bool cut(const Piece& piece, const std::array<double, most_corners>& height, Piece& below, Piece& above) {
  below = {.cuts = piece.cuts + 1, .guess = piece.guess};
  above = below;
  int crossings = 0;
  for (int i = 0; i < piece.corners; ++i) {
    const int k = i, next = (i + 1) % piece.corners;
    if (height[k] <= 0) below.add(piece.corner.col(k));
    if (height[k] >= 0) above.add(piece.corner.col(k));
    if ((height[k] < 0 && height[next] > 0) || (height[k] > 0 && height[next] < 0)) {
      if (++crossings > 2) return false;
      // From the same end whichever way the edge is run.
      const int low = height[k] < 0 ? k : next, high = height[k] < 0 ? next : k;
      const double share = height[low] / (height[low] - height[high]);
      const Point p = piece.corner.col(low) + share * (piece.corner.col(high) - piece.corner.col(low));
      below.add(p);
      above.add(p);
    }
  }
  return true;
}

// One triangle of A that is not done.
struct Work {
  Index triangle;
  std::vector<Piece> pieces;
  double upper = 0;  // of the pieces that are done
  double lower = 0;  // found in it, at `point`
  Point point = Point::Zero();
  Index nearest = -1;
  std::int64_t looked_at = 0;
};

class Search {
 public:
  // A piece is done when it is within `error` of the largest distance found, or within `accepted`.
  Search(const TriangleTree& tree, double lower, double error, double accepted)
      : tree_(tree), lower_(lower), error_(error), accepted_(accepted) {}

  void run(Work& work, std::int64_t budget) const {
    for (; budget > 0 && !work.pieces.empty(); --budget) {
      const Piece piece = work.pieces.back();
      work.pieces.pop_back();
      ++work.looked_at;
      examine(work, piece);
    }
  }

 private:
  double target(const Work& work) const { return std::max(std::max(lower_, work.lower) + error_, accepted_); }

  bool examine_over(Work& work, const Piece& piece) const {
    const TriangleFrame& frame = tree_.frame(piece.guess);
    std::array<TriangleFrame::Place, most_corners> place;
    double squared = 0, height = 0;
    for (int i = 0; i < piece.corners; ++i) {
      place[i] = frame.place(piece.corner.col(i));
      squared = std::max(squared, frame.squared_distance(place[i]));
      height = std::max(height, place[i].zz);
    }
    const double goal = target(work), slack = piece.slack();
    if (std::sqrt(squared) + slack <= goal || piece.cuts >= most_cuts) {
      work.upper = std::max(work.upper, std::sqrt(squared) + slack);
      return true;
    }
    // The walls stand a little outside the edges, as far as the goal allows.
    const double free = goal * goal - height;
    if (free <= 0) return false;
    return over_prism(work, piece, place, goal, 0.45 * std::sqrt(free)) ||
           over_prism(work, piece, place, goal, 0);
  }

  // What stands over the triangle and `margin` around it is done, the rest goes to its neighbours; or nothing
  // is changed.
  bool over_prism(Work& work, const Piece& piece, const std::array<TriangleFrame::Place, most_corners>& place,
                  double goal, double margin) const {
    const TriangleFrame& frame = tree_.frame(piece.guess);
    // A cut that takes the middle away leaves at most 5/9 of the piece on a side. Others are tried twice
    // only.
    const TriangleFrame::Place middle = frame.place(piece.middle());
    bool shrinks = true;
    for (int k = 0; k < 3; ++k) shrinks = shrinks && frame.beyond(k, middle) <= margin;
    if (!shrinks && (piece.asked || piece.walks >= 2)) return false;
    std::array<Piece, 3> outside;
    std::array<int, 3> side;
    int parts = 0;
    Piece inside = piece;
    for (int k = 0; k < 3; ++k) {
      std::array<double, most_corners> beyond;
      bool any = false, all = true;
      for (int i = 0; i < inside.corners; ++i) {
        beyond[i] = frame.beyond(k, parts ? frame.place(inside.corner.col(i)) : place[i]) - margin;
        any = any || beyond[i] > 0;
        all = all && beyond[i] > 0;
      }
      if (!any) continue;
      if (all || inside.corners == most_corners) return false;
      Piece below;
      if (!cut(inside, beyond, below, outside[parts])) return false;
      side[parts++] = k;
      inside = below;
      if (inside.corners < 3) return false;
    }
    if (parts == 0) return false;
    double over = 0;
    for (int i = 0; i < inside.corners; ++i)
      over = std::max(over, frame.squared_distance(inside.corner.col(i)));
    if (std::sqrt(over) + inside.slack() > goal) return false;
    work.upper = std::max(work.upper, std::sqrt(over) + inside.slack());
    for (int i = 0; i < parts; ++i) {
      const Index neighbour = tree_.across(piece.guess, side[i]);
      if (neighbour >= 0) outside[i].guess = neighbour;
      outside[i].walks = shrinks ? 0 : piece.walks + 1;
      work.pieces.push_back(outside[i]);
    }
    return true;
  }

  // The distance at a point of the piece is a lower bound.
  Index ask(Work& work, const Point& p, Index guess) const {
    const TriangleTree::Nearest nearest = tree_.nearest(p, guess);
    const double lower = std::sqrt(nearest.squared) - distance_slack;
    if (lower > work.lower) {
      work.lower = lower;
      work.point = p;
      work.nearest = nearest.triangle;
    }
    return nearest.triangle;
  }

  void examine(Work& work, Piece piece) const {
    if (examine_over(work, piece)) return;
    if (!piece.asked) {
      const Index before = piece.guess;
      const double goal = target(work);
      piece.guess = ask(work, piece.middle(), piece.guess);
      const TriangleFrame& frame = tree_.frame(piece.guess);
      double farthest = -1;
      int at = 0;
      for (int i = 0; i < piece.corners; ++i)
        if (const double d = frame.squared_distance(piece.corner.col(i)); d > farthest) farthest = d, at = i;
      if (std::sqrt(farthest) > goal) ask(work, piece.corner.col(at), piece.guess);
      piece.asked = true;
      if ((piece.guess != before || target(work) > goal) && examine_over(work, piece)) return;
    }
    halve(work, piece);
  }

  static void halve(Work& work, const Piece& piece) {
    int from = 0, to = 0;
    double longest = -1;
    for (int i = 0; i < piece.corners; ++i)
      for (int k = 0; k < i; ++k)
        if (const double d = (piece.corner.col(i) - piece.corner.col(k)).squaredNorm(); d > longest)
          longest = d, from = i, to = k;
    const Point way = piece.corner.col(to) - piece.corner.col(from),
                middle = piece.corner.col(from) + 0.5 * way;
    std::array<double, most_corners> height;
    for (int i = 0; i < piece.corners; ++i) height[i] = (piece.corner.col(i) - middle).dot(way);
    if (!(longest > 0) || height[from] >= 0 || height[to] <= 0) {  // of no extent: as its corners
      work.pieces.push_back(piece);
      work.pieces.back().cuts = most_cuts;
      return;
    }
    Piece below, above;
    if (piece.corners == most_corners || !cut(piece, height, below, above)) {
      // Along a diagonal: fewer corners each. (A triangle's sides are crossed twice at most.)
      below = {.cuts = piece.cuts + 1, .guess = piece.guess};
      above = below;
      const int half = piece.corners / 2;
      for (int i = 0; i <= half; ++i) below.add(piece.corner.col(i));
      for (int i = half; i <= piece.corners; ++i) above.add(piece.corner.col(i % piece.corners));
    }
    work.pieces.push_back(below);
    work.pieces.push_back(above);
  }

  const TriangleTree& tree_;
  double lower_, error_, accepted_;
};

constexpr std::size_t chunk = 256;  // of triangles of A, each starting without a guess

// What one question to the tree says about each triangle of A; or none, if the guess alone is within
// `enough`.
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
  if (squared < 1e-28) {  // perhaps on it, exactly
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

  // Every eighth triangle first. What they find spares most of the others the question: where the sets are
  // far apart it is a dear one, and the guess's bound is below the largest distance known.
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
    std::vector<Work> works;
    for (std::size_t t = 0; t < a.size(); ++t) {
      if (first[t].upper <= std::max(lower + error, accepted)) continue;
      Work work{.triangle = static_cast<Index>(t), .lower = lower};
      Piece piece{.guess = first[t].nearest};
      for (const Point& p : a.corners(static_cast<Index>(t))) piece.add(p);
      work.pieces.push_back(piece);
      works.push_back(std::move(work));
    }
    // In rounds, so that what one triangle finds helps all others, whatever the order of the threads. A
    // triangle that needs much is set aside until the others have spoken.
    std::vector<std::size_t> open(works.size());
    for (std::size_t i = 0; i < works.size(); ++i) open[i] = i;
    for (std::int64_t budget = 8; !open.empty() && result.pieces < question.options.most_pieces;
         budget *= 4) {
      const Search search(b, lower, error, accepted);
      const std::size_t part = budget > 1000 ? 1 : 32;
      tbb::parallel_for(std::size_t{0}, (open.size() + part - 1) / part, [&](std::size_t c) {
        for (std::size_t i = c * part; i < std::min(open.size(), (c + 1) * part); ++i) {
          works[open[i]].looked_at = 0;
          search.run(works[open[i]], budget);
        }
      });
      std::vector<std::size_t> left;
      for (const std::size_t i : open) {
        const Work& work = works[i];
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
    for (const Work& work : works)
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
    units.origin = points_a[static_cast<std::size_t>(triangles_a[0][0])];  // all in one point
  }
  return directed_distance(TriangleTree(sets[0], units), TriangleTree(sets[1], units), {.options = options});
}

}  // namespace tetproof::verify
