// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: duplicates, orientation, flat tetrahedra, and what is only thin.
#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/plant_site.hpp"

namespace tetproof::corpus {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// Copies of a tetrahedron, their corners in these orders.
bool duplicate(Site& s, const std::vector<std::array<int, 4>>& orders) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  for (const auto& order : orders) {
    s.mesh.tets.push_back({s.tet(t)[order[0]], s.tet(t)[order[1]], s.tet(t)[order[2]], s.tet(t)[order[3]]});
    s.removed.push_back(0);
  }
  return true;
}

bool invert(Site& s, bool inner) {
  const Index t = s.some_tet([&](Index i) { return s.inner(i) == inner; });
  if (t < 0) return false;
  const int i = s.random.below(4);
  std::swap(s.mesh.tets[at(t)][i], s.mesh.tets[at(t)][(i + 1 + s.random.below(3)) % 4]);
  return true;
}

bool invert_side(Site& s, double share) {
  const Point n = s.direction();
  std::vector<double> heights;
  for (Index t = 0; t < s.tets(); ++t) heights.push_back(n.dot(s.centroid(t)));
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  const double least = sorted[static_cast<std::size_t>((1 - share) * static_cast<double>(sorted.size()))];
  for (Index t = 0; t < s.tets(); ++t)
    if (share == 1 || heights[at(t)] > least) std::swap(s.mesh.tets[at(t)][0], s.mesh.tets[at(t)][1]);
  return true;
}

bool invert_ball(Site& s) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  for (const Index t : s.tets_at(v)) std::swap(s.mesh.tets[at(t)][1], s.mesh.tets[at(t)][2]);
  return true;
}

bool mirrored(Site& s) {
  const int axis = s.random.below(3);
  for (Point& p : s.mesh.points) p[axis] = -p[axis];
  return true;
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

// Moves p by single steps of doubles along the steepest axis of the face until it is on its other side, or in
// its plane.
bool step_through(Site& s, const Face& face, Point& p, int wanted) {
  const auto side = [&] {
    return orientation(s.at(face[0]), s.at(face[1]), s.at(face[2]), p);  // negative: inside
  };
  int axis = 0;
  const Point n = s.normal(face);
  n.cwiseAbs().maxCoeff(&axis);
  const auto step = [&](int way) {
    p[axis] = std::nextafter(p[axis], way * n[axis] > 0 ? INFINITY : -INFINITY);
  };
  for (int i = 0; i < 64 && side() >= 0; ++i) step(-1);
  if (side() >= 0) return false;
  if (wanted < 0) {
    for (int i = 0; i < 64; ++i) {
      const Point last = p;
      step(1);
      if (side() >= 0) return p = last, true;
    }
    return false;
  }
  for (int i = 0; i < 128 && side() < wanted; ++i) step(1);
  return side() == wanted;
}

bool push_one_unit(Site& s, bool inner) {
  const Push push = some_push(s, inner);
  if (push.vertex < 0) return false;
  Point p = s.centroid(push.face);
  if (!step_through(s, push.face, p, 1)) return false;
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

// A flat tetrahedron on two boundary faces in one plane.
bool flat_cover(Site& s) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  for (const auto& [u, k] : s.parts.boundary) {
    const Face other = s.face(u, k);
    if ((u == t && k == corner) || !s.free(u)) continue;
    Index fourth = -1;
    int common = 0;
    for (const Index v : other)
      if (std::count(face.begin(), face.end(), v))
        ++common;
      else
        fourth = v;
    if (common != 2 || orientation(s.at(face[0]), s.at(face[1]), s.at(face[2]), s.at(fourth)) != 0) continue;
    s.mesh.tets.push_back({face[0], face[1], face[2], fourth});
    s.removed.push_back(0);
    return true;
  }
  return false;
}

// A tetrahedron cut into four at a point.
bool insert(Site& s, Index t, const Point& p) {
  const Index node = s.add(p);
  for (int corner = 0; corner < 4; ++corner) {
    Tet part = s.tet(t);
    part[at(corner)] = node;
    if (s.sign(part) <= 0) return false;
    if (corner == 0) {
      s.mesh.tets[at(t)] = part;
    } else {
      s.mesh.tets.push_back(part);
      s.removed.push_back(0);
    }
  }
  return true;
}

bool insert_at(Site& s, std::array<double, 4> weights) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  Point p = s.at(s.tet(t)[0]);
  for (int i = 1; i < 4; ++i) p += weights[at(i)] * (s.at(s.tet(t)[i]) - s.at(s.tet(t)[0]));
  return insert(s, t, p);
}

bool insert_one_unit_off(Site& s) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  const Face face = s.face(t, s.random.below(4));
  Point p = s.centroid(face);
  return step_through(s, face, p, -1) && insert(s, t, p);
}

bool flip_23(Site& s) {
  Index t = -1;
  int corner = 0;
  if (!s.some_inner_face(t, corner)) return false;
  const Index u = s.neighbour(t, corner);
  const Face face = s.face(t, corner);
  const Index apex = s.tet(t)[at(corner)];
  Index other = -1;
  for (const Index v : s.tet(u))
    if (!std::count(face.begin(), face.end(), v)) other = v;
  s.removed[at(t)] = s.removed[at(u)] = 1;
  for (int k = 0; k < 3; ++k) {
    const Tet part{face[at(k)], face[at((k + 1) % 3)], apex, other};
    if (s.sign(part) <= 0) return false;
    s.mesh.tets.push_back(part);
    s.removed.push_back(0);
  }
  return true;
}

}  // namespace

std::vector<PlantKind> orientation_kinds() {
  constexpr auto defective = Expected::defective, sound = Expected::sound;
  return {
      {"duplicate-tet",
       defective,
       {"duplicates"},
       {"duplicate-tet"},
       {},
       "a tetrahedron twice",
       [](Site& s) {
         return duplicate(s, {{0, 1, 2, 3}});
       }},
      {"duplicate-tet-turned",
       defective,
       {"duplicates"},
       {"duplicate-tet"},
       {},
       "a tetrahedron twice, its corners in another order of the same orientation",
       [](Site& s) {
         return duplicate(s, {{1, 2, 0, 3}});
       }},
      {"duplicate-tet-mirrored",
       defective,
       {"duplicates", "orientation"},
       {"duplicate-tet"},
       {},
       "a tetrahedron twice, once positive and once negative",
       [](Site& s) {
         return duplicate(s, {{1, 0, 2, 3}});
       }},
      {"tet-three-times",
       defective,
       {"duplicates"},
       {"duplicate-tet"},
       {},
       "a tetrahedron three times",
       [](Site& s) {
         return duplicate(s, {{0, 1, 2, 3}, {3, 2, 1, 0}});
       }},
      {"inverted-inside",
       defective,
       {"orientation"},
       {"inverted"},
       {},
       "a tetrahedron with four neighbours wound the other way",
       [](Site& s) { return invert(s, true); }},
      {"inverted-at-boundary",
       defective,
       {"orientation"},
       {"inverted"},
       {},
       "a tetrahedron with a boundary face wound the other way",
       [](Site& s) { return invert(s, false); }},
      {"inverted-around-vertex",
       defective,
       {"orientation"},
       {"inverted"},
       {},
       "all tetrahedra at a vertex wound the other way",
       invert_ball},
      {"inverted-half",
       defective,
       {"orientation", "whole"},
       {"inverted"},
       {},
       "half of the mesh wound the other way",
       [](Site& s) { return invert_side(s, 0.5); }},
      {"inverted-all",
       defective,
       {"orientation", "whole"},
       {"inverted"},
       {},
       "every tetrahedron wound the other way",
       [](Site& s) { return invert_side(s, 1); }},
      {"mirrored",
       defective,
       {"orientation", "whole"},
       {"inverted"},
       {},
       "the sign of one coordinate turned around",
       mirrored},
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
      {"flat-cover",
       defective,
       {"orientation", "boundary"},
       {"flat"},
       {},
       "a flat tetrahedron on two boundary faces that lie in one plane",
       flat_cover},
      {"fold-over-rewound",
       defective,
       {"orientation", "overlap"},
       {"face-orientation", "overlap", "boundary-self-intersection"},
       {"face-orientation", "overlap", "boundary-self-intersection"},
       "an inner vertex pushed through a face, and what turned over re-wound positive",
       rewound},
      {"sliver",
       sound,
       {"thin"},
       {},
       {},
       "a tetrahedron cut into four at a point close above one of its faces",
       [](Site& s) {
         return insert_at(s, {1e-7, 0.3, 0.3, 0.4 - 1e-7});
       }},
      {"needle",
       sound,
       {"thin"},
       {},
       {},
       "a tetrahedron cut into four at a point close to one of its corners",
       [](Site& s) {
         return insert_at(s, {1 - 3e-6, 1e-6, 1e-6, 1e-6});
       }},
      {"one-unit-above-a-face",
       sound,
       {"thin", "rounding"},
       {},
       {},
       "a tetrahedron cut into four at a point that is one unit in the last place above one of its faces",
       insert_one_unit_off},
      {"inserted-point",
       sound,
       {"control"},
       {},
       {},
       "a tetrahedron cut into four: nothing is wrong",
       [](Site& s) {
         return insert_at(s, {0.25, 0.25, 0.25, 0.25});
       }},
      {"flipped-face",
       sound,
       {"control"},
       {},
       {},
       "two tetrahedra replaced by three around the line between their apexes: nothing is wrong",
       flip_23},
  };
}

}  // namespace tetproof::corpus
