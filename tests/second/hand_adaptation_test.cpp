// SPDX-License-Identifier: GPL-3.0-or-later
// Sections 3 and 4 of the second implementation by itself, against hand calculation.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/second/cube.hpp"
#include "tests/second/second.hpp"
#include "tests/second/section3.hpp"

namespace tetproof::second {
namespace {

// --- step (v)

const Corners right_angled{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
const Corners regular{Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)};  // edge 2 sqrt 2

TEST(SecondEquations, ByHand) {
  Law law{.v0 = 1, .v1 = 3, .d1 = 2, .p = 2};
  EXPECT_DOUBLE_EQ(desired_volume(0, law, Mistake::none), 1);
  EXPECT_DOUBLE_EQ(desired_volume(1, law, Mistake::none), 1.5);
  EXPECT_DOUBLE_EQ(desired_volume(2, law, Mistake::none), 3);
  EXPECT_DOUBLE_EQ(desired_volume(4, law, Mistake::none), 9);
  law = {.v0 = 3, .v1 = 1, .d1 = 2, .p = 1};
  EXPECT_DOUBLE_EQ(desired_volume(4, law, Mistake::none), 1);  // not -1 (D13)
  law.kappa_min = 2;
  law.kappa_max = 4;
  EXPECT_DOUBLE_EQ(curvature_weight(2, law, Mistake::none), 1);
  EXPECT_DOUBLE_EQ(curvature_weight(3, law, Mistake::none), 0.55);
  EXPECT_DOUBLE_EQ(curvature_weight(4, law, Mistake::none), 0.1);
  law.kappa_min = 4;
  EXPECT_EQ(curvature_weight(4, law, Mistake::none), 1);

  // The centroid (1/4, 1/4, 1/4) has the vertex (0, 0, 0) of the cube at a distance of sqrt(3)/4.
  law = {.v0 = 1, .v1 = 2, .d1 = std::sqrt(3.0), .p = 1};
  const Weight w = weigh(cube(), right_angled, law, Mistake::none);
  EXPECT_DOUBLE_EQ(w.d, std::sqrt(3.0) / 4);
  EXPECT_DOUBLE_EQ(w.volume, 1.0 / 6);
  EXPECT_DOUBLE_EQ(w.desired, 1.25);
  EXPECT_DOUBLE_EQ(w.error, 1.25 - 1.0 / 6);
}

TEST(SecondEquations, QualityOfKnownTetrahedra) {
  // At a right-angled corner an eighth of the sphere; at the others arctan(sqrt 2) (three dihedral angles,
  // less pi) is what remains: 2 (54.7356 degrees) + 90 degrees - 180 degrees = 19.4712 degrees.
  EXPECT_NEAR(smallest_solid_angle(right_angled),
              (2 * std::atan(std::sqrt(2.0)) - std::numbers::pi / 2) / (4 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(smallest_solid_angle(regular), std::acos(23.0 / 27) / (4 * std::numbers::pi), 1e-15);
  // D / A: the largest face, of area sqrt(3)/2, has the smallest distance, 1/sqrt(3).
  EXPECT_NEAR(quality(right_angled, Quality::aspect_ratio), (1 / std::sqrt(3.0)) / (std::sqrt(3.0) / 2),
              1e-15);
  EXPECT_NEAR(quality(regular, Quality::aspect_ratio), (4 / std::sqrt(3.0)) / (2 * std::sqrt(3.0)), 1e-15);
}

TEST(SecondEquations, CurvatureOfAQuadricIsExact) {
  // f = (c20 u^2 + 2 c11 u v + c02 v^2) / 2 over a square of 5 x 5 points, which a half turn maps to itself:
  // the normal in its middle is z.
  const auto patch = [](double c20, double c11, double c02, int step) {
    TriangleSurface s;
    for (int v = -2; v <= 2; ++v)
      for (int u = -2; u <= 2; ++u)
        s.vertices.push_back(Point(u, v, (c20 * u * u + 2 * c11 * u * v + c02 * v * v) / 2));
    for (int v = 0; v < 4; v += step)
      for (int u = 0; u < 4; u += step) {
        const int a = u + 5 * v, b = a + step, c = a + 5 * step, d = c + step;
        s.triangles.push_back({a, b, d});
        s.triangles.push_back({a, d, c});
      }
    return absolute_curvatures(s, Mistake::none)[12];
  };
  EXPECT_NEAR(patch(2, 0, 1, 1), 3, 1e-12);
  EXPECT_NEAR(patch(2, 0, -1, 1), 3, 1e-12);
  EXPECT_NEAR(patch(0, 1.5, 0, 1), 3, 1e-12);  // eigenvalues 1.5 and -1.5
  EXPECT_NEAR(patch(0, 0, 0, 1), 0, 1e-15);
  // A vertex with the four neighbours (1,0), (0,1), (-1,0), (0,-1) does not know c11 without the second ring.
  TriangleSurface s;
  const auto f = [](double u, double v) { return Point(u, v, u * v); };
  s.vertices = {f(0, 0), f(1, 0), f(0, 1), f(-1, 0), f(0, -1), f(2, 1), f(-1, 2), f(-2, -1), f(1, -2)};
  s.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 5, 2}, {2, 6, 3}, {3, 7, 4}, {4, 8, 1}};
  EXPECT_NEAR(absolute_curvatures(s, Mistake::none)[0], 2, 1e-12);
}

// --- step (vi)

TriangleSurface far_cube() {
  TriangleSurface far = cube();
  for (Point& v : far.vertices) v += Point(100, 0, 0);
  return far;
}

// What one insertion into a grid does: everything is much too large, and the surface far away.
trace::Insertion first_split(const Grid& grid) {
  const TriangleSurface far = far_cube();
  std::vector<trace::Record> records;
  Adaptation(far, grid, {.insertions = 1, .v0 = 0.001, .v1 = 0.001, .improve = Quality::none}).run(records);
  for (const trace::Record& record : records)
    if (const auto* insertion = std::get_if<trace::Insertion>(&record)) return *insertion;
  return {};
}

TEST(SecondTable4, ATetrahedronAlone) {
  Grid grid{.points = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, .tets = {{0, 1, 2, 3}}};
  const auto split = [&](std::vector<bool> on_surface) {
    grid.on_surface = std::move(on_surface);
    const trace::Insertion made = first_split(grid);
    return std::tuple(made.row, made.replaced, made.point);
  };
  const std::vector<int> all{0, 1, 2, 3};
  EXPECT_EQ(split({false, false, false, false}), std::tuple("0", all, Point(0.5, 0.75, 1)));
  EXPECT_EQ(split({false, true, false, false}), std::tuple("1", all, Point(0.5, 0.75, 1)));
  EXPECT_EQ(split({false, true, false, true}), std::tuple("2b", (std::vector{1, 3}), Point(1, 0, 2)));
  EXPECT_EQ(split({true, true, true, false}), std::tuple("3b", (std::vector{0, 1, 2}), Point(2.0 / 3, 1, 0)));
  EXPECT_EQ(split({true, true, true, true}),
            std::tuple("4e", (std::vector{2, 3}), Point(0, 1.5, 2)));  // 3-4-5
}

TEST(SecondTable4, WithNeighbours) {
  // A large tetrahedron 0123 and small ones at its faces, at their far sides: it is the one that is split.
  const std::vector<Point> points{{0, 0, 0},         {2, 0, 0},     {0, 3, 0},
                                  {0, 0, 4},         {-0.01, 1, 1}, {1, -0.01, 1},
                                  {0.5, 0.5, -0.01}, {1, 1.2, 1.2}, {0, 1, -0.01}};
  const std::array<int, 4> whole{0, 1, 2, 3}, x{0, 3, 2, 4}, y{0, 1, 3, 5}, z{0, 2, 1, 6},
      slanted{1, 2, 3, 7}, at_edge{0, 2, 8, 4};
  const auto split = [&](std::vector<std::array<int, 4>> tets) {
    tets.insert(tets.begin(), whole);
    const trace::Insertion made = first_split({points, std::vector<bool>(points.size(), true), tets});
    EXPECT_EQ(made.tet[1], points[1]);
    return std::pair(made.row, made.replaced);
  };
  using Made = std::pair<std::string, std::vector<int>>;
  EXPECT_EQ(split({x, y, z, slanted}), (Made{"4a", {0, 1, 2, 3}}));
  EXPECT_EQ(split({x, y, z}), (Made{"4b", {1, 2, 3}}));
  EXPECT_EQ(split({y, slanted}), (Made{"4c", {0, 2}}));  // the planes x = 0 and z = 0 are free
  EXPECT_EQ(split({y, slanted, at_edge}),
            (Made{"4c", {0, 2, 3}}));           // somebody has their edge: the larger face, x = 0
  EXPECT_EQ(split({y}), (Made{"4d", {2, 3}}));  // the longest edge that is no edge of y
  EXPECT_EQ(split({slanted}), (Made{"4d", {0, 3}}));
}

TEST(SecondInsertion, ASplitThatDegeneratesIsRefused) {
  // Too small for doubles to have a point within: the centroid is rounded to a corner.
  const double e = std::nextafter(1.0, 2.0);
  const Grid grid{.points = {{1, 1, 1}, {e, 1, 1}, {1, e, 1}, {1, 1, e}},
                  .on_surface = std::vector<bool>(4, false),
                  .tets = {{0, 1, 2, 3}}};
  std::vector<trace::Record> records;
  const TriangleSurface far = far_cube();
  Adaptation(far, grid, {.insertions = 5, .v0 = 0.001, .v1 = 0.001}).run(records);
  const auto& end = std::get<trace::End>(records.back());
  EXPECT_EQ(end.refused, 1);
  EXPECT_EQ(end.insertions, 0);
  EXPECT_EQ(end.stopped, "no-gain");
}

TEST(SecondInsertion, RememberedSplitsAreThoseEvaluatedAnew) {
  TriangleSurface ball = cube();
  for (Point& v : ball.vertices) v = (v - Point(0.5, 0.5, 0.5)) * 2 + Point(0.01, 0.02, 0.03).cwiseProduct(v);
  const auto lines = [&](bool remember) {
    std::string text;
    const Settings settings{
        .cells = {4, 0, 0}, .v0 = 0.1, .v1 = 1, .improve_below = 0.01, .remember_splits = remember};
    for (const auto& record : run(ball, settings, "ball").records) text += trace::to_line(record) + "\n";
    return text;
  };
  const std::string text = lines(true);
  EXPECT_EQ(text, lines(false));
  EXPECT_NE(text.find("\"flip\""), std::string::npos);
}

// --- section 4

// Two or three tetrahedra on five points: a triangle of radius 1 and an edge through its middle.
TEST(SecondFlips, TheBetterOfTwoTriangulations) {
  const double s = std::sqrt(0.75);
  const auto flips = [&](double up, double down, bool two, Quality kind) {
    const Grid grid{.points = {{1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}, {0.01, 0, up}, {0, 0.01, -down}},
                    .on_surface = std::vector<bool>(5, false),
                    .tets = two ? std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {0, 2, 1, 4}}
                                : std::vector<std::array<int, 4>>{{3, 4, 1, 0}, {3, 4, 2, 1}, {3, 4, 0, 2}}};
    const TriangleSurface surface = cube();
    std::vector<trace::Record> records;
    Adaptation adaptation(surface, grid, {.improve = kind});
    adaptation.improve(two ? std::set<std::int64_t>{0, 1} : std::set<std::int64_t>{0, 1, 2}, records);
    for (const auto& [a, b, c, d] : adaptation.mesh().tets)
      EXPECT_EQ(orientation(grid.points[a], grid.points[b], grid.points[c], grid.points[d]), 1);
    return std::pair(records.size(), adaptation.mesh().tets.size());
  };
  using Made = std::pair<std::size_t, std::size_t>;
  for (const Quality kind : {Quality::solid_angle, Quality::aspect_ratio}) {
    // High: each half is well shaped, the three are needles.
    EXPECT_EQ(flips(3, 3, true, kind), (Made{0, 2}));
    EXPECT_EQ(flips(3, 3, false, kind), (Made{1, 2}));
    // One half is flat: the three share what there is.
    EXPECT_EQ(flips(0.6, 0.05, true, kind), (Made{1, 3}));
    EXPECT_EQ(flips(0.6, 0.05, false, kind), (Made{0, 3}));
  }
}

TEST(SecondFlips, NoneWhereTheHullIsNotConvex) {
  // The edge 3-4 passes outside the triangle.
  const Grid grid{.points = {{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {2, 0, 0.2}, {2, 0, -0.2}},
                  .on_surface = std::vector<bool>(5, false),
                  .tets = {{0, 1, 2, 3}, {0, 2, 1, 4}}};
  for (const Mistake mistake : {Mistake::none, Mistake::worst_flip}) {
    const TriangleSurface surface = cube();
    std::vector<trace::Record> records;
    Adaptation(surface, grid, {.mistake = mistake}).improve({0, 1}, records);
    EXPECT_TRUE(records.empty());
  }
}

}  // namespace
}  // namespace tetproof::second
