// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: faces that are not shared as each side has points of its own.
#include <algorithm>
#include <cmath>
#include <map>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// Gives those of `side` points of their own where others use them, too. `place`: where the new point lies.
bool crack(Site& s, const std::vector<std::uint8_t>& side,
           const std::function<Point(const Point&)>& place = {}) {
  std::map<Index, Index> own;
  for (Index t = 0; t < s.tets(); ++t) {
    if (!side[static_cast<std::size_t>(t)]) continue;
    for (Index& v : s.mesh.tets[static_cast<std::size_t>(t)]) {
      if (v < 0 || v >= static_cast<Index>(s.parts.mesh.points.size())) continue;  // of another planting
      const auto& star = s.tets_at(v);
      if (std::all_of(star.begin(), star.end(),
                      [&](Index u) { return side[static_cast<std::size_t>(u)] != 0; }))
        continue;
      const auto [at, added] = own.try_emplace(v, Index{-1});
      if (added) at->second = s.add(place ? place(s.at(v)) : s.at(v));
      v = at->second;
    }
  }
  for (const auto& [v, copy] : own) s.vertices.push_back(v);
  return !own.empty();
}

bool around_tet(Site& s) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  std::vector<std::uint8_t> side(static_cast<std::size_t>(s.tets()), 0);
  side[static_cast<std::size_t>(t)] = 1;
  return crack(s, side);
}

// A second point in the place of a vertex, for one of its tetrahedra: as many faces are cracked.
bool at_vertex(Site& s, int faces) {
  int corner = 0;
  const int turn = s.random.below(4);
  const Index t = s.some_tet([&](Index i) {
    for (int k = 0; k < 4; ++k) {
      corner = (turn + k) % 4;
      int inner = 0;
      for (int c = 0; c < 4; ++c) inner += c != corner && s.neighbour(i, c) >= 0;
      if (inner == faces) return true;
    }
    return false;
  });
  if (t < 0) return false;
  const Index v = s.tet(t)[static_cast<std::size_t>(corner)];
  s.mesh.tets[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)] = s.add(s.at(v));
  s.vertices.push_back(v);
  return true;
}

std::vector<std::uint8_t> above_plane(const Site& s, const Point& n, const Point& through) {
  std::vector<std::uint8_t> side(static_cast<std::size_t>(s.tets()), 0);
  for (Index t = 0; t < s.tets(); ++t) side[static_cast<std::size_t>(t)] = n.dot(s.centroid(t) - through) > 0;
  return side;
}

// Half of the tetrahedra at a vertex have it under another number.
bool half_star(Site& s) {
  const Index v = s.some_vertex([&](Index w) { return s.tets_at(w).size() > 3; });
  if (v < 0) return false;
  const Point n = s.direction();
  const Index own = s.add(s.at(v));
  bool any = false;
  for (const Index t : s.tets_at(v)) {
    if (n.dot(s.centroid(t) - s.at(v)) <= 0) continue;
    Tet& tet = s.mesh.tets[static_cast<std::size_t>(t)];
    std::replace(tet.begin(), tet.end(), v, own);
    any = true;
  }
  s.vertices.push_back(v);
  return any;
}

bool along_plane(Site& s, const std::function<Point(const Point&)>& place = {}) {
  return crack(s, above_plane(s, s.direction(), s.centroid(s.random.below(s.tets()))), place);
}

bool opened(Site& s) {
  const Point n = s.direction();
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  return crack(s, above_plane(s, n, s.centroid(s.random.below(s.tets()))), [&](Point p) {
    p[axis] = std::nextafter(p[axis], n[axis] > 0 ? INFINITY : -INFINITY);
    return p;
  });
}

bool opened_at_one_vertex(Site& s) {
  if (!along_plane(s)) return false;
  const auto old = static_cast<int>(s.parts.mesh.points.size()), all = static_cast<int>(s.mesh.points.size());
  Point& p = s.mesh.points[static_cast<std::size_t>(old + s.random.below(all - old))];
  p += 1e-3 * s.parts.diagonal * s.direction();
  return true;
}

bool soup(Site& s) {
  for (Tet& tet : s.mesh.tets)
    for (Index& v : tet) {
      s.vertices.push_back(v);
      v = s.add(s.at(v));
    }
  s.mesh.points.erase(s.mesh.points.begin(),
                      s.mesh.points.begin() + static_cast<std::ptrdiff_t>(s.parts.mesh.points.size()));
  for (Tet& tet : s.mesh.tets)
    for (Index& v : tet) v -= static_cast<Index>(s.parts.mesh.points.size());
  return true;
}

}  // namespace

std::vector<PlantKind> crack_kinds() {
  constexpr auto defective = Expected::defective;
  const std::vector<const char*> found{"crack"}, points{"duplicate-point"};
  return {
      {"duplicate-point-used",
       defective,
       {"cracks", "points"},
       found,
       points,
       "one tetrahedron uses a second point in the place of a vertex",
       [](Site& s) { return at_vertex(s, 3); }},
      {"crack-along-face",
       defective,
       {"cracks", "points", "boundary"},
       found,
       points,
       "one face has another vertex on its other side, in the same place",
       [](Site& s) { return at_vertex(s, 1); }},
      {"crack-around-tet",
       defective,
       {"cracks", "points"},
       found,
       points,
       "a tetrahedron has four points of its own",
       around_tet},
      {"crack-through-vertex",
       defective,
       {"cracks", "points"},
       found,
       points,
       "half of the tetrahedra at a vertex have it under another number",
       half_star},
      {"crack-through-mesh",
       defective,
       {"cracks", "points", "whole"},
       found,
       points,
       "the mesh is in two parts that only coincide",
       [](Site& s) { return along_plane(s); }},
      {"soup",
       defective,
       {"cracks", "points", "whole"},
       found,
       points,
       "every tetrahedron has points of its own",
       soup},
      {"crack-opened-by-one-unit",
       {},
       {"cracks", "rounding", "whole"},
       {"boundary-self-intersection", "overlap", "near-contact"},
       {"inverted", "flat", "hanging-node", "crossed-diagonal"},
       "the mesh in two parts, one moved away by one unit in the last place",
       opened},
      {"crack-opened-at-vertex",
       {},
       {"cracks", "points", "whole"},
       {"crack", "boundary-self-intersection", "overlap", "inverted", "flat", "cavity",
        "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       points,
       "the mesh in two parts that coincide but in one vertex",
       opened_at_one_vertex},
  };
}

}  // namespace tetproof::corpus
