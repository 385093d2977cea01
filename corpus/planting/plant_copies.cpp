// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds that add a second copy of the whole mesh.
#include <algorithm>
#include <map>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

bool copy(Site& s, const Point& shift) {
  s.add_copy([&](const Point& p) -> Point { return p + shift; });
  return true;
}

// Adds a copy whose lowest vertex in a random direction lies `depth` below the highest vertex of the mesh.
bool tip_to_tip(Site& s, double depth) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Point n = s.normal(s.face(t, corner)).normalized();
  const auto higher = [&](const Point& p, const Point& q) { return n.dot(p) < n.dot(q); };
  const auto [lowest, highest] =
      std::minmax_element(s.parts.mesh.points.begin(), s.parts.mesh.points.end(), higher);
  const Point aside = 0.25 * depth * s.direction();
  return copy(s, *highest - *lowest - depth * n + aside);
}

// Adds the tetrahedra at a vertex once more, with points of their own in the same places.
bool copy_ball(Site& s) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  std::map<Index, Index> again;
  for (const Index t : s.tets_at(v)) {
    Tet tet = s.tet(t);
    for (Index& w : tet) {
      if (!again.contains(w)) again[w] = s.add(s.at(w));
      w = again[w];
    }
    s.mesh.tets.push_back(tet);
    s.removed.push_back(0);
  }
  return true;
}

bool nested(Site& s, double share, bool wound_negative) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  double least = s.parts.diagonal;
  const Point center = s.centroid(t);
  for (int corner = 0; corner < 4; ++corner) {
    const Face face = s.face(t, corner);
    least = std::min(least, s.normal(face).normalized().dot(s.at(face[0]) - center));
  }
  const double scale = share * least / s.parts.diagonal;
  const Point middle = (s.parts.low + s.parts.high) / 2;
  s.add_copy([&](const Point& p) -> Point { return center + scale * (p - middle); }, wound_negative);
  return true;
}

}  // namespace

std::vector<PlantKind> copy_kinds() {
  constexpr auto defective = Expected::defective, sound = Expected::sound;
  const std::vector<const char*> either{"overlap", "boundary-self-intersection"};
  return {
      {.id = "blocks-interpenetrate",
       .expected = defective,
       .flags = {"overlap", "whole"},
       .needed = either,
       .comment = "a second copy of the mesh, moved by a fraction of its size",
       .mutate =
           [](Site& s) { return copy(s, s.random.between(0.02, 0.4) * s.parts.diagonal * s.direction()); }},
      {.id = "blocks-interpenetrate-1e-12",
       .expected = defective,
       .flags = {"overlap", "whole", "rounding"},
       .needed = {"overlap", "boundary-self-intersection", "non-conforming-interface"},
       .also = {"near-contact"},
       .comment = "a second copy of the mesh beside it, which reaches into it by 1e-12 of the diagonal",
       .mutate = [](Site& s) { return tip_to_tip(s, std::max(1e-12 * s.parts.diagonal, 4 * s.unit())); }},
      {.id = "blocks-shifted-slightly",
       .expected = defective,
       .flags = {"overlap", "whole", "rounding"},
       .needed = either,
       .also = {"near-contact"},
       .comment = "a second copy of the mesh, moved by 1e-13 to 1e-6 of its size",
       .mutate =
           [](Site& s) {
             return copy(s, std::max(s.magnitude(-43, -20) * s.parts.diagonal, 4 * s.unit()) * s.direction());
           }},
      {.id = "copy-in-place",
       .expected = defective,
       .flags = {"overlap", "whole", "points"},
       .needed = {"duplicate-tet"},
       .comment = "a second copy of the mesh in the same place, with its own points",
       .mutate =
           [](Site& s) {
             return copy(s, {0, 0, 0});
           }},
      {.id = "copied-ball",
       .expected = defective,
       .flags = {"duplicates", "points"},
       .needed = {"duplicate-tet"},
       .comment = "the tetrahedra at a vertex are there twice, the second time with their own points",
       .mutate = copy_ball},
      {.id = "copy-beside",
       .expected = sound,
       .flags = {"control", "whole"},
       .comment = "a second copy of the mesh at a clear distance: nothing is wrong",
       .mutate = [](Site& s) { return copy(s, 1.5 * s.parts.diagonal * s.direction()); }},
      {.id = "nested-component",
       .expected = defective,
       .flags = {"overlap", "whole"},
       .needed = {"overlap"},
       .comment = "a small copy of the mesh inside one of its tetrahedra, where there should be a cavity",
       .mutate = [](Site& s) { return nested(s, 0.9, false); }},
      {.id = "nested-component-negative",
       .expected = defective,
       .flags = {"overlap", "orientation", "whole"},
       .needed = {"inverted"},
       .also = {"flat"},
       .comment =
           "a small copy of the mesh inside one of its tetrahedra, all inverted as if that made a cavity",
       .mutate = [](Site& s) { return nested(s, 0.9, true); }},
  };
}

}  // namespace tetproof::corpus
