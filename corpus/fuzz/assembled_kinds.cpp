// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces of several bodies: boxes in boxes, bodies of very different size, many small ones,
// a spike that nearly touches. Their bounding boxes are disjoint, or lie in one another.
#include <algorithm>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/revolved.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

TriangleSurface octahedron(const Eigen::Vector3d& centre, double radius) {
  TriangleSurface surface = revolved({{radius, 0}}, 4, {-radius}, {radius});
  for (Eigen::Vector3d& v : surface.vertices) v += centre;
  return surface;
}

TriangleSurface tetrahedron(const Eigen::Vector3d& low, double size) {
  return {{low, low + Eigen::Vector3d(size, 0, 0), low + Eigen::Vector3d(0, size, 0),
           low + Eigen::Vector3d(0, 0, size)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
          {},
          {}};
}

TriangleSurface random_body(Random& random, const Eigen::Vector3d& low, double size) {
  const int choice = random.below(3);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(size / 2);
  if (choice == 0) return tetrahedron(low, size);
  if (choice == 1) return octahedron(low + half, size / 2);
  return box_surface(low, low + 2 * half);
}

Shape nested_boxes(const Numbers& values) {
  const int n = values.integer("n");
  const double gap = values["gap"];
  if (!(2 * (n - 1) * gap < 1)) throw InputError("gap: expected less than 1 / (2n - 2)");
  Shape shape{{}, n, n / 2, 0};
  for (int k = 0; k < n; ++k)
    append(shape.surface,
           box_surface(Eigen::Vector3d::Constant(k * gap), Eigen::Vector3d::Constant(1 - k * gap)), {0, 0, 0},
           k % 2 == 1);
  return shape;
}

// Body k lies between x = s and 2s, where s = ratio^k: the small ones near the origin, where doubles are
// dense.
Shape scales(const Numbers& values) {
  const int n = values.integer("n");
  Random random = values.random();
  Shape shape{{}, n, 0, 0};
  double size = 1;
  for (int k = 0; k < n; ++k, size *= values["ratio"])
    append(shape.surface, random_body(random, Eigen::Vector3d::Constant(size), size));
  return shape;
}

Shape many(const Numbers& values) {
  const int n = values.integer("n");
  int row = 1;
  while (row * row * row < n) ++row;
  Random random = values.random();
  Shape shape{{}, n, 0, 0};
  for (int i = 0; i < n; ++i)
    append(shape.surface,
           random_body(random, Eigen::Vector3d(i % row, i / row % row, i / (row * row)), values["size"]));
  return shape;
}

Shape spike(const Numbers& values) {
  const double gap = values["gap"], h = values["h"];
  Shape shape{box_surface({-1, -1, -1}, {1, 1, 0}), 2, 0, 0};
  append(shape.surface, revolved({{1, gap + h}}, values.integer("n"), {gap}, {}));
  return shape;
}

}  // namespace

std::vector<FuzzKind> assembled_kinds() {
  return {
      {"nested-boxes",
       "boxes in one another; every second one bounds a cavity",
       "walls a hair thick",
       {{"n", Draw::integer, 2, 100, 2, 6, 2, "boxes"},
        {"gap", Draw::length, 1e-12, 0.4, 1e-10, 0.05, 0.25, "between two boxes; the outermost has edge 1"}},
       nested_boxes},
      {"scales",
       "n bodies, each much smaller than the one before",
       "triangles of very different size",
       {seed_parameter(),
        {"n", Draw::integer, 1, 20, 2, 5, 1, "bodies"},
        {"ratio", Draw::length, 1e-6, 0.49, 1e-6, 0.4, 0.1, "of the sizes"}},
       scales},
      {"many",
       "n small bodies, one in each cell of a cubic grid",
       "many components",
       {seed_parameter(),
        {"n", Draw::integer, 1, 1000, 5, 40, 1, "bodies"},
        {"size", Draw::length, 1e-9, 0.999, 1e-6, 0.999, 0.5, "of a body; the cells' edge is 1"}},
       many},
      {"spike",
       "a box, and a pyramid whose tip nearly touches its top",
       "a tip a hair above a face of another body",
       {{"n", Draw::integer, 3, 1000, 3, 20, 3, "corners of the pyramid's base"},
        {"gap", Draw::length, 1e-12, 10, 1e-11, 1, 1, "between them"},
        {"h", Draw::length, 1e-3, 1e3, 0.1, 10, 1, "height of the pyramid"}},
       spike},
  };
}

}  // namespace tetproof::corpus
