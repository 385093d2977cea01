// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces that are made of subdivided octahedra.
//
// Each triangle is seen from the centre under an angle that does not vanish, and the triangles cover every
// direction once, whatever the vertices' distances from the centre: one body is embedded. Shells about one
// centre are copies of one another in different sizes. Bodies side by side have disjoint boxes.
#include "corpus/fuzz/kind.hpp"
#include "corpus/generators/octahedral_grid.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

TriangleSurface sphere(int f) {
  TriangleSurface surface = octahedral_surface(f, [](const Eigen::Vector3d& direction) { return direction; });
  surface.parameters.clear();
  surface.evaluate = nullptr;
  return surface;
}

FuzzParameter frequency(double low, double high) {
  return {"f", Draw::integer, 1, 50, low, high, 1, "pieces of an octahedron's edge: 8 f^2 triangles"};
}

Shape big_sphere(const Numbers& values) {
  return one_body(sphere(values.integer("f")));
}

Shape nested_spheres(const Numbers& values) {
  const int n = values.integer("n");
  if (!((n - 1) * values["gap"] < 1)) throw InputError("gap: expected less than 1 / (n - 1)");
  const TriangleSurface unit = sphere(values.integer("f"));
  Shape shape{{}, n, n / 2, 0};
  for (int k = 0; k < n; ++k) {
    TriangleSurface shell = unit;
    for (Eigen::Vector3d& v : shell.vertices) v *= 1 - k * values["gap"];
    append(shape.surface, shell, {0, 0, 0}, k % 2 == 1);
  }
  return shape;
}

Shape two_spheres(const Numbers& values) {
  const TriangleSurface unit = sphere(values.integer("f"));
  Shape shape{unit, 2, 0, 0};
  append(shape.surface, unit, {2 + values["gap"], 0, 0});
  return shape;
}

Shape star(const Numbers& values) {
  TriangleSurface surface = sphere(values.integer("f"));
  Random random = values.random();
  for (Eigen::Vector3d& v : surface.vertices) v *= random.between(values["low"], 1);
  return one_body(std::move(surface));
}

}  // namespace

std::vector<FuzzKind> sphere_kinds() {
  return {
      {"big-sphere",
       "a sphere of many triangles",
       "more triangles than the others have",
       {frequency(5, 13)},
       big_sphere},
      {"nested-spheres",
       "n spheres about one centre; every second one bounds a cavity",
       "shells a hair apart",
       {{"n", Draw::integer, 2, 20, 2, 4, 2, "shells"},
        frequency(1, 3),
        {"gap", Draw::length, 1e-9, 0.9, 1e-7, 0.2, 0.25, "between two shells; the outermost has radius 1"}},
       nested_spheres},
      {"two-spheres",
       "two spheres side by side, nearly touching in a vertex of each",
       "vertices a hair apart that do not belong together",
       {frequency(1, 4), {"gap", Draw::length, 1e-12, 10, 1e-10, 1, 1, "between them; their radius is 1"}},
       two_spheres},
      {"star",
       "a sphere whose vertices are moved towards the centre at random",
       "spikes, sharp valleys, slivers",
       {seed_parameter(),
        frequency(1, 5),
        {"low", Draw::length, 1e-6, 1, 1e-3, 0.9, 0.5, "least distance from the centre; the greatest is 1"}},
       star},
  };
}

}  // namespace tetproof::corpus
