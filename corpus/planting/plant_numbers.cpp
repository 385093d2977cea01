// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds: numbers and coordinates that geometry cannot be asked about, points that nobody needs, and typing
// errors.
#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// Any corner of any free tetrahedron.
Index* some_corner(Site& s) {
  const Index t = s.some_tet();
  return t < 0 ? nullptr
               : &s.mesh.tets[static_cast<std::size_t>(t)][static_cast<std::size_t>(s.random.below(4))];
}

bool index_is(Site& s, Index number) {
  Index* corner = some_corner(s);
  if (corner) *corner = number;
  return corner != nullptr;
}

bool coordinate_is(Site& s, double x, bool boundary) {
  const Index v = s.some_vertex(
      [&](Index w) { return (s.parts.on_boundary[static_cast<std::size_t>(w)] != 0) == boundary; });
  if (v >= 0) s.mesh.points[static_cast<std::size_t>(v)][s.random.below(3)] = x;
  return v >= 0;
}

bool repeated(Site& s) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  const int i = s.random.below(4);
  s.mesh.tets[static_cast<std::size_t>(t)][i] =
      s.tet(t)[static_cast<std::size_t>((i + 1 + s.random.below(3)) % 4)];
  return true;
}

bool one_vertex_only(Site& s) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  s.mesh.tets.push_back({v, v, v, v});
  s.removed.push_back(0);
  return true;
}

bool further_point(Site& s, bool of_vertex, bool finite) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  Point p = of_vertex ? s.at(v) : Point(s.at(v) + 0.37 * s.parts.diagonal * s.direction());
  if (!finite) p[s.random.below(3)] = std::nan("");
  s.add(p);
  if (of_vertex) s.vertices.push_back(v);
  return true;
}

bool other_number(Site& s) {
  const Index t = s.some_tet();
  if (t < 0) return false;
  const auto points = static_cast<int>(s.parts.mesh.points.size());
  Index v = s.random.below(points);
  for (int i = 0; i < points &&
                  (std::count(s.tet(t).begin(), s.tet(t).end(), v) || s.taken[static_cast<std::size_t>(v)]);
       ++i)
    v = (v + 1) % points;
  s.vertices.assign(s.tet(t).begin(), s.tet(t).end());
  s.mesh.tets[static_cast<std::size_t>(t)][static_cast<std::size_t>(s.random.below(4))] = v;
  return true;
}

bool swapped_points(Site& s) {
  const Index t = s.some_tet([&](Index i) { return s.free_star(s.tet(i)[0]) && s.free_star(s.tet(i)[1]); });
  if (t < 0) return false;
  std::swap(s.mesh.points[static_cast<std::size_t>(s.tet(t)[0])],
            s.mesh.points[static_cast<std::size_t>(s.tet(t)[1])]);
  return true;
}

bool lost_digit(Site& s) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  double& x = s.mesh.points[static_cast<std::size_t>(v)][s.random.below(3)];
  x = s.random.below(2) ? x * 10 : -x;
  return true;
}

bool jolted(Site& s) {
  const Index v = s.some_vertex();
  if (v < 0) return false;
  const double size = s.size(s.tets_at(v)[0]) * s.magnitude(-10, 2);
  s.mesh.points[static_cast<std::size_t>(v)] += size * s.direction();
  return true;
}

bool swapped_numbers(Site& s) {
  const Index t = s.some_tet([&](Index i) { return s.inner(i); });
  if (t < 0) return false;
  const Index u = s.neighbour(t, s.random.below(4));
  if (!s.free(u)) return false;
  std::swap(s.mesh.tets[static_cast<std::size_t>(t)][s.random.below(4)],
            s.mesh.tets[static_cast<std::size_t>(u)][s.random.below(4)]);
  return true;
}

}  // namespace

std::vector<PlantKind> number_kinds() {
  constexpr auto defective = Expected::defective, sound = Expected::sound;
  const std::vector<const char*> any{"repeated-vertex",
                                     "duplicate-tet",
                                     "inverted",
                                     "flat",
                                     "face-shared-thrice",
                                     "face-orientation",
                                     "boundary-self-intersection",
                                     "overlap"},
      holes{"cavity", "near-contact"};
  return {
      {"index-too-high",
       defective,
       {"numbers"},
       {"index-range"},
       {},
       "a tetrahedron names the number after the last point's",
       [](Site& s) { return index_is(s, static_cast<Index>(s.mesh.points.size())); }},
      {"index-far-too-high",
       defective,
       {"numbers"},
       {"index-range"},
       {},
       "a tetrahedron names a number beyond all points",
       [](Site& s) {
         return index_is(s, static_cast<Index>(s.mesh.points.size()) + 1000 + s.random.below(100000));
       }},
      {"index-negative",
       defective,
       {"numbers"},
       {"index-range"},
       {},
       "a tetrahedron names a negative number",
       [](Site& s) { return index_is(s, -1 - s.random.below(100)); }},
      {"nan-inside",
       defective,
       {"coordinates"},
       {"finite-coordinates"},
       {},
       "a coordinate of an inner vertex is not a number",
       [](Site& s) { return coordinate_is(s, std::nan(""), false); }},
      {"nan-on-boundary",
       defective,
       {"coordinates"},
       {"finite-coordinates"},
       {},
       "a coordinate of a boundary vertex is not a number",
       [](Site& s) { return coordinate_is(s, std::nan(""), true); }},
      {"infinity",
       defective,
       {"coordinates"},
       {"finite-coordinates"},
       {},
       "a coordinate of a boundary vertex is infinite",
       [](Site& s) { return coordinate_is(s, s.random.below(2) ? INFINITY : -INFINITY, true); }},
      {"repeated-vertex",
       defective,
       {"numbers"},
       {"repeated-vertex"},
       {},
       "a tetrahedron names a vertex twice",
       repeated},
      {"one-vertex-four-times",
       defective,
       {"numbers"},
       {"repeated-vertex"},
       {},
       "a further tetrahedron names one vertex four times",
       one_vertex_only},
      {"unused-point",
       sound,
       {"points"},
       {"unused-point"},
       {},
       "a point that belongs to no tetrahedron",
       [](Site& s) { return further_point(s, false, true); }},
      {"unused-nan",
       sound,
       {"points", "coordinates"},
       {"unused-point"},
       {},
       "a point that is not finite and belongs to no tetrahedron",
       [](Site& s) { return further_point(s, false, false); }},
      {"unused-duplicate-point",
       sound,
       {"points"},
       {"duplicate-point"},
       {"unused-point"},
       "a second point in the place of a vertex, which belongs to no tetrahedron",
       [](Site& s) { return further_point(s, true, true); }},
      {"wrong-number",
       {},
       {"numbers", "random"},
       any,
       holes,
       "one corner of a tetrahedron names any other vertex",
       other_number},
      {"swapped-corners",
       {},
       {"numbers", "random"},
       any,
       holes,
       "two neighbours have exchanged one corner each",
       swapped_numbers},
      {"swapped-points",
       {},
       {"coordinates", "random"},
       any,
       holes,
       "two neighbouring vertices have each other's coordinates",
       swapped_points},
      {"wrong-coordinate",
       {},
       {"coordinates", "random"},
       any,
       holes,
       "a coordinate with its sign or its decimal point wrong",
       lost_digit},
      {"jolted-vertex",
       {},
       {"coordinates", "random"},
       any,
       holes,
       "a vertex moved in any direction, a little or far",
       jolted},
  };
}

}  // namespace tetproof::corpus
