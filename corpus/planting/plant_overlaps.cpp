// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: tetrahedra that lie in each other.
#include <algorithm>
#include <array>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// A tetrahedron inside another one: its first corners are the other one's, the rest lies well inside.
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

// A tetrahedron of the mesh's own size across others.
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

// The tip of a tetrahedron outside, `depth` below a boundary face. Its own size is that of the face.
bool tip(Site& s, double depth) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Point out = s.normal(face).normalized(), foot = s.centroid(face);
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

bool tower(Site& s) {
  // Two tetrahedra on a boundary face, the second of which turns back into the mesh.
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
      {"inside-another",
       defective,
       {"overlap"},
       {"overlap"},
       {},
       "a small tetrahedron inside a large one, sharing nothing with it",
       [](Site& s) { return inside(s, 0, false); }},
      {"inside-another-at-vertex",
       defective,
       {"overlap"},
       {"overlap"},
       pinches,
       "a small tetrahedron inside a large one, sharing a vertex with it",
       [](Site& s) { return inside(s, 1, false); }},
      {"inside-another-at-edge",
       defective,
       {"overlap"},
       {"overlap"},
       pinches,
       "a small tetrahedron inside a large one, sharing an edge with it",
       [](Site& s) { return inside(s, 2, false); }},
      {"face-shared-thrice",
       defective,
       {"overlap", "faces"},
       {"face-shared-thrice"},
       {},
       "a third tetrahedron on a face of two, inside one of them",
       [](Site& s) { return inside(s, 3, false); }},
      {"two-on-one-side",
       defective,
       {"overlap", "faces"},
       {"face-orientation"},
       {},
       "a second tetrahedron on a boundary face, inside the first, both positive",
       [](Site& s) { return inside(s, 3, true); }},
      {"foreign-tet",
       defective,
       {"overlap"},
       either,
       {},
       "a tetrahedron across others, sharing nothing with them",
       [](Site& s) { return across(s, 0); }},
      {"foreign-tet-at-vertex",
       defective,
       {"overlap"},
       either,
       pinches,
       "a tetrahedron across others, sharing a vertex with them",
       [](Site& s) { return across(s, 1); }},
      {"foreign-tet-at-edge",
       defective,
       {"overlap"},
       either,
       pinches,
       "a tetrahedron across others, sharing an edge with them",
       [](Site& s) { return across(s, 2); }},
      {"foreign-tet-on-face",
       defective,
       {"overlap", "faces"},
       {"face-shared-thrice", "face-orientation", "overlap", "boundary-self-intersection"},
       {"duplicate-tet"},
       "a tetrahedron across others on one of their faces",
       [](Site& s) { return across(s, 3); }},
      {"overlap-1e-12",
       defective,
       {"overlap", "rounding"},
       {"boundary-self-intersection"},
       {"overlap"},
       "a tetrahedron outside, its tip in a boundary face by at most 1e-12 of the diagonal",
       [](Site& s) {
         return tip(s, std::max(s.random.between(0.1, 1) * 1e-12 * s.parts.diagonal, s.unit()));
       }},
      {"near-contact",
       debatable,
       {"boundary", "rounding"},
       {"near-contact"},
       {},
       "a tetrahedron outside, its tip less than 1e-12 of the diagonal above a boundary face",
       [](Site& s) {
         return tip(s, -std::max(s.random.between(0.1, 0.8) * 1e-12 * s.parts.diagonal, s.unit()));
       }},
      {"tower-into-mesh",
       defective,
       {"overlap"},
       either,
       pinches,
       "two tetrahedra on a boundary face, matching, of which the second reaches back into the mesh",
       tower},
      {"filled-twice",
       defective,
       {"overlap"},
       either,
       {"duplicate-point"},
       "a tetrahedron twice, the second time with points of its own",
       [](Site& s) { return filled_twice(s, 1); }},
      {"filled-twice-finer",
       defective,
       {"overlap"},
       either,
       {"duplicate-point"},
       "a tetrahedron, and in the same place four others with points of their own",
       [](Site& s) { return filled_twice(s, 4); }},
      {"in-a-cavity",
       debatable,
       {"missing"},
       {"cavity", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       {"boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"},
       "a small tetrahedron in the cavity that a missing one left: valid",
       in_a_cavity},
  };
}

}  // namespace tetproof::corpus
