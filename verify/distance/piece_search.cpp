// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/distance/piece_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::verify {
namespace {

using Point = Eigen::Vector3d;

// Cuts a piece into the part where `height` is at most 0 and the rest. Each part has at most one corner more
// than the piece. False if the line is crossed more than twice: rounding has bent a very narrow piece.
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
      // Always computed from the same end, whichever way the edge is run.
      const int low = height[k] < 0 ? k : next, high = height[k] < 0 ? next : k;
      const double share = height[low] / (height[low] - height[high]);
      const Point p = piece.corner.col(low) + share * (piece.corner.col(high) - piece.corner.col(low));
      below.add(p);
      above.add(p);
    }
  }
  return true;
}

// The two corners farthest apart.
struct Extent {
  double squared = -1;
  int from = 0, to = 0;
};

Extent extent(const Piece& piece) {
  Extent longest;
  for (int i = 0; i < piece.corners; ++i)
    for (int k = 0; k < i; ++k)
      if (const double d = (piece.corner.col(i) - piece.corner.col(k)).squaredNorm(); d > longest.squared)
        longest = {d, i, k};
  return longest;
}

double twice_area(const Piece& piece) {
  Point sum = Point::Zero();
  for (int i = 1; i + 1 < piece.corners; ++i)
    sum += (piece.corner.col(i) - piece.corner.col(0)).cross(piece.corner.col(i + 1) - piece.corner.col(0));
  return sum.norm();
}

// Whether `part` is so much smaller than `whole` that cutting on like this soon ends. A piece that is as
// narrow as rounding has no area that counts: it must get shorter.
bool is_smaller(const Piece& part, const Piece& whole) {
  const double area = twice_area(whole);
  if (twice_area(part) > 0.6 * area) return false;
  const double squared = extent(whole).squared;
  return area > 1e-13 * std::sqrt(squared) || extent(part).squared <= 0.6 * squared;
}

}  // namespace

void PieceSearch::run(PieceWork& work, std::int64_t budget) const {
  for (; budget > 0 && !work.pieces.empty(); --budget) {
    const Piece piece = work.pieces.back();
    work.pieces.pop_back();
    ++work.looked_at;
    examine(work, piece);
  }
}

bool PieceSearch::examine_over(PieceWork& work, const Piece& piece) const {
  const TriangleFrame& frame = tree_.frame(piece.guess);
  std::array<TriangleFrame::Place, most_corners> place;
  double squared = 0, height = 0;
  for (int i = 0; i < piece.corners; ++i) {
    place[i] = frame.place(piece.corner.col(i));
    squared = std::max(squared, frame.squared_distance(place[i]));
    height = std::max(height, place[i].zz);
  }
  const double slack = piece.slack(), goal = wanted_.bound(known(work), slack);
  if (std::sqrt(squared) + slack <= goal || piece.whole || piece.cuts >= most_cuts) {
    work.upper = std::max(work.upper, std::sqrt(squared) + slack);
    return true;
  }
  // The walls may stand a little outside the edges, as far as the goal allows.
  const double free = goal * goal - height;
  if (free <= 0) return false;
  return over_prism(work, piece, place, goal, 0.45 * std::sqrt(free)) ||
         over_prism(work, piece, place, goal, 0);
}

// Cuts the piece along the walls that stand `margin` outside the edges of triangle `guess`. The part between
// the walls is done; the rest goes to the triangle's neighbours. Returns false and changes nothing if that
// does not work.
bool PieceSearch::over_prism(PieceWork& work, const Piece& piece, const Places& place, double goal,
                             double margin) const {
  const TriangleFrame& frame = tree_.frame(piece.guess);
  // If the middle is between the walls, each part outside has at most 5/9 of the piece, up to rounding.
  // Otherwise a piece may go on to a neighbour at most twice.
  const TriangleFrame::Place middle = frame.place(piece.middle());
  bool shrinks = true;
  for (int k = 0; k < 3; ++k) shrinks = shrinks && frame.beyond(k, middle) <= margin;
  if (piece.walks >= 2 || (!shrinks && piece.asked)) return false;
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
    outside[i].walks = shrinks && is_smaller(outside[i], piece) ? 0 : piece.walks + 1;
    work.pieces.push_back(outside[i]);
  }
  return true;
}

// Finds the triangle nearest to a point of the piece, or one about as near. The distance there gives a lower
// bound.
Index PieceSearch::ask(PieceWork& work, const Point& p, Index guess) const {
  // Far from the triangles, a distance that is hardly larger than the largest known helps nothing.
  const double share = wanted_.share(known(work));
  const double enough = share > 0 ? known(work) * (1 + share) : -1;
  const TriangleTree::Nearest nearest = tree_.nearest(p, guess, enough, share);
  const double distance = std::sqrt(nearest.squared);
  const double lower = distance <= enough ? 0 : distance * (1 - share) - distance_slack;
  if (lower > work.lower) {
    work.lower = lower;
    work.point = p;
    work.nearest = nearest.triangle;
  }
  return nearest.triangle;
}

void PieceSearch::examine(PieceWork& work, Piece piece) const {
  if (examine_over(work, piece)) return;
  if (!piece.asked) {
    const Index before = piece.guess;
    const double goal = wanted_.bound(known(work), piece.slack());
    piece.guess = ask(work, piece.middle(), piece.guess);
    const TriangleFrame& frame = tree_.frame(piece.guess);
    double farthest = -1;
    int at = 0;
    for (int i = 0; i < piece.corners; ++i)
      if (const double d = frame.squared_distance(piece.corner.col(i)); d > farthest) farthest = d, at = i;
    Index other = piece.guess;
    if (std::sqrt(farthest) + piece.slack() > goal) other = ask(work, piece.corner.col(at), piece.guess);
    piece.asked = true;
    const bool raised = wanted_.bound(known(work), piece.slack()) > goal;
    if ((piece.guess != before || raised) && examine_over(work, piece)) return;
    // A narrow piece along an edge: halving would not bring its long sides nearer to one triangle.
    if (other != piece.guess && other != before) {
      Piece over_other = piece;
      over_other.guess = other;
      if (examine_over(work, over_other)) return;
    }
  }
  halve(work, piece);
}

void PieceSearch::halve(PieceWork& work, const Piece& piece) {
  const auto [longest, from, to] = extent(piece);
  const Point way = piece.corner.col(to) - piece.corner.col(from),
              middle = piece.corner.col(from) + 0.5 * way;
  std::array<double, most_corners> height;
  for (int i = 0; i < piece.corners; ++i) height[i] = (piece.corner.col(i) - middle).dot(way);
  if (!(longest > 0) || height[from] >= 0 || height[to] <= 0) {  // it has no extent: judge it by its corners
    work.pieces.push_back(piece);
    work.pieces.back().whole = true;
    return;
  }
  Piece below, above;
  if (piece.corners == most_corners || !cut(piece, height, below, above)) {
    // Cut it along a diagonal instead, so that each part has fewer corners. (A triangle never gets here: a
    // line crosses its sides at most twice.)
    below = {.cuts = piece.cuts + 1, .guess = piece.guess};
    above = below;
    const int half = piece.corners / 2;
    for (int i = 0; i <= half; ++i) below.add(piece.corner.col(i));
    for (int i = half; i <= piece.corners; ++i) above.add(piece.corner.col(i % piece.corners));
  }
  work.pieces.push_back(below);
  work.pieces.push_back(above);
}

}  // namespace tetproof::verify
