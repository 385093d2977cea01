// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: duplicates, and tetrahedra that are wound the other way.
#include <algorithm>
#include <utility>

#include "corpus/planting/plant_site.hpp"

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

}  // namespace

std::vector<PlantKind> orientation_kinds() {
  constexpr auto defective = Expected::defective;
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
      {"flat-cover",
       defective,
       {"orientation", "boundary"},
       {"flat"},
       {},
       "a flat tetrahedron on two boundary faces that lie in one plane",
       flat_cover},
  };
}

}  // namespace tetproof::corpus
