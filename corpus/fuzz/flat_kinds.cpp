// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces with flat faces that random points split: boxes, exactly or nearly coplanar, and
// thin plates.
//
// A square is split by points of a grid, so that every decision is exact. Its pieces are then the faces of a
// box, or a graph over the box's face that only rises outward: bumps of two faces stay apart, because each
// lies over its own face.
#include <array>

#include "corpus/fuzz/kind.hpp"

namespace tetproof::corpus {
namespace {

constexpr int grid = 1000;
using GridPoint = std::array<int, 2>;

struct SplitSquare {
  std::vector<GridPoint> points{{0, 0}, {grid, 0}, {grid, grid}, {0, grid}};
  std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}};  // anticlockwise
};

std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return static_cast<std::int64_t>(b[0] - a[0]) * (c[1] - a[1]) -
         static_cast<std::int64_t>(b[1] - a[1]) * (c[0] - a[0]);
}

// Joins a point with the corners of the triangle that it lies in; on an edge, of both triangles. A point that
// is there already changes nothing.
void insert(SplitSquare& square, const GridPoint& p) {
  const int added = static_cast<int>(square.points.size());
  std::vector<std::array<int, 3>> kept;
  std::vector<std::array<int, 2>> rim;
  for (const auto& t : square.triangles) {
    std::array<std::int64_t, 3> turns;
    for (int k = 0; k < 3; ++k) turns[k] = turn(square.points[t[k]], square.points[t[(k + 1) % 3]], p);
    if (turns[0] < 0 || turns[1] < 0 || turns[2] < 0) {
      kept.push_back(t);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      if (square.points[t[k]] == p) return;
      if (turns[k] > 0) rim.push_back({t[k], t[(k + 1) % 3]});
    }
  }
  square.points.push_back(p);
  for (const auto& [a, b] : rim) kept.push_back({a, b, added});
  square.triangles = std::move(kept);
}

SplitSquare split_square(int points, Random& random) {
  SplitSquare square;
  for (int i = 0; i < points; ++i) {
    const int x = 1 + random.below(grid - 1);
    insert(square, {x, 1 + random.below(grid - 1)});
  }
  return square;
}

double on_grid(int i) {
  return static_cast<double>(i) / grid;
}

// Adds one face of a box. `place` maps the square and the height over it, outward, to space, and keeps the
// orientation.
template <class Place>
void add_face(Collector& all, const SplitSquare& square, double bumps, Random& random, Place place) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < square.points.size(); ++i) {
    const double height = i < 4 || bumps == 0 ? 0 : bumps * random.unit();
    points.push_back(place(on_grid(square.points[i][0]), on_grid(square.points[i][1]), height));
  }
  for (const auto& [a, b, c] : square.triangles) all.triangle(points[a], points[b], points[c]);
}

Shape split_cube(const Numbers& values, double bumps) {
  Random random = values.random();
  Collector all;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const SplitSquare square = split_square(values.integer("n"), random);
      add_face(all, square, bumps, random, [&](double u, double v, double height) {
        Eigen::Vector3d p;
        p[axis] = upper ? 1 + height : -height;
        p[(axis + (upper ? 1 : 2)) % 3] = u;
        p[(axis + (upper ? 2 : 1)) % 3] = v;
        return p;
      });
    }
  return one_body(all.take());
}

Shape coplanar(const Numbers& values) {
  return split_cube(values, 0);
}

Shape nearly_coplanar(const Numbers& values) {
  return split_cube(values, values["e"]);
}

Shape thin_plate(const Numbers& values) {
  Random random = values.random();
  const double h = values["h"];
  Collector all;
  const SplitSquare below = split_square(values.integer("n"), random);
  add_face(all, below, 0, random, [](double u, double v, double) { return Eigen::Vector3d(v, u, 0); });
  const SplitSquare above = split_square(values.integer("n"), random);
  add_face(all, above, 0, random, [h](double u, double v, double) { return Eigen::Vector3d(u, v, h); });
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    const auto& [x, y] = corners[i];
    const auto& [next_x, next_y] = corners[(i + 1) % 4];
    all.triangle({x, y, 0}, {next_x, next_y, 0}, {next_x, next_y, h});
    all.triangle({x, y, 0}, {next_x, next_y, h}, {x, y, h});
  }
  return one_body(all.take());
}

FuzzParameter points(double high) {
  return {"n", Draw::integer, 0, 1000, 1, high, 0, "random points that split each face"};
}

}  // namespace

std::vector<FuzzKind> flat_kinds() {
  return {
      {"coplanar",
       "a cube whose faces are split by random points",
       "many exactly coplanar triangles, needles among them",
       {seed_parameter(), points(12)},
       coplanar},
      {"nearly-coplanar",
       "a cube whose faces are split by random points that stand out a hair",
       "dihedral angles of nearly 180 degrees, needles",
       {seed_parameter(),
        points(12),
        {"e", Draw::length, 1e-17, 1, 1e-16, 0.1, 1, "height of the bumps at most; the cube's edge is 1"}},
       nearly_coplanar},
      {"thin-plate",
       "a square plate; random points split its top and its underside, differently",
       "walls that are far thinner than the triangles beside them are wide",
       {seed_parameter(),
        points(40),
        {"h", Draw::length, 1e-12, 1, 1e-9, 0.1, 1, "thickness; the plate's edge is 1"}},
       thin_plate},
  };
}

}  // namespace tetproof::corpus
