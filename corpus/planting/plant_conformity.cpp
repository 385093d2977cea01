// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of non-conforming meshes: hanging nodes, and quadrilaterals cut along different diagonals on
// their two sides.
#include <algorithm>
#include <cmath>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// The largest distance of a hanging node from its edge or face, as a fraction of the diagonal.
constexpr double rounding = 1e-13;

double limit(const Site& s) {
  const double largest = std::max(s.parts.low.cwiseAbs().maxCoeff(), s.parts.high.cwiseAbs().maxCoeff());
  return std::max(rounding * s.parts.diagonal, 3 * largest * 0x1p-52);
}

struct Edge {
  Index a = -1, b = -1;
  std::vector<Index> around{};
};

// A random edge with at least two tetrahedra, all of them free; it lies inside or on the boundary.
Edge some_edge(Site& s, bool boundary) {
  Edge edge;
  const int turn = s.random.below(6);
  constexpr std::array<std::array<int, 2>, 6> corners{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  const Index t = s.some_tet([&](Index i) {
    for (int k = 0; k < 6; ++k) {
      const auto& [p, q] = corners[static_cast<std::size_t>((turn + k) % 6)];
      edge = {s.tet(i)[p], s.tet(i)[q], s.around(s.tet(i)[p], s.tet(i)[q])};
      if (edge.around.size() < 2 ||
          !std::all_of(edge.around.begin(), edge.around.end(), [&](Index u) { return s.free(u); }))
        continue;
      bool open = false;
      for (const Index u : edge.around)
        for (int c = 0; c < 4; ++c)
          open = open || (s.tet(u)[c] != edge.a && s.tet(u)[c] != edge.b && s.neighbour(u, c) < 0);
      if (open == boundary) return true;
    }
    return false;
  });
  return t < 0 ? Edge{} : edge;
}

void step_aside(Site& s, Point& p) {
  for (int k = 0; k < 3; ++k)
    for (int i = s.random.below(3); i > 0; --i)
      p[k] = std::nextafter(p[k], s.random.below(2) ? INFINITY : -INFINITY);
}

enum class Where { middle, third, aside };

bool hang_on_edge(Site& s, bool boundary, bool several, Where where) {
  const Edge edge = some_edge(s, boundary);
  if (edge.a < 0) return false;
  const double share = where == Where::third ? 1 / 3.0 : 0.5;
  Point p = s.at(edge.a) + share * (s.at(edge.b) - s.at(edge.a));
  if (where == Where::aside) step_aside(s, p);
  if (!within_of_line(p, s.at(edge.a), s.at(edge.b), limit(s))) return false;
  std::vector<Index> which = edge.around;
  const auto first = which.begin() + s.random.below(static_cast<int>(which.size()));
  std::rotate(which.begin(), first, which.end());
  which.resize(several ? 1 + static_cast<std::size_t>(s.random.below(static_cast<int>(which.size()) - 1))
                       : 1);
  return s.split_edge(which, edge.a, edge.b, s.add(p));
}

bool two_on_one_edge(Site& s) {
  const Edge edge = some_edge(s, false);
  if (edge.a < 0) return false;
  const Point way = s.at(edge.b) - s.at(edge.a);
  const Point p = s.at(edge.a) + way / 3, q = s.at(edge.a) + way * (2 / 3.0);
  for (const Point& node : {p, q})
    if (!within_of_line(node, s.at(edge.a), s.at(edge.b), limit(s))) return false;
  const Index first = s.add(p);
  const auto part = static_cast<Index>(s.mesh.tets.size());  // the number of the new half
  if (!s.split_edge({edge.around[0]}, edge.a, edge.b, first)) return false;
  const Tet& one = s.mesh.tets[static_cast<std::size_t>(edge.around[0])];
  const bool keeps_b = std::count(one.begin(), one.end(), edge.b) > 0;
  return s.split_edge({keeps_b ? edge.around[0] : part}, first, edge.b, s.add(q));
}

// Splits a tetrahedron into three at a node on its face.
bool hang_in_face(Site& s, std::array<double, 3> weights, bool aside) {
  Index t = -1;
  int corner = 0;
  if (!s.some_inner_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  Point p = s.at(face[0]) + weights[1] * (s.at(face[1]) - s.at(face[0])) +
            weights[2] * (s.at(face[2]) - s.at(face[0]));
  if (aside) step_aside(s, p);
  if (!within_of_plane(p, s.at(face[0]), s.at(face[1]), s.at(face[2]), limit(s))) return false;
  const Index node = s.add(p);
  bool first = true;
  for (int i = 0; i < 4; ++i) {
    if (i == corner) continue;
    Tet part = s.tet(t);
    part[static_cast<std::size_t>(i)] = node;
    if (s.sign(part) <= 0) return false;
    if (first) {
      s.mesh.tets[static_cast<std::size_t>(t)] = part;
    } else {
      s.mesh.tets.push_back(part);
      s.removed.push_back(0);
    }
    first = false;
  }
  return true;
}

// Splits the two tetrahedra of a face, one at the midpoint of an edge of the face, the other at the midpoint
// of another edge.
bool nodes_on_both_sides(Site& s) {
  Index t = -1;
  int corner = 0;
  if (!s.some_inner_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Point p = (s.at(face[0]) + s.at(face[1])) / 2, q = (s.at(face[1]) + s.at(face[2])) / 2;
  return within_of_line(p, s.at(face[0]), s.at(face[1]), limit(s)) &&
         within_of_line(q, s.at(face[1]), s.at(face[2]), limit(s)) &&
         s.split_edge({t}, face[0], face[1], s.add(p)) &&
         s.split_edge({s.neighbour(t, corner)}, face[1], face[2], s.add(q));
}

bool conforming_split(Site& s) {
  const Edge edge = some_edge(s, s.random.below(2) == 0);
  return edge.a >= 0 && s.split_edge(edge.around, edge.a, edge.b, s.add((s.at(edge.a) + s.at(edge.b)) / 2));
}

// Puts nodes on two edges of a face between two tetrahedra, and splits all tetrahedra around these edges. The
// quadrilateral between the nodes and the third edge is cut along one diagonal by one of the two tetrahedra,
// and along the other diagonal by the other one. `bend`: the distance of the first node from the face, in
// shortest edges.
bool crossed(Site& s, double bend) {
  Index t = -1;
  int corner = 0;
  if (!s.some_inner_face(t, corner)) return false;
  const Index u = s.neighbour(t, corner);
  const auto& [a, b, c] = s.face(t, corner);
  std::vector<Index> at_ab = s.around(a, b), at_ac = s.around(a, c);
  for (const auto* ring : {&at_ab, &at_ac})
    if (!std::all_of(ring->begin(), ring->end(), [&](Index i) { return s.free(i); })) return false;
  const Point n = s.normal({a, b, c}).normalized();
  const Point p = (s.at(a) + s.at(b)) / 2 + bend * s.size(t) * n, q = (s.at(a) + s.at(c)) / 2;
  if (bend == 0 && !(within_of_plane(p, s.at(a), s.at(b), s.at(c), limit(s)) &&
                     within_of_plane(q, s.at(a), s.at(b), s.at(c), limit(s))))
    return false;
  const Index x = s.add(p), y = s.add(q);
  std::erase(at_ab, u);
  std::erase(at_ac, t);
  // t is split at x first, and then its part that keeps a and c at y. u is split the other way round.
  const auto part_with = [&](Index first, Index v, Index w) {
    const auto has = [&](Index i) {
      const Tet& tet = s.mesh.tets[static_cast<std::size_t>(i)];
      return std::count(tet.begin(), tet.end(), v) && std::count(tet.begin(), tet.end(), w);
    };
    return has(first) ? first : static_cast<Index>(s.mesh.tets.size() - 1);
  };
  std::erase(at_ab, t);
  std::erase(at_ac, u);
  return s.split_edge({t}, a, b, x) && s.split_edge({part_with(t, a, c)}, a, c, y) &&
         s.split_edge({u}, a, c, y) && s.split_edge({part_with(u, a, b)}, a, b, x) &&
         s.split_edge(at_ab, a, b, x) && s.split_edge(at_ac, a, c, y);
}

bool crossed_bent(Site& s) {
  const double bend = s.magnitude(-20, -2);
  return crossed(s, s.random.below(2) ? bend : -bend);
}

}  // namespace

std::vector<PlantKind> conformity_kinds() {
  constexpr auto defective = Expected::defective, sound = Expected::sound, debatable = Expected::debatable;
  const std::vector<const char*> node{"hanging-node"}, diagonal{"crossed-diagonal"},
      holes{"cavity", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"};
  return {
      {.id = "hanging-on-edge",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = node,
       .comment = "one of the tetrahedra around an inner edge is split at the edge's midpoint",
       .mutate = [](Site& s) { return hang_on_edge(s, false, false, Where::middle); }},
      {.id = "hanging-on-edge-several",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = node,
       .comment = "some of the tetrahedra around an inner edge are split at the edge's midpoint",
       .mutate = [](Site& s) { return hang_on_edge(s, false, true, Where::middle); }},
      {.id = "hanging-at-a-third",
       .expected = defective,
       .flags = {"conformity", "rounding", "slit"},
       .needed = node,
       .comment = "one of the tetrahedra around an inner edge is split at a third of the edge, as rounded",
       .mutate = [](Site& s) { return hang_on_edge(s, false, false, Where::third); }},
      {.id = "hanging-off-edge",
       .expected = defective,
       .flags = {"conformity", "rounding", "slit"},
       .needed = node,
       .comment = "some of the tetrahedra around an inner edge are split a few units in the last place off "
                  "its midpoint",
       .mutate = [](Site& s) { return hang_on_edge(s, false, s.random.below(2) == 0, Where::aside); }},
      {.id = "hanging-twice-on-edge",
       .expected = defective,
       .flags = {"conformity", "rounding", "slit"},
       .needed = node,
       .comment = "one of the tetrahedra around an inner edge is split at both thirds of the edge",
       .mutate = two_on_one_edge},
      {.id = "hanging-on-boundary-edge",
       .expected = defective,
       .flags = {"conformity", "boundary", "slit"},
       .needed = node,
       .comment = "some of the tetrahedra around a boundary edge are split at the edge's midpoint",
       .mutate = [](Site& s) { return hang_on_edge(s, true, true, Where::middle); }},
      {.id = "hanging-off-boundary-edge",
       .expected = defective,
       .flags = {"conformity", "boundary", "rounding", "slit"},
       .needed = node,
       .comment = "some of the tetrahedra around a boundary edge are split a few units in the last place off "
                  "its midpoint",
       .mutate = [](Site& s) { return hang_on_edge(s, true, true, Where::aside); }},
      {.id = "hanging-in-face",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = node,
       .comment = "one of the two tetrahedra of a face is split at the face's centroid",
       .mutate =
           [](Site& s) {
             return hang_in_face(s, {1 / 3.0, 1 / 3.0, 1 / 3.0}, false);
           }},
      {.id = "hanging-anywhere-in-face",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = node,
       .comment = "one of the two tetrahedra of a face is split at another point of the face",
       .mutate =
           [](Site& s) {
             return hang_in_face(s, {0.25, 0.5, 0.25}, false);
           }},
      {.id = "hanging-off-face",
       .expected = defective,
       .flags = {"conformity", "rounding", "slit"},
       .needed = node,
       .comment = "one of the two tetrahedra of a face is split a few units in the last place off the face's "
                  "centroid",
       .mutate =
           [](Site& s) {
             return hang_in_face(s, {1 / 3.0, 1 / 3.0, 1 / 3.0}, true);
           }},
      {.id = "hanging-on-both-sides",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = node,
       .comment = "the two tetrahedra of a face are split at the midpoints of different edges of the face",
       .mutate = nodes_on_both_sides},
      {.id = "crossed-diagonals",
       .expected = defective,
       .flags = {"conformity", "slit"},
       .needed = diagonal,
       .comment = "a quadrilateral is cut along different diagonals on its two sides",
       .mutate = [](Site& s) { return crossed(s, 0); }},
      {.id = "crossed-diagonals-bent",
       .expected = defective,
       .flags = {"conformity", "overlap"},
       .needed = diagonal,
       .comment =
           "a bent quadrilateral is cut along different diagonals on its two sides: the tetrahedra overlap",
       .mutate = crossed_bent},
      {.id = "crossed-diagonals-open",
       .expected = debatable,
       .flags = {"conformity", "missing"},
       .needed = holes,
       .also = holes,
       .comment =
           "a bent quadrilateral is cut along different diagonals on its two sides: a tetrahedron is missing",
       .mutate = crossed_bent},
      {.id = "split-edge",
       .expected = sound,
       .flags = {"control", "conformity"},
       .comment = "all tetrahedra around an edge are split at its midpoint: nothing is wrong",
       .mutate = conforming_split},
  };
}

}  // namespace tetproof::corpus
