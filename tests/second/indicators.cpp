// SPDX-License-Identifier: GPL-3.0-or-later
// Steps (i) to (iii): the lattice, its edges' intersections with the surface, and Table 3.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/second/edge_intersections.hpp"
#include "tests/second/section2.hpp"

namespace tetproof::second {

Lattice make_lattice(const TriangleSurface& surface, const Settings& settings) {
  Lattice lattice;
  Point low = surface.vertices.at(0), high = low;
  for (const Point& v : surface.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const Point centre = (low + high) / 2, half = settings.box_scale * (high - low) / 2;
  lattice.low = centre - half;
  lattice.high = centre + half;
  const Point size = lattice.high - lattice.low;
  lattice.cells = settings.cells;
  if (settings.cells[1] == 0) {  // one number, along the longest side (D1)
    const Point side = high - low;
    for (int axis = 0; axis < 3; ++axis)
      lattice.cells[axis] =
          std::max(1, static_cast<int>(std::lround(settings.cells[0] * side[axis] / side.maxCoeff())));
  }
  const auto& n = lattice.cells;
  lattice.shortest_cell_edge = std::min({size[0] / n[0], size[1] / n[1], size[2] / n[2]});

  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {  // eq. (2.1), a coordinate at a time
        const Place at{i, j, k};
        Point y;
        for (int axis = 0; axis < 3; ++axis) {
          const double u = static_cast<double>(at[axis]) / n[axis];
          y[axis] = (1 - u) * lattice.low[axis] + u * lattice.high[axis];
        }
        lattice.points[lattice.number(at)] = y;
        lattice.places[lattice.number(at)] = at;
      }

  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {  // D2: a path along the axes in each of their orders
          Place at{i, j, k};
          std::array<int, 4> tet{lattice.number(at)};
          for (int step = 0; step < 3; ++step) {
            ++at[axes[step]];
            tet[step + 1] = lattice.number(at);
          }
          lattice.tets.push_back(tet);
          for (int a = 0; a < 4; ++a)
            for (int b = a + 1; b < 4; ++b) lattice.edges.insert({tet[a], tet[b]});
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return lattice;
}

Indicators characterize(const TriangleSurface& surface, const Lattice& lattice, const Settings& settings,
                        const std::set<int>& mended) {
  Indicators result;
  const double tolerance = settings.literal ? 0 : settings.on_surface * lattice.shortest_cell_edge;
  for (const auto& [v, point] : lattice.points) {
    const Point closest = closest_on_surface(surface, point);
    if (mended.count(v) || (closest - point).norm() < tolerance) {
      result.settled[v] = closest;
      result.initial[v] = 0;
    } else {
      result.initial[v] = is_on(surface, point) ? 0 : is_inside(surface, point) != settings.outside ? 1 : -1;
    }
  }

  // Table 3: what each 0 is asked for by the edges that meet the surface in more points than their indicators
  // need.
  const auto& initial = result.initial;
  std::map<std::pair<int, int>, std::vector<std::pair<Rational, Rational>>> parts;
  std::map<int, std::set<int>> asked;
  for (const auto& [v, w] : lattice.edges) {
    if (result.settled.count(v) || result.settled.count(w)) continue;
    auto& on = parts[{v, w}] = meets(surface, lattice.points.at(v), lattice.points.at(w));
    std::set<Rational> inner;
    for (const auto& [from, to] : on)
      for (const Rational& t : {from, to})
        if (t > 0 && t < 1) inner.insert(t);
    if (inner.size() < (initial.at(v) * initial.at(w) == -1 ? 2u : 1u)) continue;
    for (const auto& [zero, other] : {std::pair{v, w}, std::pair{w, v}})
      if (initial.at(zero) == 0) asked[zero].insert(initial.at(other) == -1 ? -1 : 1);  // rows 2; 4 and 5
  }
  result.after = initial;
  for (const auto& [v, signs] : asked)
    result.after[v] = settings.mistake == Mistake::asked_for_both ? *signs.rbegin() : *signs.begin();

  // The intersection of each edge between -1 and +1: the one closest to the exterior end (row 3b).
  for (const auto& [edge, on] : parts) {
    const auto [v, w] = edge;
    if (result.after.at(v) * result.after.at(w) != -1) continue;
    if (on.empty()) throw std::logic_error("an edge between -1 and +1 does not meet the surface");
    const bool from_v = (result.after.at(v) == -1) != (settings.mistake == Mistake::table3_interior_end);
    const Rational t = from_v ? on.front().first : on.back().second;
    result.cuts[edge] = t == 0   ? lattice.points.at(v)
                        : t == 1 ? lattice.points.at(w)
                                 : along(lattice.points.at(v), lattice.points.at(w), t);
    if (t == 0) result.cut_at_vertex[edge] = v;
    if (t == 1) result.cut_at_vertex[edge] = w;
  }
  return result;
}

}  // namespace tetproof::second
