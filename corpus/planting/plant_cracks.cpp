// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of cracks: coincident faces that are not shared, because each side has its own copies of the
// points.
#include <algorithm>
#include <cmath>
#include <map>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// Gives the tetrahedra of `side` their own copies of the points that they share with other tetrahedra.
// `place` maps a point to its copy; if empty, the copy has the same coordinates.
bool crack(Site& s, const std::vector<std::uint8_t>& side,
           const std::function<Point(const Point&)>& place = {}) {
  std::map<Index, Index> own;
  for (Index t = 0; t < s.tets(); ++t) {
    if (!side[static_cast<std::size_t>(t)]) continue;
    for (Index& v : s.mesh.tets[static_cast<std::size_t>(t)]) {
      if (v < 0 || v >= static_cast<Index>(s.parts.mesh.points.size()))
        continue;  // a point of the first of two plantings
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

// Gives one tetrahedron its own copy of one vertex. `faces`: the number of its shared faces at this vertex,
// which become cracks.
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

// Gives about half of the tetrahedra at a vertex a common second copy of it.
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
  const int copy = old + s.random.below(all - old);
  Point& p = s.mesh.points[static_cast<std::size_t>(copy)];
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
      {.id = "duplicate-point-used",
       .expected = defective,
       .flags = {"cracks", "points"},
       .needed = found,
       .also = points,
       .comment = "one tetrahedron uses a second point with the coordinates of a vertex",
       .mutate = [](Site& s) { return at_vertex(s, 3); }},
      {.id = "crack-along-face",
       .expected = defective,
       .flags = {"cracks", "points", "boundary"},
       .needed = found,
       .also = points,
       .comment =
           "one face has a different point on each side at one of its vertices, with the same coordinates",
       .mutate = [](Site& s) { return at_vertex(s, 1); }},
      {.id = "crack-around-tet",
       .expected = defective,
       .flags = {"cracks", "points"},
       .needed = found,
       .also = points,
       .comment = "a tetrahedron has its own copies of its four points",
       .mutate = around_tet},
      {.id = "crack-through-vertex",
       .expected = defective,
       .flags = {"cracks", "points"},
       .needed = found,
       .also = points,
       .comment = "half of the tetrahedra at a vertex use a second point with the same coordinates",
       .mutate = half_star},
      {.id = "crack-through-mesh",
       .expected = defective,
       .flags = {"cracks", "points", "whole"},
       .needed = found,
       .also = points,
       .comment = "the mesh is cut in two parts that coincide along the cut but share no points there",
       .mutate = [](Site& s) { return along_plane(s); }},
      {.id = "soup",
       .expected = defective,
       .flags = {"cracks", "points", "whole"},
       .needed = found,
       .also = points,
       .comment = "every tetrahedron has its own points",
       .mutate = soup},
      {.id = "crack-opened-by-one-unit",
       .flags = {"cracks", "rounding", "whole"},
       .needed = {"non-conforming-interface", "boundary-self-intersection", "overlap", "near-contact"},
       .also = {"inverted", "flat", "hanging-node", "crossed-diagonal", "cavity"},
       .comment = "the mesh is cut in two parts, and the cut is opened by one unit in the last place",
       .mutate = opened},
      {.id = "crack-opened-at-vertex",
       .flags = {"cracks", "points", "whole"},
       .needed = {"crack", "non-conforming-interface", "boundary-self-intersection", "overlap", "inverted",
                  "flat", "cavity", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       .also = points,
       .comment = "the mesh is cut in two parts that coincide along the cut except at one vertex",
       .mutate = opened_at_one_vertex},
  };
}

}  // namespace tetproof::corpus
