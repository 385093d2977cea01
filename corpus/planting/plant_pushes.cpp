// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds in which a vertex is pushed through an opposite face, or into its plane.
#include <algorithm>
#include <utility>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// A vertex, and the face opposite to it in one of its tetrahedra.
struct Push {
  Index vertex = -1;
  Face face{};
};
Push some_push(Site& s, bool inner) {
  Push push;
  push.vertex = s.some_vertex([&](Index v) { return (s.parts.on_boundary[at(v)] == 0) == inner; });
  if (push.vertex < 0) return push;
  const auto& star = s.tets_at(push.vertex);
  const Index t = star[at(s.random.below(static_cast<int>(star.size())))];
  const auto corner = std::find(s.tet(t).begin(), s.tet(t).end(), push.vertex) - s.tet(t).begin();
  push.face = s.face(t, static_cast<int>(corner));
  return push;
}

bool push_through(Site& s, bool inner, double least, double most) {
  const Push push = some_push(s, inner);
  if (push.vertex < 0) return false;
  const Point foot = s.centroid(push.face);
  s.mesh.points[at(push.vertex)] += (1 + s.random.between(least, most)) * (foot - s.at(push.vertex));
  return true;
}

bool push_one_unit(Site& s, bool inner) {
  const Push push = some_push(s, inner);
  if (push.vertex < 0) return false;
  Point p = s.centroid(push.face);
  if (!s.step_through(push.face, p, 1)) return false;
  s.mesh.points[at(push.vertex)] = p;
  return true;
}

bool push_into(Site& s, std::array<double, 3> weights) {
  const Push push = some_push(s, true);
  if (push.vertex < 0) return false;
  const int turn = s.random.below(3);
  Point p(0, 0, 0);
  for (int k = 0; k < 3; ++k) p += weights[k] * s.at(push.face[(k + turn) % 3]);
  s.mesh.points[at(push.vertex)] = p;
  return orientation(s.at(push.face[0]), s.at(push.face[1]), s.at(push.face[2]), p) == 0;
}

bool rewound(Site& s) {
  if (!push_through(s, true, 0.2, 1.5)) return false;
  for (Tet& t : s.mesh.tets)
    if (s.sign(t) < 0) std::swap(t[0], t[1]);
  return true;
}

}  // namespace

std::vector<PlantKind> push_kinds() {
  constexpr auto defective = Expected::defective;
  return {
      {.id = "pushed-through",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"inverted"},
       .also = {"flat"},
       .comment = "an inner vertex is pushed far through the opposite face of one of its tetrahedra",
       .mutate = [](Site& s) { return push_through(s, true, 0.1, 2); }},
      {.id = "pushed-through-from-boundary",
       .expected = defective,
       .flags = {"orientation", "boundary"},
       .needed = {"inverted"},
       // The vertex may come to lie beside another part of the boundary.
       .also = {"flat", "near-contact"},
       .comment = "a boundary vertex is pushed through the opposite face of one of its tetrahedra",
       .mutate = [](Site& s) { return push_through(s, false, 0.05, 0.6); }},
      {.id = "pushed-through-by-one-unit",
       .expected = defective,
       .flags = {"orientation", "rounding"},
       .needed = {"inverted"},
       .also = {"flat"},
       .comment =
           "an inner vertex is one unit in the last place beyond the opposite face of one of its tetrahedra",
       .mutate = [](Site& s) { return push_one_unit(s, true); }},
      {.id = "pushed-through-by-one-unit-from-boundary",
       .expected = defective,
       .flags = {"orientation", "rounding", "boundary"},
       .needed = {"inverted"},
       .also = {"flat"},
       .comment = "a boundary vertex is one unit in the last place beyond the opposite face of one of its "
                  "tetrahedra",
       .mutate = [](Site& s) { return push_one_unit(s, false); }},
      {.id = "flat",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"flat"},
       .also = {"inverted"},
       .comment = "an inner vertex lies exactly in the plane of the opposite face of one of its tetrahedra",
       .mutate =
           [](Site& s) {
             return push_into(s, {0.5, 0.25, 0.25});
           }},
      {.id = "flat-on-edge",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"flat"},
       .also = {"inverted"},
       .comment = "an inner vertex lies on an opposite edge: three vertices of a tetrahedron are collinear",
       .mutate =
           [](Site& s) {
             return push_into(s, {0.5, 0.5, 0});
           }},
      {.id = "flat-on-vertex",
       .expected = defective,
       .flags = {"orientation", "points"},
       .needed = {"flat"},
       .also = {"inverted", "duplicate-point"},
       .comment = "an inner vertex has the coordinates of another vertex of its tetrahedron",
       .mutate =
           [](Site& s) {
             return push_into(s, {1, 0, 0});
           }},
      {.id = "fold-over-rewound",
       .expected = defective,
       .flags = {"orientation", "overlap"},
       .needed = {"face-orientation", "overlap", "boundary-self-intersection"},
       .also = {"face-orientation", "overlap", "boundary-self-intersection"},
       .comment = "an inner vertex is pushed through a face, and the inverted tetrahedra are re-wound to be "
                  "positive",
       .mutate = rewound},
  };
}

}  // namespace tetproof::corpus
