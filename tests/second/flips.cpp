// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: local improvement, by trying every pair and every triple of tetrahedra of the set.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

using Tet = std::array<int, 4>;

std::set<int> vertices(const Tet& v) {
  return {v.begin(), v.end()};
}

std::set<int> common(const std::set<int>& a, const std::set<int>& b) {
  std::set<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

}  // namespace

/// A flip that could be made: what goes, what comes.
struct Adaptation::FlipPlan {
  std::set<std::int64_t> old;
  std::set<int> hull;            // its five vertices
  std::set<int> face, edge;      // the face between two tetrahedra, the edge within three
  std::vector<Tet> pieces;       // positive
  double before = 0, after = 0;  // smallest quality
};

// O_i: the new tetrahedra and the face neighbours of the one that they replaced (D21).
std::set<std::int64_t> Adaptation::surroundings(const Tet& replaced,
                                                const std::set<std::int64_t>& pieces) const {
  std::set<std::int64_t> set = pieces;
  for (const auto& [number, tet] : tets_) {
    const bool neighbour =
        common(vertices(tet.v), vertices(replaced)).size() == 3 && pieces.count(number) == 0;
    if (settings_.mistake == Mistake::flips_everywhere ||
        (neighbour && settings_.mistake != Mistake::tetrahedron_without_neighbours))
      set.insert(number);
  }
  return set;
}

// The other triangulation of the hull of two or three tetrahedra, if there is one.
std::optional<Adaptation::FlipPlan> Adaptation::plan(const std::set<std::int64_t>& old) const {
  FlipPlan flip{.old = old};
  std::set<int> in_all = vertices(tets_.at(*old.begin()).v);
  for (const std::int64_t t : old) {
    const auto v = vertices(tets_.at(t).v);
    flip.hull.insert(v.begin(), v.end());
    in_all = common(in_all, v);
  }
  if (flip.hull.size() != 5 || in_all.size() != 5 - old.size())
    return std::nullopt;  // a face of two, an edge of three
  std::set<int> rest;
  std::set_difference(flip.hull.begin(), flip.hull.end(), in_all.begin(), in_all.end(),
                      std::inserter(rest, rest.end()));
  flip.face = old.size() == 2 ? in_all : rest;
  flip.edge = old.size() == 2 ? rest : in_all;
  if (old.size() == 3 && edges_.at({*flip.edge.begin(), *flip.edge.rbegin()}) != 3) return std::nullopt;

  // What comes: all of the hull but one vertex, which is a vertex of what was common.
  for (const int without : in_all) {
    std::vector<int> four;
    for (const int v : flip.hull)
      if (v != without) four.push_back(v);
    flip.pieces.push_back({four[0], four[1], four[2], four[3]});
  }
  std::sort(flip.pieces.begin(), flip.pieces.end());
  const auto least = [&](double so_far, const Tet& sorted) {
    return std::min(so_far, quality(corners(sorted), settings_.improve));
  };
  flip.before = flip.after = std::numeric_limits<double>::infinity();
  for (const std::int64_t t : old) {
    Tet sorted = tets_.at(t).v;
    std::sort(sorted.begin(), sorted.end());
    flip.before = least(flip.before, sorted);
  }
  for (Tet& piece : flip.pieces) {
    flip.after = least(flip.after, piece);
    const Corners c = corners(piece);
    if (orientation(c[0], c[1], c[2], c[3]) < 0) std::swap(piece[2], piece[3]);
  }

  // The hull is strictly convex if the edge passes through the inner of the face.
  const std::vector<int> f(flip.face.begin(), flip.face.end()), e(flip.edge.begin(), flip.edge.end());
  const auto side = [&](int a, int b, int c, int d) {
    return orientation(points_[a], points_[b], points_[c], points_[d]);
  };
  const int turn = side(e[0], e[1], f[0], f[1]);
  const bool convex = turn != 0 && turn == side(e[0], e[1], f[1], f[2]) &&
                      turn == side(e[0], e[1], f[2], f[0]) &&
                      side(f[0], f[1], f[2], e[0]) * side(f[0], f[1], f[2], e[1]) == -1;
  if (!convex) return std::nullopt;
  return flip;
}

// The flip of the set that raises the smallest quality most; of several, the one with the lowest vertices.
std::optional<Adaptation::FlipPlan> Adaptation::best_flip(const std::set<std::int64_t>& set) const {
  std::vector<std::set<std::int64_t>> groups;
  for (const std::int64_t a : set)
    for (const std::int64_t b : set)
      if (a < b) {
        groups.push_back({a, b});
        for (const std::int64_t c : set)
          if (b < c) groups.push_back({a, b, c});
      }
  const double sign = settings_.mistake == Mistake::worst_flip ? -1 : 1;
  std::optional<FlipPlan> best;
  double most = 0;
  for (const auto& group : groups)
    if (auto flip = plan(group)) {
      const double gain = sign * (flip->after - flip->before);
      if (gain > most || (best && gain == most && flip->hull < best->hull)) {
        most = gain;
        best = std::move(flip);
      }
    }
  return best;
}

void Adaptation::improve(std::set<std::int64_t> set, std::vector<trace::Record>& records) {
  const auto shown = [&](double quality) {  // tan(Omega/2) as a part of the whole sphere; D/A as it is
    return settings_.improve == Quality::solid_angle ? 2 * std::atan(quality) / (4 * std::numbers::pi)
                                                     : quality;
  };
  while (const auto flip = best_flip(set)) {
    for (const std::int64_t t : flip->old) {
      remove(t);
      set.erase(t);
    }
    for (const Tet& piece : flip->pieces) {
      set.insert(next_);
      add(piece);
    }
    ++flips_;
    trace::Flip record{.two_to_three = flip->old.size() == 2};
    int i = 0;
    for (const int v : flip->face) record.face[i++] = points_[v];
    record.edge = {points_[*flip->edge.begin()], points_[*flip->edge.rbegin()]};
    record.quality_before = shown(flip->before);
    record.quality_after = shown(flip->after);
    record.e_avg = average();
    records.push_back(record);
    if (settings_.mistake == Mistake::worst_flip) break;  // or it would not end in a test's time
  }
}

}  // namespace tetproof::second
