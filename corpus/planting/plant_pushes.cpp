// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: vertices pushed through faces, or into their planes.
#include <algorithm>
#include <utility>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// A vertex and the face opposite to it in one of its tetrahedra.
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
      {"pushed-through",
       defective,
       {"orientation"},
       {"inverted"},
       {"flat"},
       "an inner vertex far beyond the opposite face of one of its tetrahedra",
       [](Site& s) { return push_through(s, true, 0.1, 2); }},
      {"pushed-through-from-boundary",
       defective,
       {"orientation", "boundary"},
       {"inverted"},
       {"flat"},
       "a boundary vertex pushed through a face opposite to it",
       [](Site& s) { return push_through(s, false, 0.05, 0.6); }},
      {"pushed-through-by-one-unit",
       defective,
       {"orientation", "rounding"},
       {"inverted"},
       {"flat"},
       "an inner vertex beyond a face opposite to it by one unit in the last place",
       [](Site& s) { return push_one_unit(s, true); }},
      {"pushed-through-by-one-unit-from-boundary",
       defective,
       {"orientation", "rounding", "boundary"},
       {"inverted"},
       {"flat"},
       "a boundary vertex beyond a face opposite to it by one unit in the last place",
       [](Site& s) { return push_one_unit(s, false); }},
      {"flat",
       defective,
       {"orientation"},
       {"flat"},
       {"inverted"},
       "an inner vertex exactly in the plane of a face opposite to it",
       [](Site& s) {
         return push_into(s, {0.5, 0.25, 0.25});
       }},
      {"flat-on-edge",
       defective,
       {"orientation"},
       {"flat"},
       {"inverted"},
       "an inner vertex on an edge opposite to it: three vertices in a line",
       [](Site& s) {
         return push_into(s, {0.5, 0.5, 0});
       }},
      {"flat-on-vertex",
       defective,
       {"orientation", "points"},
       {"flat"},
       {"inverted", "duplicate-point"},
       "an inner vertex in the place of another vertex of its tetrahedron",
       [](Site& s) {
         return push_into(s, {1, 0, 0});
       }},
      {"fold-over-rewound",
       defective,
       {"orientation", "overlap"},
       {"face-orientation", "overlap", "boundary-self-intersection"},
       {"face-orientation", "overlap", "boundary-self-intersection"},
       "an inner vertex pushed through a face, and what turned over re-wound positive",
       rewound},
  };
}

}  // namespace tetproof::corpus
