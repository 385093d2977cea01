// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs at hubs are found in three searches for near pieces (near_pieces.hpp). Each pair of triangles, one of
// which is at a hub, is in one of them:
//
// 1. without a common hub: the triangles themselves;
// 2. with a common hub v: the directions in which v sees the triangles, arcs on the unit sphere. If two
//    triangles share a point other than v, then both arcs hold its direction;
// 3. with a common hub v and a common edge v w that has very many triangles: the directions perpendicular to
//    the edge, points on a circle. If two triangles share a point that is not on the edge, these are equal.
//
// The searches only propose pairs. Slacks cover rounding and the near distance, so they lose none.
#include "verify/triangles/hubs.hpp"

#include <CGAL/box_intersection_d.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tetproof::verify {
namespace {

using Vector = Eigen::Vector3d;

// A slack that reaches across the unit sphere: the piece is compared with all others.
constexpr double everything = 4;
// Covers all rounding in the computation of directions, and of cuts on the unit sphere.
constexpr double rounding_of_directions = 0x1p-40;
// Differences of coordinates above this have no error of underflow worth mentioning.
constexpr double smallest_length = 0x1p-900;

// The points divided by a power of two, so that no coordinate exceeds 1: products do not overflow. This is
// exact except for coordinates below 2^-1022, which change by less than 2^-1074.
class Scaled {
 public:
  Scaled(std::span<const Vector> points, std::span<const Triangle> triangles,
         std::span<const std::uint8_t> excluded)
      : points_(points) {
    double largest = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (excluded.empty() || !excluded[t])
        for (const Index v : triangles[t])
          largest = std::max(largest, points[static_cast<std::size_t>(v)].cwiseAbs().maxCoeff());
    if (largest > 0) shift_ = -std::ilogb(largest) - 1;
  }
  double length(double x) const { return std::ldexp(x, shift_); }
  Vector operator[](Index v) const {
    return points_[static_cast<std::size_t>(v)].unaryExpr([&](double x) { return length(x); });
  }

 private:
  std::span<const Vector> points_;
  int shift_ = 0;
};

// A triangle at a hub, and its other two vertices.
struct Spoke {
  Index triangle;
  std::array<Index, 2> ends;
};

struct Direction {
  Vector unit = Vector::UnitX();
  double length = 0;  // 0: too short for a direction

  Direction() = default;
  Direction(const Vector& from, const Vector& to) {
    const Vector way = to - from;
    const double norm = way.stableNorm();
    if (norm < smallest_length) return;
    unit = (way / norm).normalized();
    length = norm;
  }
};

// Encloses the arc between two directions: the triangle of both ends and the point where the arc's tangents
// at its ends meet holds it. Arcs longer than 60 degrees are halved first, until the triangles are slender.
//
// The ends have an error of a few 2^-53. A middle has 2^-52 / |u + w|, and the arc is within that of its
// halves. Nearly opposite directions have no middle.
void add_arc(const Vector& u, const Vector& w, Piece piece, std::vector<Piece>& pieces) {
  const double cosine = u.dot(w);
  const Vector sum = u + w;
  if (sum.norm() < 0x1p-8) {
    piece.slack = everything;
    piece.corners = {u, w, w};
    pieces.push_back(piece);
  } else if (cosine < 0.5) {
    const Vector middle = sum.normalized();
    add_arc(u, middle, piece, pieces);
    add_arc(middle, w, piece, pieces);
  } else {
    piece.corners = {u, w, sum / (1 + cosine)};
    pieces.push_back(piece);
  }
}

// Search 3, at the edge from a hub to `w`, among the triangles (hub, w, apex).
//
// Let L be the edge's length, h an apex's distance from the edge's line, k the distance from the apex to the
// farther end divided by h, and r the near distance. Let the half-planes of two triangles make the angle f.
// - An apex is within r of the other triangle only if h sin f <= r (f < 90 degrees) or h <= r. Note that
//   1 / h <= 2 k / L, because one end is at least L / 2 away.
// - The edges from the hub to one apex and from w to the other are within r of each other only if their
//   projections along the edge are. The projections are within r / sin f from its ends (within r, if
//   f >= 90 degrees), so the nearest points are within r k / sin f from different ends of the edge, each with
//   its own k. So L <= r (1 + (k1 + k2) / sin f).
// In both cases f <= 4 r (k1 + k2) / L if L >= 2 r, or the right side is at least 2, the diameter of the
// circle. The direction of an apex has a rounding error of a few k 2^-53.
void search_edge(const Scaled& scaled, Index hub, Index w, std::span<const Spoke> spokes, double r,
                 Threads threads, const std::function<void(Index, Index)>& report) {
  const Vector from = scaled[hub], to = scaled[w];
  const Direction axis(from, to);
  const Vector x = axis.unit.unitOrthogonal(), y = axis.unit.cross(x);
  std::vector<Piece> pieces;
  for (const Spoke& spoke : spokes) {
    const Vector apex = scaled[spoke.ends[0] == w ? spoke.ends[1] : spoke.ends[0]];
    const Vector way = apex - from;
    const double far = std::max(way.stableNorm(), (apex - to).stableNorm());
    Vector across(way.dot(x) / far, way.dot(y) / far, 0);
    const double height = across.norm();  // 1 / k
    double slack = everything;
    if (axis.length > 0 && axis.length >= 2 * r && far > smallest_length && height > 0x1p-30) {
      slack = (4 * r / axis.length + 0x1p-46) / height + rounding_of_directions;
      across /= height;
    } else {
      across = Vector::UnitX();
    }
    pieces.push_back(
        {.corners = {across, across, across}, .slack = std::min(slack, everything), .owner = spoke.triangle});
  }
  near_pieces(pieces, Compare::all, threads, report);
}

// Searches 2 and 3, among the triangles at one hub.
//
// A point p of one triangle and a point q of another that are r apart have directions that differ by at most
// 2 r / |p - hub|. Only a vertex p counts here, or edges that have the direction of a common vertex.
void search_hub(const Scaled& scaled, Index hub, std::span<const Spoke> spokes, std::size_t most, double r,
                Threads threads, const std::function<void(Index, Index)>& report) {
  // The triangles at each edge of the hub.
  std::vector<std::pair<Index, std::size_t>> edges;
  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (const Index w : spokes[i].ends) edges.emplace_back(w, i);
  std::sort(edges.begin(), edges.end());
  std::vector<Piece> faces(spokes.size());
  for (std::size_t i = 0, k = 0; i < edges.size(); i = k) {
    for (k = i; k < edges.size() && edges[k].first == edges[i].first;) ++k;
    if (k - i <= most) continue;
    std::vector<Spoke> at_edge;
    for (std::size_t j = i; j < k; ++j) {
      const std::size_t spoke = edges[j].second;
      at_edge.push_back(spokes[spoke]);
      auto& hubs = faces[spoke].hubs;
      hubs[hubs[0] < 0 ? 0 : 1] = edges[j].first;
    }
    search_edge(scaled, hub, edges[i].first, at_edge, r, threads, report);
  }
  const Vector origin = scaled[hub];
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    Piece& piece = faces[i];
    piece.owner = spokes[i].triangle;
    const Direction u(origin, scaled[spokes[i].ends[0]]), w(origin, scaled[spokes[i].ends[1]]);
    const double nearest = std::min(u.length, w.length);
    piece.slack =
        nearest > 2 * r ? std::min(everything, 2 * r / nearest + rounding_of_directions) : everything;
    add_arc(u.unit, w.unit, piece, pieces);
  }
  near_pieces(pieces, Compare::all, threads, report);
}

}  // namespace

Hubs::Hubs(std::span<const Vector> points, std::span<const Triangle> triangles,
           const std::vector<std::uint8_t>& excluded, std::size_t most)
    : points_(points), triangles_(triangles), excluded_(excluded), most_(most) {
  std::vector<std::uint32_t> count(points.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (excluded.empty() || !excluded[t])
      for (const Index v : triangles[t]) any_ = ++count[static_cast<std::size_t>(v)] > most || any_;
  if (!any_) return;
  is_hub_.resize(points.size());
  std::transform(count.begin(), count.end(), is_hub_.begin(), [&](std::uint32_t n) { return n > most; });
}

void Hubs::candidates(const std::function<double(Index)>& room, Threads threads,
                      const std::function<void(Index, Index)>& report) const {
  if (!any_) return;
  std::vector<std::pair<Index, Spoke>> at;  // hub, triangle
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& v = triangles_[t];
    if (!excluded_.empty() && excluded_[t]) continue;
    for (int k = 0; k < 3; ++k)
      if (is_hub_[v[k]]) at.push_back({v[k], {static_cast<Index>(t), {v[(k + 1) % 3], v[(k + 2) % 3]}}});
  }
  std::stable_sort(at.begin(), at.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (i == 0 || at[i].first != at[i - 1].first) starts.push_back(i);
  starts.push_back(at.size());

  const auto enlarged = [&](Index t) {
    Box box = box_of(points_, triangles_[t], static_cast<std::size_t>(t));
    for (int k = 0; k < 3; ++k) box.low[k] -= room(t), box.high[k] += room(t);
    return box;
  };
  std::vector<Box> around;  // each hub: the box of all its triangles
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    around.push_back(enlarged(at[starts[i]].second.triangle));
    around.back().number = triangles_.size() + i;
    for (std::size_t k = starts[i]; k < starts[i + 1]; ++k)
      around.back().add(enlarged(at[k].second.triangle));
  }

  const Scaled scaled(points_, triangles_, excluded_);
  const auto spread = [&](Index t) { return scaled.length(room(t)); };
  const std::vector<Index> close = triangles_in(around, enlarged);
  Vector low = scaled[triangles_[close[0]][0]], high = low;
  for (const Index t : close)
    for (const Index v : triangles_[t]) low = low.cwiseMin(scaled[v]), high = high.cwiseMax(scaled[v]);
  const Vector center = low + (high - low) / 2;
  std::vector<Piece> pieces;
  for (const Index t : close) {
    Piece piece{.owner = t};
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
      const Index v = triangles_[t][k];
      piece.corners[k] = scaled[v] - center;  // rounded, by 2^-53 of the result
      largest = std::max(largest, piece.corners[k].cwiseAbs().maxCoeff());
      if (is_hub_[v]) piece.hubs[k] = v;
    }
    piece.slack = spread(t) * (1 + 0x1p-40) + 2 * rounding_of_pieces * largest + smallest_length;
    pieces.push_back(piece);
  }
  near_pieces(pieces, Compare::pairs_with_hub, threads, report);

  const auto search = [&](std::size_t i) {
    std::vector<Spoke> spokes;
    double widest = 0;
    for (std::size_t k = starts[i]; k < starts[i + 1]; ++k) {
      spokes.push_back(at[k].second);
      widest = std::max(widest, spread(at[k].second.triangle));
    }
    search_hub(scaled, at[starts[i]].first, spokes, most_, 2 * widest, threads, report);
  };
  if (threads == Threads::all)
    tbb::parallel_for(std::size_t{0}, starts.size() - 1, search);
  else
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) search(i);
}

// The triangles at hubs, and those whose boxes meet one of `around`; ascending.
std::vector<Index> Hubs::triangles_in(std::vector<Box> around, const std::function<Box(Index)>& box) const {
  Box all = around[0];
  for (const Box& one : around) all.add(one);
  std::vector<Box> others;
  std::vector<Index> found;
  for (Index t = 0; t < static_cast<Index>(triangles_.size()); ++t) {
    if (!excluded_.empty() && excluded_[t]) continue;
    if (at_hub(triangles_[t]))
      found.push_back(t);
    else if (const Box other = box(t); other.meets(all))
      others.push_back(other);
  }
  std::vector<std::uint8_t> inside(triangles_.size(), 0);
  CGAL::box_intersection_d(around.begin(), around.end(), others.begin(), others.end(),
                           [&](const Box&, const Box& other) { inside[other.number] = 1; });
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (inside[t]) found.push_back(static_cast<Index>(t));
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace tetproof::verify
