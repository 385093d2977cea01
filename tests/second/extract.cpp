// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iv): the part of each lattice tetrahedron that lies inside.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/second/section2.hpp"
#include "tests/second/table2.hpp"

namespace tetproof::second {
namespace {

// What a grid point is made from, so that std::map has them in D3's order: {0, lattice vertex, 0}, {1, low,
// high} of the edge of a cut, {2, lattice tetrahedron, 0} for a centroid.
using Source = std::array<int, 3>;

// The sign that a tetrahedron of Table 2 has as listed, when v1 .. v4 is positive: that of its nominal shape,
// with cuts in the middle of their edges.
int listed_sign(const NamedTet& tet) {
  const std::array<Point, 4> v{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
  const auto point = [&](const Name& n) -> Point {
    if (n.size() == 1) return v[n[0] - 1];
    if (n.size() == 2) return (v[n[0] - 1] + v[n[1] - 1]) / 2;
    return {0.25, 0.25, 0.2};  // within the prism of case 12
  };
  return orientation(point(tet[0]), point(tet[1]), point(tet[2]), point(tet[3]));
}

bool has_edge(const std::vector<NamedTet>& row, const Name& a, const Name& b) {
  return std::any_of(row.begin(), row.end(), [&](const NamedTet& tet) {
    return std::count(tet.begin(), tet.end(), a) && std::count(tet.begin(), tet.end(), b);
  });
}

class Extraction {
 public:
  Extraction(const TriangleSurface& surface, const Lattice& lattice, const Indicators& indicators,
             const Settings& settings)
      : surface_(surface), lattice_(lattice), indicators_(indicators), settings_(settings) {}

  Grid grid() {
    Grid grid;
    for (std::size_t t = 0; t < lattice_.tets.size(); ++t) grid.rows.push_back(cut(static_cast<int>(t)));
    std::map<Source, int> numbers;
    for (const auto& tet : tets_)
      for (const Source& s : tet) numbers[s] = 0;
    for (auto& [source, number] : numbers) {
      number = static_cast<int>(grid.points.size());
      grid.points.push_back(points_.at(source));
      grid.on_surface.push_back(surface_points_.count(source) > 0);
    }
    for (const auto& tet : tets_)
      grid.tets.push_back({numbers[tet[0]], numbers[tet[1]], numbers[tet[2]], numbers[tet[3]]});
    grid.to_mend = to_mend_;
    return grid;
  }

 private:
  // The two interior vertices v, w and the exterior vertex x of a lattice face: does the diagonal of the
  // quadrilateral start at v (D9)?
  bool starts_at(int v, int w, int x) const {
    const bool lower = (v < w) != (settings_.mistake == Mistake::higher_diagonal);
    if (!settings_.shortest_diagonals) return lower;
    const Point pv = place({std::min(v, x), std::max(v, x)}), pw = place({std::min(w, x), std::max(w, x)});
    const double from_v = (lattice_.points.at(v) - pw).norm(), from_w = (lattice_.points.at(w) - pv).norm();
    const bool tie = std::abs(from_v - from_w) <= 1e-12 * std::max(from_v, from_w);
    return tie ? lower : from_v < from_w;
  }

  Point place(const std::pair<int, int>& edge) const { return indicators_.cuts.at(edge); }

  // The row of a case, and that of 10, 11 and 12 whose tetrahedra have the wanted diagonals as edges.
  std::string choose(const std::string& number, const std::array<int, 4>& v) const {
    std::vector<std::pair<Name, Name>> wanted;
    for (int a = 1; a <= 4; ++a)
      for (int b = a + 1; b <= 4; ++b)
        for (int x = 1; x <= 4; ++x) {
          const auto sign = [&](int i) { return indicators_.after.at(v[i - 1]); };
          if (sign(a) != 1 || sign(b) != 1 || sign(x) != -1) continue;
          if (starts_at(v[a - 1], v[b - 1], v[x - 1]))
            wanted.push_back({{a}, {b, x}});
          else
            wanted.push_back({{b}, {a, x}});
        }
    for (const auto& [name, tets] : table2()) {
      const bool of_case = name == number || (name.size() == 3 && name.substr(0, 2) == number);
      if (of_case && std::all_of(wanted.begin(), wanted.end(), [&, &row = tets](const auto& d) {
            return has_edge(row, d.first, d.second);
          }))
        return name;
    }
    throw std::logic_error("no row of case " + number + " has these diagonals");
  }

  Source source(const Name& name, const std::array<int, 4>& v, int tet) {
    if (name.size() == 1) {
      const int at = v[name[0] - 1];
      const auto settled = indicators_.settled.find(at);
      points_[{0, at, 0}] = settled != indicators_.settled.end() ? settled->second : lattice_.points.at(at);
      if (indicators_.after.at(at) == 0) surface_points_.insert({0, at, 0});
      return {0, at, 0};
    }
    if (name.size() == 2) {
      const auto [low, high] = std::minmax(v[name[0] - 1], v[name[1] - 1]);
      const auto vertex = indicators_.cut_at_vertex.find({low, high});
      const Source s =
          vertex != indicators_.cut_at_vertex.end() ? Source{0, vertex->second, 0} : Source{1, low, high};
      points_[s] = place({low, high});
      surface_points_.insert(s);
      return s;
    }
    Point sum(0, 0, 0);
    for (const Name& corner : {Name{1}, Name{2}, Name{3}, Name{1, 4}, Name{2, 4}, Name{3, 4}})
      sum += points_.at(source(corner, v, tet));
    points_[{2, tet, 0}] = sum / 6;
    return {2, tet, 0};
  }

  std::string cut(int t) {
    std::array<int, 4> v = lattice_.tets[t];
    const auto sign = [&](int vertex) { return indicators_.after.at(vertex); };
    std::sort(v.begin(), v.end(),
              [&](int a, int b) { return std::pair(-sign(a), a) < std::pair(-sign(b), b); });  // D8
    std::string signs;
    for (const int vertex : v) signs += "-0+"[sign(vertex) + 1];
    const std::string row = choose(table1(signs), v);
    if (row == "5" && !keep_case5(v, t)) return "5-";
    auto tets = table2().at(row);
    if (settings_.mistake == Mistake::table2_row && row == "12f")
      tets[1] = {Name{1}, Name{3}, Name{2, 4}, Name{3, 4}};
    const auto corner = [&](int i) { return lattice_.points.at(v[i]); };
    const int turn = orientation(corner(0), corner(1), corner(2), corner(3));
    for (const NamedTet& listed : tets) {
      std::array<Source, 4> tet;
      for (int i = 0; i < 4; ++i) tet[i] = source(listed[i], v, t);
      if (turn * listed_sign(listed) < 0) std::swap(tet[2], tet[3]);
      if (std::set<Source>(tet.begin(), tet.end()).size() < 4) continue;  // D7: collapsed
      tets_.push_back(tet);
      if (orientation(points_[tet[0]], points_[tet[1]], points_[tet[2]], points_[tet[3]]) <= 0) mend(v);
    }
    return row;
  }

  bool keep_case5(const std::array<int, 4>& v, int t) {
    if (settings_.literal || settings_.mistake == Mistake::case5_kept) return true;
    Point sum(0, 0, 0);
    for (int i = 1; i <= 4; ++i) sum += points_.at(source({i}, v, t));
    const Point centroid = sum / 4;
    const bool inside = !is_on(surface_, centroid) && is_inside(surface_, centroid);
    return inside != settings_.outside;
  }

  // D4: the lattice vertex nearest to the shortest cut of a lattice tetrahedron.
  void mend(const std::array<int, 4>& v) {
    double shortest = std::numeric_limits<double>::infinity();
    int nearest = -1;
    for (const auto& [edge, cut] : indicators_.cuts) {
      if (!std::count(v.begin(), v.end(), edge.first) || !std::count(v.begin(), v.end(), edge.second))
        continue;
      if (indicators_.cut_at_vertex.count(edge)) continue;
      for (const int end : {edge.first, edge.second})
        if (const double length = (cut - lattice_.points.at(end)).norm(); length < shortest) {
          shortest = length;
          nearest = end;
        }
    }
    if (nearest < 0) throw std::runtime_error("not covered: a tetrahedron without cuts is not positive");
    to_mend_.insert(nearest);
  }

  const TriangleSurface& surface_;
  const Lattice& lattice_;
  const Indicators& indicators_;
  const Settings& settings_;
  std::map<Source, Point> points_;
  std::set<Source> surface_points_;
  std::vector<std::array<Source, 4>> tets_;
  std::set<int> to_mend_;
};

}  // namespace

Grid extract(const TriangleSurface& surface, const Lattice& lattice, const Indicators& indicators,
             const Settings& settings) {
  return Extraction(surface, lattice, indicators, settings).grid();
}

}  // namespace tetproof::second
