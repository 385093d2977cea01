// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds that leave tetrahedra out. The rest is a valid triangulation: only a comparison with the surface,
// or the author, can tell that it is not the intended one.
#include <algorithm>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

bool missing(Site& s, bool inner) {
  const Index t = s.some_tet([&](Index i) { return s.inner(i) == inner; });
  if (t >= 0) s.remove(t);
  return t >= 0;
}

bool missing_two(Site& s) {
  Index t = -1;
  int corner = 0;
  if (!s.some_inner_face(t, corner)) return false;
  s.remove(t);
  s.remove(s.neighbour(t, corner));
  return true;
}

bool missing_ball(Site& s) {
  const auto inside = [&](Index w) { return s.parts.on_boundary[static_cast<std::size_t>(w)] == 0; };
  const Index v = s.some_vertex([&](Index w) {
    return std::all_of(s.tets_at(w).begin(), s.tets_at(w).end(),
                       [&](Index t) { return std::all_of(s.tet(t).begin(), s.tet(t).end(), inside); });
  });
  if (v < 0) return false;
  for (const Index t : s.tets_at(v)) s.remove(t);
  return true;
}

bool tunnel(Site& s) {
  const Point n = s.direction(), start = s.centroid(s.random.below(s.tets()));
  const double radius = s.random.between(0.02, 0.15) * s.parts.diagonal;
  for (Index t = 0; t < s.tets(); ++t)
    if (n.cross(s.centroid(t) - start).norm() < radius) s.remove(t);
  return true;
}

bool at_random(Site& s) {
  for (Index t = 0; t < s.tets(); ++t)
    if (s.random.below(10) == 0) s.remove(t);
  return true;
}

}  // namespace

std::vector<PlantKind> missing_kinds() {
  constexpr auto debatable = Expected::debatable;
  const std::vector<const char*> holes{"cavity", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"};
  return {
      {.id = "missing-inside",
       .expected = debatable,
       .flags = {"missing"},
       .needed = holes,
       .also = holes,
       .comment = "a tetrahedron with four neighbours is left out",
       .mutate = [](Site& s) { return missing(s, true); }},
      {.id = "missing-at-boundary",
       .expected = debatable,
       .flags = {"missing", "boundary"},
       .also = holes,
       .comment = "a tetrahedron with a boundary face is left out",
       .mutate = [](Site& s) { return missing(s, false); }},
      {.id = "missing-two",
       .expected = debatable,
       .flags = {"missing"},
       .also = holes,
       .comment = "two neighbouring tetrahedra are left out",
       .mutate = missing_two},
      {.id = "missing-ball",
       .expected = debatable,
       .flags = {"missing"},
       .needed = holes,
       .also = {"unused-point"},
       .comment = "all tetrahedra at a vertex well inside are left out",
       .mutate = missing_ball},
      {.id = "tunnel",
       .expected = debatable,
       .flags = {"missing", "whole"},
       .also = {"cavity", "unused-point"},
       .comment = "the tetrahedra along a line through the mesh are left out",
       .mutate = tunnel},
      {.id = "missing-many",
       .expected = debatable,
       .flags = {"missing", "whole"},
       .also = {"cavity", "unused-point"},
       .comment = "every tenth tetrahedron is left out",
       .mutate = at_random},
  };
}

}  // namespace tetproof::corpus
