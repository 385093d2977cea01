// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces that are convex hulls: of points on one sphere, of points of a lattice.
#include <algorithm>
#include <utility>

#include "corpus/fuzz/hull.hpp"
#include "corpus/fuzz/kind.hpp"
#include "corpus/generators/octahedral_grid.hpp"

namespace tetproof::corpus {
namespace {

// The points (+-a, +-b, +-c) in every order of a, b, c, which are different: all on one sphere, exactly.
std::vector<Eigen::Vector3d> same_length(double a, double b, double c) {
  std::array<double, 3> abc{a, b, c};
  std::sort(abc.begin(), abc.end());
  std::vector<Eigen::Vector3d> points;
  do {
    for (int signs = 0; signs < 8; ++signs)
      points.emplace_back(signs & 1 ? -abc[0] : abc[0], signs & 2 ? -abc[1] : abc[1],
                          signs & 4 ? -abc[2] : abc[2]);
  } while (std::next_permutation(abc.begin(), abc.end()));
  return points;
}

Shape cospherical(const Numbers& values) {
  Random random = values.random();
  const std::size_t n = static_cast<std::size_t>(values["n"]);
  std::vector<Eigen::Vector3d> points;
  if (values["exact"] == 1) {
    const int a = 1 + random.below(20), b = a + 1 + random.below(20), c = b + 1 + random.below(20);
    points = same_length(a, b, c);
    shuffle(points, random);
    points.resize(std::min(n, points.size()));
  } else {
    while (points.size() < n) {
      const double u = random.between(-1, 1);
      points.push_back(octahedral_direction({u, random.between(-1, 1)}));
    }
  }
  return one_body(convex_hull(points));
}

Shape lattice_hull(const Numbers& values) {
  Random random = values.random();
  const int m = values.integer("m");
  std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // not in one plane
  for (int i = 0; i < values.integer("n"); ++i) {
    const int x = random.below(m + 1), y = random.below(m + 1);
    points.emplace_back(x, y, random.below(m + 1));
  }
  return one_body(convex_hull(points));
}

}  // namespace

std::vector<FuzzKind> hull_kinds() {
  return {
      {"cospherical",
       "the convex hull of random points on one sphere",
       "points on one sphere, exactly or up to rounding; slivers",
       {seed_parameter(),
        // nine of the exact points are never in one plane: at most eight have the same distance from a plane
        {"n", Draw::integer, 9, 500, 9, 60, 9, "points; of the exact ones there are 48"},
        {"exact", Draw::integer, 0, 1, 0, 1, 0, "1: whole numbers on one sphere, exactly"}},
       cospherical},
      {"lattice-hull",
       "the convex hull of n random points of a lattice, of its origin and of three points beside that",
       "exactly coplanar and collinear points, vertices of high degree",
       {seed_parameter(),
        {"n", Draw::integer, 0, 1000, 4, 80, 0, "points"},
        {"m", Draw::integer, 1, 100000, 2, 12, 1, "coordinates are 0 to m"}},
       lattice_hull},
  };
}

}  // namespace tetproof::corpus
