// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: further copies of the whole mesh.
#include <algorithm>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

bool copy(Site& s, const Point& shift) {
  s.add_copy([&](const Point& p) -> Point { return p + shift; });
  return true;
}

// A copy whose lowest vertex in some direction is just below the highest of the mesh.
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
      {"blocks-interpenetrate",
       defective,
       {"overlap", "whole"},
       either,
       {},
       "a second copy of the mesh, moved by a part of its size",
       [](Site& s) { return copy(s, s.random.between(0.02, 0.4) * s.parts.diagonal * s.direction()); }},
      {"blocks-interpenetrate-1e-12",
       defective,
       {"overlap", "whole", "rounding"},
       either,
       {"near-contact"},
       "a second copy of the mesh beside it, in it by 1e-12 of the diagonal",
       [](Site& s) { return tip_to_tip(s, std::max(1e-12 * s.parts.diagonal, 4 * s.unit())); }},
      {"blocks-shifted-slightly",
       defective,
       {"overlap", "whole", "rounding"},
       either,
       {"near-contact"},
       "a second copy of the mesh, moved by 1e-13 to 1e-6 of its size",
       [](Site& s) {
         return copy(s, std::max(s.magnitude(-43, -20) * s.parts.diagonal, 4 * s.unit()) * s.direction());
       }},
      {"copy-in-place",
       defective,
       {"overlap", "whole", "points"},
       either,
       {"duplicate-point", "crack"},
       "a second copy of the mesh in the same place, with points of its own",
       [](Site& s) {
         return copy(s, {0, 0, 0});
       }},
      {"copy-beside",
       sound,
       {"control", "whole"},
       {},
       {},
       "a second copy of the mesh well beside it: nothing is wrong",
       [](Site& s) { return copy(s, 1.5 * s.parts.diagonal * s.direction()); }},
      {"nested-component",
       defective,
       {"overlap", "whole"},
       {"overlap"},
       {},
       "a small copy of the mesh inside one of its tetrahedra, where there should be a cavity",
       [](Site& s) { return nested(s, 0.9, false); }},
      {"nested-component-negative",
       defective,
       {"overlap", "orientation", "whole"},
       {"inverted"},
       {"flat"},
       "a small copy of the mesh inside one of its tetrahedra, wound negative as if that made a cavity",
       [](Site& s) { return nested(s, 0.9, true); }},
  };
}

}  // namespace tetproof::corpus
