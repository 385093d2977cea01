// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds about vertex numbers and coordinates: those for which no geometric test is possible, unused
// points, and typing errors.
#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// A random corner of a random free tetrahedron.
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

// All vertex numbers are too high by `by`, or too low by -`by`. `unused` further points follow the others.
bool shifted(Site& s, int by, int unused) {
  for (int i = 0; i < unused; ++i) s.add(s.at(0) + s.parts.diagonal * s.direction());
  for (Tet& tet : s.mesh.tets)
    for (Index& v : tet) v += static_cast<Index>(by);
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
      {.id = "index-too-high",
       .expected = defective,
       .flags = {"numbers"},
       .needed = {"index-range"},
       .comment = "a tetrahedron names a vertex number one above the largest",
       .mutate = [](Site& s) { return index_is(s, static_cast<Index>(s.mesh.points.size())); }},
      {.id = "index-far-too-high",
       .expected = defective,
       .flags = {"numbers"},
       .needed = {"index-range"},
       .comment = "a tetrahedron names a vertex number far above the largest",
       .mutate =
           [](Site& s) {
             return index_is(s, static_cast<Index>(s.mesh.points.size()) + 1000 + s.random.below(100000));
           }},
      {.id = "index-negative",
       .expected = defective,
       .flags = {"numbers"},
       .needed = {"index-range"},
       .comment = "a tetrahedron names a negative vertex number",
       .mutate = [](Site& s) { return index_is(s, -1 - s.random.below(100)); }},
      {.id = "numbers-shifted",
       .expected = defective,
       .flags = {"numbers", "whole"},
       .needed = {"index-range"},
       .comment =
           "all vertex numbers are one too high or one too low, as if numbers from 0 were read as numbers "
           "from 1",
       .mutate = [](Site& s) { return shifted(s, s.random.below(2) ? 1 : -1, 0); }},
      {.id = "numbers-shifted-in-range",
       .expected = defective,
       .flags = {"numbers", "whole"},
       .needed = {"index-range"},
       .comment = "all vertex numbers are up to three too high, and there are as many further points",
       .mutate =
           [](Site& s) {
             const int by = 1 + s.random.below(3);
             return shifted(s, by, by);
           }},
      {.id = "nan-inside",
       .expected = defective,
       .flags = {"coordinates"},
       .needed = {"finite-coordinates"},
       .comment = "a coordinate of an inner vertex is NaN",
       .mutate = [](Site& s) { return coordinate_is(s, std::nan(""), false); }},
      {.id = "nan-on-boundary",
       .expected = defective,
       .flags = {"coordinates"},
       .needed = {"finite-coordinates"},
       .comment = "a coordinate of a boundary vertex is NaN",
       .mutate = [](Site& s) { return coordinate_is(s, std::nan(""), true); }},
      {.id = "infinity",
       .expected = defective,
       .flags = {"coordinates"},
       .needed = {"finite-coordinates"},
       .comment = "a coordinate of a boundary vertex is infinite",
       .mutate = [](Site& s) { return coordinate_is(s, s.random.below(2) ? INFINITY : -INFINITY, true); }},
      {.id = "repeated-vertex",
       .expected = defective,
       .flags = {"numbers"},
       .needed = {"repeated-vertex"},
       .comment = "a tetrahedron names a vertex twice",
       .mutate = repeated},
      {.id = "one-vertex-four-times",
       .expected = defective,
       .flags = {"numbers"},
       .needed = {"repeated-vertex"},
       .comment = "an additional tetrahedron names one vertex four times",
       .mutate = one_vertex_only},
      {.id = "unused-point",
       .expected = sound,
       .flags = {"points"},
       .needed = {"unused-point"},
       .comment = "a point that belongs to no tetrahedron",
       .mutate = [](Site& s) { return further_point(s, false, true); }},
      {.id = "unused-nan",
       .expected = sound,
       .flags = {"points", "coordinates"},
       .needed = {"unused-point"},
       .comment = "a point that is not finite and belongs to no tetrahedron",
       .mutate = [](Site& s) { return further_point(s, false, false); }},
      {.id = "unused-duplicate-point",
       .expected = sound,
       .flags = {"points"},
       .needed = {"duplicate-point"},
       .also = {"unused-point"},
       .comment = "a second point with the coordinates of a vertex, used by no tetrahedron",
       .mutate = [](Site& s) { return further_point(s, true, true); }},
      {.id = "wrong-number",
       .flags = {"numbers", "random"},
       .needed = any,
       .also = holes,
       .comment = "one corner of a tetrahedron names a wrong vertex",
       .mutate = other_number},
      {.id = "swapped-corners",
       .flags = {"numbers", "random"},
       .needed = any,
       .also = holes,
       .comment = "two neighbouring tetrahedra have exchanged one corner",
       .mutate = swapped_numbers},
      {.id = "swapped-points",
       .flags = {"coordinates", "random"},
       .needed = any,
       .also = holes,
       .comment = "two neighbouring vertices have exchanged their coordinates",
       .mutate = swapped_points},
      {.id = "wrong-coordinate",
       .flags = {"coordinates", "random"},
       .needed = any,
       .also = holes,
       .comment = "a coordinate with a wrong sign or a misplaced decimal point",
       .mutate = lost_digit},
      {.id = "jolted-vertex",
       .flags = {"coordinates", "random"},
       .needed = any,
       .also = holes,
       .comment = "a vertex moved in a random direction, by a little or far",
       .mutate = jolted},
  };
}

}  // namespace tetproof::corpus
