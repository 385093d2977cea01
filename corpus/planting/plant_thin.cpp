// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of sound meshes: very thin tetrahedra, and changes that do no harm.
#include <algorithm>
#include <array>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// Splits a tetrahedron into four at a point.
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
  return s.step_through(face, p, -1) && insert(s, t, p);
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

std::vector<PlantKind> thin_kinds() {
  constexpr auto sound = Expected::sound;
  return {
      {.id = "sliver",
       .expected = sound,
       .flags = {"thin"},
       .comment = "a tetrahedron is split into four at a point very close to one of its faces",
       .mutate =
           [](Site& s) {
             return insert_at(s, {1e-7, 0.3, 0.3, 0.4 - 1e-7});
           }},
      {.id = "needle",
       .expected = sound,
       .flags = {"thin"},
       .comment = "a tetrahedron is split into four at a point very close to one of its corners",
       .mutate =
           [](Site& s) {
             return insert_at(s, {1 - 3e-6, 1e-6, 1e-6, 1e-6});
           }},
      {.id = "one-unit-above-a-face",
       .expected = sound,
       .flags = {"thin", "rounding"},
       .comment =
           "a tetrahedron is split into four at a point one unit in the last place above one of its faces",
       .mutate = insert_one_unit_off},
      {.id = "inserted-point",
       .expected = sound,
       .flags = {"control"},
       .comment = "a tetrahedron is split into four: nothing is wrong",
       .mutate =
           [](Site& s) {
             return insert_at(s, {0.25, 0.25, 0.25, 0.25});
           }},
      {.id = "flipped-face",
       .expected = sound,
       .flags = {"control"},
       .comment =
           "two tetrahedra are replaced by three around the line between their apexes: nothing is wrong",
       .mutate = flip_23},
  };
}

}  // namespace tetproof::corpus
