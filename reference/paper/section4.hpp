// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: local improvement by flips. README.md has the page's sentence for each function.
#pragma once

#include <iterator>
#include <numbers>

#include "reference/paper/section3_weights.hpp"

namespace tetproof::reference::paper {

/// Two or three tetrahedra, and the other triangulation of the convex hexahedron that they fill.
struct Flip {
  Numbers old;
  std::set<int> hull{}, face{}, edge{};  ///< the five vertices; the three and the two of them
  std::vector<Tet> pieces{};             ///< the new tetrahedra
  double before = 0, after = 0;          ///< the smallest quality
};

/// tan(Omega/2) of the smallest of the four solid angles, which have one numerator (reading D20).
inline double smallest_solid_angle(const Corners& t) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    const Point a = t[i == 0 ? 1 : 0] - t[i], b = t[i <= 1 ? 2 : 1] - t[i], c = t[i <= 2 ? 3 : 2] - t[i];
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double denominator = la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la;
    largest = i == 0 ? denominator : std::max(largest, denominator);
  }
  return std::abs((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0])) / largest;
}

/// D/A (reading E5).
inline double aspect_ratio(const Corners& t) {
  double area = 0;  // of the largest face: to it belongs the smallest distance
  for (const auto& [i, j, k] : tet_faces) area = std::max(area, (t[j] - t[i]).cross(t[k] - t[i]).norm() / 2);
  return std::abs((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0])) / 2 / area / area;
}

/// S, a fraction of the full solid angle, from tan(Omega/2).
inline double solid_angle(double tangent) {
  return 2 * std::atan(tangent) / (4 * std::numbers::pi);
}

class Improvement : public Weights {
 public:
  using Weights::Weights;

  static std::set<int> common(const std::set<int>& a, const std::set<int>& b) {
    std::set<int> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
    return both;
  }
  std::set<int> vertices(std::int64_t t) const { return {tets_.at(t).v.begin(), tets_.at(t).v.end()}; }

  double quality(Tet v) const {  // reading D20
    std::sort(v.begin(), v.end());
    return options_.adapt->improve == Criterion::aspect_ratio ? aspect_ratio(corners(v))
                                                              : smallest_solid_angle(corners(v));
  }
  virtual double gain(const Flip& flip) const { return flip.after - flip.before; }

  /// (i): the set O_i, after T_i was replaced by `pieces` (reading D21).
  virtual Numbers surroundings(const Tet& replaced, const Numbers& pieces) const {
    Numbers set = pieces;
    for (const auto& [number, tet] : tets_)
      if (common(vertices(number), {replaced.begin(), replaced.end()}).size() == 3) set.insert(number);
    return set;
  }

  /// The other triangulation of two or three tetrahedra, if they fill a strictly convex hexahedron (D22).
  std::optional<Flip> flip_of(const Numbers& old) const {
    Flip flip{.old = old};
    std::set<int> in_all = vertices(*old.begin()), rest;
    for (const std::int64_t t : old) {
      for (const int v : vertices(t)) flip.hull.insert(v);
      in_all = common(in_all, vertices(t));
    }
    if (flip.hull.size() != 5 || in_all.size() != 5 - old.size()) return std::nullopt;
    std::set_difference(flip.hull.begin(), flip.hull.end(), in_all.begin(), in_all.end(),
                        std::inserter(rest, rest.end()));
    flip.face = old.size() == 2 ? in_all : rest;  // the face of two tetrahedra; opposite to the edge of three
    flip.edge = old.size() == 2 ? rest : in_all;
    const std::vector<int> f(flip.face.begin(), flip.face.end()), e(flip.edge.begin(), flip.edge.end());
    const auto side = [&](int a, int b, int c, int d) {
      return orientation(points_[a], points_[b], points_[c], points_[d]);
    };
    const int turned = side(e[0], e[1], f[0], f[1]);  // does the edge pass through the inside of the face?
    if (turned == 0 || turned != side(e[0], e[1], f[1], f[2]) || turned != side(e[0], e[1], f[2], f[0]) ||
        side(f[0], f[1], f[2], e[0]) * side(f[0], f[1], f[2], e[1]) != -1)
      return std::nullopt;
    for (const int without : in_all) {  // each new tetrahedron is the hull without one vertex
      std::set<int> four = flip.hull;
      four.erase(without);
      std::copy(four.begin(), four.end(), flip.pieces.emplace_back().begin());
    }
    std::sort(flip.pieces.begin(), flip.pieces.end());
    flip.before = flip.after = HUGE_VAL;
    for (const std::int64_t t : old) flip.before = std::min(flip.before, quality(tets_.at(t).v));
    for (Tet& piece : flip.pieces) {
      flip.after = std::min(flip.after, quality(piece));
      if (!positive(corners(piece))) std::swap(piece[2], piece[3]);
    }
    return flip;
  }

  /// The flip with the largest gain; of several, the one with the lowest vertices (reading D22).
  std::optional<Flip> best_flip(const Numbers& set) const {
    std::optional<Flip> best;
    for (const std::int64_t a : set)
      for (const std::int64_t b : set)
        for (const std::int64_t c : set) {  // b = c: only two tetrahedra
          if (a >= b || b > c) continue;
          const auto flip = flip_of({a, b, c});
          if (flip && gain(*flip) > 0 &&
              (!best || gain(*flip) > gain(*best) || (gain(*flip) == gain(*best) && flip->hull < best->hull)))
            best = flip;
        }
    return best;
  }

  /// (ii) to (iv).
  void improve(Numbers set) {
    const bool angles = options_.adapt->improve == Criterion::solid_angle;
    while (const auto flip = best_flip(set)) {
      for (const std::int64_t t : flip->old) remove(t), set.erase(t);
      for (const Tet& piece : flip->pieces) set.insert(next_), add(piece);
      ++flips_;
      trace::Flip made{.two_to_three = flip->old.size() == 2,
                       .quality_before = angles ? solid_angle(flip->before) : flip->before,
                       .quality_after = angles ? solid_angle(flip->after) : flip->after,
                       .e_avg = e_avg()};
      const auto place = [&](int p) { return points_[p]; };
      std::transform(flip->face.begin(), flip->face.end(), made.face.begin(), place);
      std::transform(flip->edge.begin(), flip->edge.end(), made.edge.begin(), place);
      record(made);
    }
  }

  std::int64_t flips_ = 0;
};

}  // namespace tetproof::reference::paper
