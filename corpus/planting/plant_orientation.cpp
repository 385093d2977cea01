// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of duplicate tetrahedra and of inverted tetrahedra.
#include <algorithm>
#include <utility>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// Adds copies of a random tetrahedron, with their corners in these orders.
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

// Turns all tetrahedra of the copy except for one.
bool invert_all_but_one(Site& s) {
  const Index t = s.some_tet();
  for (Index u = 0; u < s.tets(); ++u)
    if (u != t) std::swap(s.mesh.tets[at(u)][0], s.mesh.tets[at(u)][1]);
  return t >= 0;
}

// Behind the other vertex order, diagonals cross.
bool crossed_and_inverted(Site& s) {
  if (!plant_kind("crossed-diagonals").mutate(s)) return false;
  for (Tet& tet : s.mesh.tets) std::swap(tet[0], tet[1]);
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

// Adds a flat tetrahedron on two boundary faces that share an edge and lie in one plane.
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
      {.id = "duplicate-tet",
       .expected = defective,
       .flags = {"duplicates"},
       .needed = {"duplicate-tet"},
       .comment = "a tetrahedron is listed twice",
       .mutate =
           [](Site& s) {
             return duplicate(s, {{0, 1, 2, 3}});
           }},
      {.id = "duplicate-tet-turned",
       .expected = defective,
       .flags = {"duplicates"},
       .needed = {"duplicate-tet"},
       .comment = "a tetrahedron is listed twice, the second time in another order of the same orientation",
       .mutate =
           [](Site& s) {
             return duplicate(s, {{1, 2, 0, 3}});
           }},
      {.id = "duplicate-tet-mirrored",
       .expected = defective,
       .flags = {"duplicates", "orientation"},
       .needed = {"duplicate-tet"},
       .comment = "a tetrahedron is listed twice, once positive and once negative",
       .mutate =
           [](Site& s) {
             return duplicate(s, {{1, 0, 2, 3}});
           }},
      {.id = "tet-three-times",
       .expected = defective,
       .flags = {"duplicates"},
       .needed = {"duplicate-tet"},
       .comment = "a tetrahedron is listed three times",
       .mutate =
           [](Site& s) {
             return duplicate(s, {{0, 1, 2, 3}, {3, 2, 1, 0}});
           }},
      {.id = "inverted-inside",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"inverted"},
       .comment = "a tetrahedron with four neighbours is inverted",
       .mutate = [](Site& s) { return invert(s, true); }},
      {.id = "inverted-at-boundary",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"inverted"},
       .comment = "a tetrahedron with a boundary face is inverted",
       .mutate = [](Site& s) { return invert(s, false); }},
      {.id = "inverted-around-vertex",
       .expected = defective,
       .flags = {"orientation"},
       .needed = {"inverted"},
       .comment = "all tetrahedra at a vertex are inverted",
       .mutate = invert_ball},
      {.id = "inverted-half",
       .expected = defective,
       .flags = {"orientation", "whole"},
       .needed = {"inverted"},
       .comment = "half of the tetrahedra are inverted",
       .mutate = [](Site& s) { return invert_side(s, 0.5); }},
      {.id = "inverted-all",
       .expected = defective,
       .flags = {"orientation", "whole"},
       .needed = {"inverted"},
       .comment = "every tetrahedron is inverted",
       .mutate = [](Site& s) { return invert_side(s, 1); }},
      {.id = "inverted-all-but-one",
       .expected = defective,
       .flags = {"orientation", "whole"},
       .needed = {"inverted"},
       .comment = "every tetrahedron but one is inverted",
       .mutate = invert_all_but_one},
      {.id = "inverted-all-and-crossed",
       .expected = defective,
       .flags = {"orientation", "whole"},
       .needed = {"inverted"},
       .also = {"hanging-node", "crossed-diagonal", "boundary-self-intersection", "near-contact"},
       .comment =
           "every tetrahedron is inverted, and a quadrilateral is cut along different diagonals on its "
           "two sides",
       .mutate = crossed_and_inverted},
      {.id = "mirrored",
       .expected = defective,
       .flags = {"orientation", "whole"},
       .needed = {"inverted"},
       .comment = "the mesh is mirrored: one coordinate has the opposite sign at every point",
       .mutate = mirrored},
      {.id = "flat-cover",
       .expected = defective,
       .flags = {"orientation", "boundary"},
       .needed = {"flat"},
       .comment = "a flat tetrahedron on two boundary faces that lie in one plane",
       .mutate = flat_cover},
  };
}

}  // namespace tetproof::corpus
