// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2: steps (i) to (iv), Tables 1 to 3. README.md has the page's sentence for each function.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "reference/equations.hpp"
#include "reference/options.hpp"
#include "reference/paper/geometry.hpp"
#include "reference/tables.hpp"
#include "reference/trace/first_steps.hpp"

namespace tetproof::reference::paper {

using Cell = std::array<int, 3>;   ///< i, j, k of a lattice vertex, or of the cell that starts there
using Edge = std::pair<int, int>;  ///< two lattice vertices, the lower number first
using Tet = std::array<Index, 4>;
using tables::RowPoint;

struct Grid {
  TetMesh mesh;
  std::set<int> surface_points;
};

/// Step (ii): where the surface meets a lattice edge.
struct EdgePoints {
  std::vector<Rational> inner;  ///< the points of the open edge that count (reading D6), ascending
  std::vector<std::pair<Interval, Triangle>> parts;  ///< what each triangle has in common with the edge
  bool along = false;  ///< whether a triangle in one plane with the edge has a part of the open edge
};

class Section2 {
 public:
  /// The surface must be closed, 2-manifold and free of self-intersections, every vertex must be a
  /// triangle's, and it must outlive this object.
  Section2(const TriangleSurface& surface, const Options& options) : surface_(surface), options_(options) {
    for (const auto& [a, b, c] : surface.triangles)
      triangles_.push_back({surface.vertices[a], surface.vertices[b], surface.vertices[c]});
  }
  virtual ~Section2() = default;

  // --- (i) the lattice

  int number(const Cell& at) const { return at[0] + (cells_[0] + 1) * (at[1] + (cells_[1] + 1) * at[2]); }

  /// Step (i), eq. (2.1), readings D1 to D3.
  void make_lattice() {
    Point low = triangles_.at(0)[0], high = low;
    for (const Triangle& t : triangles_)
      for (const Point& p : t) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Point centre = 0.5 * (low + high), sides = high - low, half = 0.5 * sides * options_.box_scale;
    cells_ = options_.cells;
    for (int x = 0; x < 3 && options_.cells[1] == 0; ++x)  // one number, for the longest side
      cells_[x] = std::max(std::min(4, options_.cells[0]),
                           static_cast<int>(std::lround(options_.cells[0] * sides[x] / sides.maxCoeff())));
    for (int x = 0; x < 3; ++x) {
      const double first = centre[x] - half[x], last = centre[x] + half[x];
      for (int i = 0; i <= cells_[x]; ++i)
        planes_[x].push_back(eq_2_1(first, last, static_cast<double>(i) / cells_[x]));
      shortest_edge_ = std::min(shortest_edge_, (last - first) / cells_[x]);
    }
    for (const double z : planes_[2])
      for (const double y : planes_[1])
        for (const double x : planes_[0]) lattice_.emplace_back(x, y, z);
    for (int k = 0; k < cells_[2]; ++k)
      for (int j = 0; j < cells_[1]; ++j)
        for (int i = 0; i < cells_[0]; ++i) {
          std::array<int, 3> axes{0, 1, 2};
          do {  // a path along the three axes, in each of their orders (reading D2)
            Cell at{i, j, k};
            Tet tet{number(at)};
            for (int step = 0; step < 3; ++step) ++at[axes[step]], tet[step + 1] = number(at);
            lattice_tets_.push_back(tet);
            for (int a = 0; a < 4; ++a)
              for (int b = a + 1; b < 4; ++b) edges_.insert({tet[a], tet[b]});
          } while (std::next_permutation(axes.begin(), axes.end()));
        }
  }

  // --- (ii) edges and the surface

  /// Step (ii), reading D6: points are counted, not crossings; of parts along the edge, the ends of their
  /// union.
  EdgePoints intersect(const Point& p, const Point& q) const {
    EdgePoints met;
    for (const Triangle& t : triangles_)
      if (const auto part = common_part(p, q, t)) {
        met.parts.push_back({*part, sorted(t)});
        met.along |= part->first < 1 && part->second > 0 && in_plane(p, t) && in_plane(q, t);
      }
    const auto& parts = met.parts;
    std::sort(met.parts.begin(), met.parts.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < parts.size();) {
      auto [first, last] = parts[i].first;
      while (++i < parts.size() && parts[i].first.first <= last) last = std::max(last, parts[i].first.second);
      for (const Rational& s : {first, last})
        if (s > 0 && s < 1 && (met.inner.empty() || met.inner.back() < s)) met.inner.push_back(s);
    }
    return met;
  }

  /// Reading D6: the coordinates of the point p + s (q-p) in which triangles cut an edge.
  Point place_of_cut(const Point& p, const Point& q, const EdgePoints& met, const Rational& s) const {
    std::optional<Triangle> smallest;  // of the triangles that go through the point
    for (const auto& [part, t] : met.parts)
      if (part == Interval(s, s) && (!smallest || lexicographically_less(t, *smallest))) smallest = t;
    std::optional<std::pair<double, double>> from;  // s and 1-s
    if (!met.along) from = cut_in_doubles(p, q, smallest.value());
    if (!from) from = std::pair(s.convert_to<double>(), Rational(1 - s).convert_to<double>());
    const Point d = q - p;
    return from->first <= from->second ? Point(p + from->first * d) : Point(q - from->second * d);
  }

  // --- (iii) indicators

  bool is_inside(const Point& p) const {  // reading D4
    bool inside = false;
    for (const Triangle& t : triangles_) inside = inside != crosses_before(t, p);
    return inside;
  }
  bool is_on_surface(const Point& p) const {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) { return is_on(t, p); });
  }

  /// Reading D4: of several closest points the lexicographically smallest; p itself if it is on the surface.
  Point closest_on_surface(const Point& p) const {
    if (is_on_surface(p)) return p;
    Point best = triangles_.at(0)[0];
    for (const Triangle& t : triangles_) {
      const Point low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
      const double before = (best - p).squaredNorm(), box = (p.cwiseMax(low).cwiseMin(high) - p).norm();
      // Far away. The second term is more than rounding moves a closest point.
      if (box > std::sqrt(before) * (1 + 1e-9) + 1e-13 * (low.norm() + high.norm() + p.norm())) continue;
      const Point q = closest_point(t, p);
      const double now = (q - p).squaredNorm();
      if (now < before || (now == before && lexicographically_less(q, best))) best = q;
    }
    return best;
  }

  /// Step (iii): the indicators before and after Table 3, and the cut of each edge between -1 and +1.
  void characterize() {
    const double tolerance = options_.literal ? 0 : options_.on_surface * shortest_edge_;
    initial_.clear(), settled_.clear(), cuts_.clear(), cut_at_vertex_.clear();
    for (int v = 0; v < static_cast<int>(lattice_.size()); ++v) {
      const Point p = lattice_[v], closest = closest_on_surface(p);
      const bool settles = mended_.contains(v) || (closest - p).squaredNorm() < tolerance * tolerance;
      if (settles) settled_[v] = closest;                                       // reading D4
      const bool inside = is_inside(p) == (options_.region == Region::inside);  // reading D5
      initial_.push_back(settles || is_on_surface(p) ? 0 : inside ? 1 : -1);
    }
    std::map<Edge, EdgePoints> met;
    for (const auto& [v, w] : edges_)
      if (!settled_.contains(v) && !settled_.contains(w)) met[{v, w}] = intersect(lattice_[v], lattice_[w]);
    apply_table3(met);
    for (const auto& [e, points] : met) {
      if (after_[e.first] * after_[e.second] != -1) continue;
      const bool first_is_exterior = after_[e.first] == -1;
      const auto [exterior, interior] = first_is_exterior ? e : Edge(e.second, e.first);
      if (initial_[exterior] != 0 && !points.inner.empty()) {
        const Rational& s = closest_to_exterior(points, first_is_exterior);
        cuts_[e] = place_of_cut(lattice_[e.first], lattice_[e.second], points, s);
      } else {  // reading D7
        cut_at_vertex_[e] = initial_[exterior] == 0 ? exterior : interior;
        cuts_[e] = lattice_[cut_at_vertex_[e]];
        if (initial_[cut_at_vertex_[e]] != 0)
          throw std::logic_error("an edge does not meet the surface (E6)");
      }
    }
  }

  /// Table 3. All requests come from the initial indicators and are applied at once (reading D6).
  void apply_table3(const std::map<Edge, EdgePoints>& met) {
    std::map<int, std::set<int>> requests;
    table3_.fill(0), dropped_ = 0;
    for (const auto& [e, points] : met) {
      auto [vi, vj] = e;
      if (initial_[vi] > initial_[vj]) std::swap(vi, vj);
      const int needed = initial_[vi] * initial_[vj] == -1, count = static_cast<int>(points.inner.size());
      if (count <= needed) continue;
      const int row = tables::table3_row(initial_[vi], initial_[vj]);
      if (initial_[vi] == 0) requests[vi].insert(tables::table3[row].new_vi);
      if (initial_[vj] == 0) requests[vj].insert(tables::table3[row].new_vj);
      ++table3_[row];
      dropped_ += count - needed;
    }
    after_ = initial_;
    for (const auto& [v, signs] : requests) after_[v] = asked_for(signs);
  }
  virtual int asked_for(const std::set<int>& signs) const { return *signs.begin(); }  // of both: -1 (D6)
  virtual const Rational& closest_to_exterior(const EdgePoints& met, bool exterior_is_first) const {  // 3b
    return exterior_is_first ? met.inner.front() : met.inner.back();
  }

  // --- (iv) the second triangulation

  /// Reading D9: whether the diagonal of a quadrilateral starts at the lower of the two interior vertices.
  virtual bool starts_at_lower(int lower, int higher, int exterior) const {
    if (options_.diagonals == Diagonals::lowest) return true;
    const auto squared = [&](int v, int w) {
      return (lattice_[v] - cuts_.at(std::minmax({w, exterior}))).squaredNorm();
    };
    return squared(lower, higher) <= squared(higher, lower) * (1 + 2e-12);
  }

  /// The row of Table 2 for vertices in the order of reading D8: of the rows with their indicators, the one
  /// whose tetrahedra have the wanted diagonals as edges (reading D9).
  virtual tables::Table2Row choose_row(const Tet& v) const {
    std::vector<std::pair<RowPoint, RowPoint>> wanted;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        for (int x = b + 1; x < 4; ++x) {
          if (after_[v[a]] != 1 || after_[v[b]] != 1 || after_[v[x]] != -1) continue;  // no quadrilateral
          const auto [start, other] = starts_at_lower(v[a], v[b], v[x]) ? Edge(a, b) : Edge(b, a);
          const auto cut = std::find(ends.begin(), ends.end(), Edge(other, x)) - ends.begin();
          wanted.push_back({static_cast<RowPoint>(start), static_cast<RowPoint>(tables::p12 + cut)});
        }
    for (const tables::Table2Row& row : tables::table2) {
      bool fits = true;
      for (int i = 0; i < 4; ++i) fits = fits && row.indicators[i] == after_[v[i]];
      for (const auto& diagonal : wanted)
        fits = fits && std::any_of(row.tets.begin(), row.tets.begin() + row.size, [&](const auto& tet) {
                 return std::count(tet.begin(), tet.end(), diagonal.first) &&
                        std::count(tet.begin(), tet.end(), diagonal.second);
               });
      if (fits) return row;
    }
    throw std::logic_error("no row of Table 2 has these diagonals");
  }

  /// Reading E7: the sign of a listed tetrahedron if (v1,v2,v3,v4) is positive, from cuts at midpoints.
  static int listed_sign(const std::array<RowPoint, 4>& tet) {
    const std::array<Point, 4> v{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
    const auto place = [&](RowPoint p) -> Point {
      if (p == tables::c) return {0.25, 0.25, 0.2};  // within the prism of case 12
      return p < tables::p12 ? v[p]
                             : Point((v[ends[p - tables::p12].first] + v[ends[p - tables::p12].second]) / 2);
    };
    return orientation(place(tet[0]), place(tet[1]), place(tet[2]), place(tet[3]));
  }

  virtual bool keeps_case_5(const Point& centroid) const {  // reading D10
    const bool inside = !is_on_surface(centroid) && is_inside(centroid);
    return options_.literal || inside == (options_.region == Region::inside);
  }

  /// Reading D4: the lattice vertex nearest to the shortest cut of a lattice tetrahedron, or -1.
  int vertex_to_mend(const Tet& v) const {
    double shortest = HUGE_VAL;
    int nearest = -1;
    const auto has = [&](int vertex) { return std::count(v.begin(), v.end(), vertex) > 0; };
    for (const auto& [e, cut] : cuts_)
      for (const int end : {e.first, e.second})
        if (has(e.first) && has(e.second) && !cut_at_vertex_.contains(e))
          if (const double length = (cut - lattice_[end]).norm(); length < shortest)
            shortest = length, nearest = end;
    return nearest;
  }

  /// Step (iv). A point of the grid is known by its source, in the order of reading D3: {0, lattice vertex,
  /// 0}; {1, low, high} for the cut of an edge; {2, lattice tetrahedron, 0} for a centroid.
  Grid extract() {
    using Source = std::array<int, 3>;
    std::map<Source, Point> places;
    std::set<Source> on_surface;
    std::vector<std::array<Source, 4>> tets;
    std::set<int> to_mend;
    rows_.clear();
    collapsed_ = not_positive_ = 0;
    for (int n = 0; n < static_cast<int>(lattice_tets_.size()); ++n) {
      Tet v = lattice_tets_[n];
      std::sort(v.begin(), v.end(),  // reading D8
                [&](int a, int b) { return std::pair(-after_[a], a) < std::pair(-after_[b], b); });
      const tables::Table2Row row = choose_row(v);
      const std::function<Source(RowPoint)> source = [&](RowPoint p) {
        if (p < tables::p12) {
          const Source s{0, v[p], 0};
          places[s] = settled_.contains(v[p]) ? settled_.at(v[p]) : lattice_[v[p]];
          if (after_[v[p]] == 0) on_surface.insert(s);
          return s;
        }
        if (p == tables::c) {
          Point sum(0, 0, 0);
          for (const RowPoint q : {tables::v1, tables::v2, tables::v3, tables::p14, tables::p24, tables::p34})
            sum += places.at(source(q));
          places[{2, n, 0}] = sum / 6;
          return Source{2, n, 0};
        }
        const Edge e = std::minmax({v[ends[p - tables::p12].first], v[ends[p - tables::p12].second]});
        const bool at_vertex = cut_at_vertex_.contains(e);  // reading D7
        const Source s = at_vertex ? Source{0, cut_at_vertex_.at(e), 0} : Source{1, e.first, e.second};
        places[s] = cuts_.at(e);
        on_surface.insert(s);
        return s;
      };
      Point sum(0, 0, 0);
      for (int i = 0; i < 4 && row.name == "5"; ++i) sum += places[source(static_cast<RowPoint>(i))];
      const bool kept = row.name != "5" || keeps_case_5(sum / 4);
      rows_.emplace_back(kept ? row.name : "5-");
      const int turned = orientation(lattice_[v[0]], lattice_[v[1]], lattice_[v[2]], lattice_[v[3]]);
      for (int t = 0; t < row.size && kept; ++t) {
        std::array<Source, 4> tet;
        for (int i = 0; i < 4; ++i) tet[i] = source(row.tets[t][i]);
        if (turned * listed_sign(row.tets[t]) < 0) std::swap(tet[2], tet[3]);  // readings D8 and E7
        if (std::set<Source>(tet.begin(), tet.end()).size() < 4) {             // reading D7
          ++collapsed_;
          continue;
        }
        tets.push_back(tet);
        if (orientation(places[tet[0]], places[tet[1]], places[tet[2]], places[tet[3]]) > 0) continue;
        ++not_positive_;
        if (const int vertex = vertex_to_mend(v); vertex >= 0 && !options_.literal) to_mend.insert(vertex);
      }
    }
    if (!to_mend.empty()) {  // they are 0 for good, and steps (ii) to (iv) are made once more (reading D4)
      mended_.insert(to_mend.begin(), to_mend.end());
      characterize();
      return extract();
    }
    std::map<Source, int> numbers;
    for (const auto& tet : tets)
      for (const Source& s : tet) numbers[s] = 0;
    Grid grid;
    for (auto& [source, number] : numbers) {
      number = static_cast<int>(grid.mesh.points.size());
      grid.mesh.points.push_back(places.at(source));
      if (on_surface.contains(source)) grid.surface_points.insert(number);
    }
    for (const auto& [a, b, c, d] : tets)
      grid.mesh.tets.push_back({numbers[a], numbers[b], numbers[c], numbers[d]});
    return grid;
  }

  /// The edges of a tetrahedron in the order of p12, p13, p14, p23, p24, p34.
  static constexpr std::array<Edge, 6> ends{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  const TriangleSurface& surface_;
  const Options options_;
  std::vector<Triangle> triangles_;

  std::array<int, 3> cells_{};                 ///< nx, ny, nz
  std::array<std::vector<double>, 3> planes_;  ///< the coordinates of the lattice planes
  double shortest_edge_ = HUGE_VAL;            ///< of a cell
  std::vector<Point> lattice_;                 ///< its vertices
  std::vector<Tet> lattice_tets_;              ///< by cell, then by the order of the axes
  std::set<Edge> edges_;                       ///< of the lattice
  std::vector<int> initial_, after_;           ///< the indicators of the lattice vertices
  std::map<int, Point> settled_;               ///< lattice vertices that are 0 for good, and their places
  std::set<int> mended_;                       ///< those that rounding made so
  std::map<Edge, Point> cuts_;                 ///< of the edges between -1 and +1
  std::map<Edge, int> cut_at_vertex_;          ///< those cuts that are an end of their edge
  std::vector<std::string> rows_;              ///< of Table 2, for each lattice tetrahedron
  // Counts, for the report:
  std::array<std::int64_t, tables::table3.size()> table3_{};
  std::int64_t dropped_ = 0, collapsed_ = 0, not_positive_ = 0;
};

}  // namespace tetproof::reference::paper
