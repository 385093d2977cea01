// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of overlapping tetrahedra.
#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// Adds a tetrahedron inside another one. They share `common` corners; the other corners lie well inside.
bool inside(Site& s, int common, bool at_boundary) {
  Index t = -1;
  int turn = s.random.below(4);
  if (common < 3)
    t = s.some_tet();
  else if (at_boundary ? !s.some_boundary_face(t, turn) : !s.some_inner_face(t, turn))
    return false;
  if (t < 0) return false;
  Tet small;
  for (int i = 0; i < 4; ++i)
    small[i] = i < common ? s.tet(t)[static_cast<std::size_t>((turn + 1 + i) % 4)] : s.add(s.within(t));
  if (s.sign(small) == 0) return false;
  s.add_positive(small);
  return true;
}

// Adds a tetrahedron of about the size of the others, which cuts through them.
bool across(Site& s, int common) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  const double size = s.size(t);
  Tet foreign;
  for (int i = 0; i < 4; ++i)
    foreign[i] =
        i < common ? s.tet(t)[i] : s.add(s.centroid(t) + s.random.between(0.5, 1.5) * size * s.direction());
  if (s.sign(foreign) == 0) return false;
  s.add_positive(foreign);
  return true;
}

// Adds a tetrahedron outside whose tip lies below a boundary face, or above it if `share` is negative: by
// this share of the face's longest edge, and at least by a unit in the last place of the coordinates. Its
// size is a fraction of the face's.
bool tip(Site& s, double share) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Point out = s.normal(face).normalized(), foot = s.centroid(face);
  const double longest =
      std::max({(s.at(face[1]) - s.at(face[0])).norm(), (s.at(face[2]) - s.at(face[1])).norm(),
                (s.at(face[0]) - s.at(face[2])).norm()});
  const double depth = std::copysign(std::max(std::abs(share) * longest, s.unit()), share);
  const double size = 0.2 * s.size(t);
  const Point u = (s.at(face[1]) - s.at(face[0])).normalized(), v = out.cross(u);
  constexpr std::array<std::array<double, 2>, 3> around{{{1, 0}, {-0.5, 0.85}, {-0.5, -0.9}}};
  const Index first = s.add(foot - depth * out);
  for (int k = 0; k < 3; ++k)
    s.add(foot + size * out +
          0.2 * size *
              (around[static_cast<std::size_t>(k)][0] * u + around[static_cast<std::size_t>(k)][1] * v));
  if (s.sign({first, first + 1, first + 2, first + 3}) == 0) return false;
  s.add_positive({first, first + 1, first + 2, first + 3});
  return true;
}

// Adds two tetrahedra on a boundary face, the second of which reaches back into the mesh.
bool tower(Site& s) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Point out = s.normal(face).normalized();
  const double size = s.size(t);
  const Index apex = s.add(s.centroid(face) + 0.6 * size * out);
  const Tet first{face[0], face[1], face[2], apex};
  if (s.sign(first) <= 0) return false;
  s.add_positive(first);
  const Point middle = (s.at(face[0]) + s.at(face[1])) / 2;
  const Index behind = s.add(middle + size * (0.4 * (middle - s.centroid(face)).normalized() - 0.1 * out));
  const Tet second{face[0], face[1], apex, behind};
  if (s.sign(second) <= 0) return false;
  s.add_positive(second);
  return true;
}

bool filled_twice(Site& s, int parts) {
  const Index t = s.some_tet([&](Index i) { return s.inner(i); });
  if (t < 0) return false;
  Tet own;
  for (int i = 0; i < 4; ++i) own[i] = s.add(s.at(s.tet(t)[i]));
  if (parts == 1) {
    s.add_positive(own);
    return true;
  }
  const Index node = s.add(s.within(t));
  for (int i = 0; i < 4; ++i) {
    Tet part = own;
    part[i] = node;
    if (s.sign(part) <= 0) return false;
    s.add_positive(part);
  }
  return true;
}

bool in_a_cavity(Site& s) {
  const Index t = s.some_tet([&](Index i) { return s.inner(i); });
  if (t < 0) return false;
  s.remove(t);
  Tet small;
  for (int i = 0; i < 4; ++i) small[i] = s.add(s.centroid(t) + 0.3 * (s.at(s.tet(t)[i]) - s.centroid(t)));
  if (s.sign(small) <= 0) return false;
  s.add_positive(small);
  return true;
}

}  // namespace

std::vector<PlantKind> overlap_kinds() {
  constexpr auto defective = Expected::defective, debatable = Expected::debatable;
  const std::vector<const char*> either{"overlap", "boundary-self-intersection"},
      pinches{"boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"};
  return {
      {.id = "inside-another",
       .expected = defective,
       .flags = {"overlap"},
       .needed = {"overlap"},
       .comment = "a small tetrahedron inside a large one, sharing nothing with it",
       .mutate = [](Site& s) { return inside(s, 0, false); }},
      {.id = "inside-another-at-vertex",
       .expected = defective,
       .flags = {"overlap"},
       .needed = {"overlap"},
       .also = pinches,
       .comment = "a small tetrahedron inside a large one, sharing a vertex with it",
       .mutate = [](Site& s) { return inside(s, 1, false); }},
      {.id = "inside-another-at-edge",
       .expected = defective,
       .flags = {"overlap"},
       .needed = {"overlap"},
       .also = pinches,
       .comment = "a small tetrahedron inside a large one, sharing an edge with it",
       .mutate = [](Site& s) { return inside(s, 2, false); }},
      {.id = "face-shared-thrice",
       .expected = defective,
       .flags = {"overlap", "faces"},
       .needed = {"face-shared-thrice"},
       .comment = "a third tetrahedron shares a face with two others and lies inside one of them",
       .mutate = [](Site& s) { return inside(s, 3, false); }},
      {.id = "two-on-one-side",
       .expected = defective,
       .flags = {"overlap", "faces"},
       .needed = {"face-orientation"},
       .comment = "a second positive tetrahedron on a boundary face lies inside the first",
       .mutate = [](Site& s) { return inside(s, 3, true); }},
      {.id = "foreign-tet",
       .expected = defective,
       .flags = {"overlap"},
       .needed = either,
       .comment = "a tetrahedron cuts through others and shares nothing with them",
       .mutate = [](Site& s) { return across(s, 0); }},
      {.id = "foreign-tet-at-vertex",
       .expected = defective,
       .flags = {"overlap"},
       .needed = either,
       .also = pinches,
       .comment = "a tetrahedron cuts through others and shares a vertex with them",
       .mutate = [](Site& s) { return across(s, 1); }},
      {.id = "foreign-tet-at-edge",
       .expected = defective,
       .flags = {"overlap"},
       .needed = either,
       .also = pinches,
       .comment = "a tetrahedron cuts through others and shares an edge with them",
       .mutate = [](Site& s) { return across(s, 2); }},
      {.id = "foreign-tet-on-face",
       .expected = defective,
       .flags = {"overlap", "faces"},
       .needed = {"face-shared-thrice", "face-orientation", "overlap", "boundary-self-intersection"},
       .also = {"duplicate-tet"},
       .comment = "a tetrahedron cuts through others and shares a face with one of them",
       .mutate = [](Site& s) { return across(s, 3); }},
      {.id = "overlap-1e-12",
       .expected = defective,
       .flags = {"overlap", "rounding"},
       .needed = {"boundary-self-intersection"},
       .also = {"overlap"},
       .comment = "a tetrahedron outside, whose tip pierces a boundary face by at most 1e-12 of its size",
       .mutate = [](Site& s) { return tip(s, s.random.between(0.1, 1) * 1e-12); }},
      {.id = "near-contact",
       .expected = debatable,
       .flags = {"boundary", "rounding"},
       .needed = {"near-contact"},
       .comment = "a tetrahedron outside, whose tip is less than 1e-12 of its size above a boundary face",
       .mutate = [](Site& s) { return tip(s, -s.random.between(0.1, 0.8) * 1e-12); }},
      {.id = "tower-into-mesh",
       .expected = defective,
       .flags = {"overlap"},
       .needed = either,
       .also = pinches,
       .comment =
           "two conforming tetrahedra on a boundary face, the second of which reaches back into the mesh",
       .mutate = tower},
      {.id = "filled-twice",
       .expected = defective,
       .flags = {"overlap"},
       .needed = {"duplicate-tet"},
       .comment = "a tetrahedron is listed twice, the second time with its own copies of the points",
       .mutate = [](Site& s) { return filled_twice(s, 1); }},
      {.id = "filled-twice-finer",
       .expected = defective,
       .flags = {"overlap"},
       .needed = either,
       .also = {"duplicate-point"},
       .comment = "a tetrahedron, and in the same place four smaller ones with their own points",
       .mutate = [](Site& s) { return filled_twice(s, 4); }},
      {.id = "in-a-cavity",
       .expected = debatable,
       .flags = {"missing"},
       .needed = {"cavity", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       .also = {"boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       .comment = "a small tetrahedron in the cavity that a missing one left: valid",
       .mutate = in_a_cavity},
  };
}

}  // namespace tetproof::corpus
