// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons: which are cut into fans, at which corner these start, and which are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<Index, 3>>;

// An OBJ file with these points and one face. `corners` are its corners, from 1; empty: all points in order.
std::string obj(const Points& points, std::vector<int> corners = {}) {
  std::string text;
  char line[128];
  for (const auto& p : points) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    text += line;
  }
  if (corners.empty())
    for (std::size_t i = 1; i <= points.size(); ++i) corners.push_back(static_cast<int>(i));
  text += "f";
  for (const int corner : corners) text.append(" ").append(std::to_string(corner));
  return text + "\n";
}

// The polygon, moved to another plane by a rotation with rational entries.
Points turned(Points points) {
  for (auto& p : points) {
    const double x = (2 * p[0] - p[1] + 2 * p[2]) / 3, y = (2 * p[0] + 2 * p[1] - p[2]) / 3,
                 z = (-p[0] + 2 * p[1] + 2 * p[2]) / 3;
    p = {x, y, z};
  }
  return points;
}

Points as_floats(Points points) {
  for (auto& p : points)
    for (double& x : p) x = static_cast<float>(x);
  return points;
}

Points rounded(Points points, double step) {
  for (auto& p : points)
    for (double& x : p) x = std::round(x / step) * step;
  return points;
}

Points moved(Points points, double by) {
  for (auto& p : points)
    for (double& x : p) x += by;
  return points;
}

Points regular(int corners, int step = 1) {
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * step * i / corners;
    points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  return points;
}

const Points square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const Points point_in_side{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const Points corner_shape{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
// The notch of a dart, which its diagonals see.
const Points dart{{0, 0, 0}, {1, -1, 0}, {0.1, 0, 0}, {1, 1, 0}};
const Triangles square_fan{{0, 1, 2}, {0, 2, 3}}, second_fan{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}};

struct Fan {
  const char* name;
  Points points;
  std::vector<int> corners;
  Triangles triangles;

  friend void PrintTo(const Fan& test, std::ostream* out) { *out << test.name; }
};

const std::vector<Fan> fans{
    {"Square", square, {}, square_fan},
    {"SquareBackwards", square, {4, 3, 2, 1}, {{3, 2, 1}, {3, 1, 0}}},
    {"SquareTurned", turned(square), {}, square_fan},
    {"SquareTurnedFloats", as_floats(turned(square)), {}, square_fan},
    {"SquareFarAwayFloats", as_floats(moved(turned(square), 5000.3)), {}, square_fan},
    {"SquareTurnedSixDigits", rounded(turned(square), 1e-6), {}, square_fan},
    {"SmallSquareSixDecimals",
     rounded({{0.1, 0.1, 0}, {0.12, 0.1, 0.0055}, {0.12, 0.12, 0.01}, {0.1, 0.12, 0.0045}}, 1e-6),
     {},
     square_fan},
    {"Tiny", {{0, 0, 0}, {1e-200, 0, 0}, {1e-200, 1e-200, 0}, {0, 1e-200, 0}}, {}, square_fan},
    {"Huge", {{0, 0, 0}, {1e200, 0, 0}, {1e200, 1e200, 0}, {0, 1e200, 0}}, {}, square_fan},
    {"Hexagon", as_floats(turned(regular(6))), {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}},
    // A fan from corner 1 would make a degenerate triangle.
    {"PointInSide", point_in_side, {}, second_fan},
    {"PointInSideFloats", as_floats(moved(turned(point_in_side), 0.1)), {}, second_fan},
    {"PointInSideSlightlyInwards",
     {{0, 0, 0}, {1, 1e-5, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
     {},
     second_fan},
    {"PointInEachSideOfTriangle",
     {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}},
     {},
     {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 0}}},
    {"Kite", {{0, 0, 0}, {1, -1, 0}, {5, 0, 0}, {1, 1, 0}}, {}, square_fan},
    // Repeated corners: the same number, or the same coordinates.
    {"CollapsedSide", square, {1, 2, 2, 3}, {{0, 1, 2}}},
    {"CollapsedSideAtTheEnd", square, {1, 2, 3, 1}, {{0, 1, 2}}},
    {"CollapsedByWelding", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}},
    {"CollapsedPentagon", square, {1, 2, 2, 3, 4}, square_fan},
    {"CollapsedToALine", square, {1, 2, 2, 1}, {{0, 1, 1}}},
    {"CollapsedToAPoint", square, {1, 1, 1, 1}, {{0, 0, 0}}},
    // Polygons without area become degenerate triangles, which the judge reports.
    {"OnALine", {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}, {}, square_fan},
    {"ThereAndBack", square, {1, 2, 1, 2}, {{0, 1, 0}, {0, 0, 1}}},
};

// Polygons that are not convex, by hand: triangles start with their first vertex and ascend.
const Triangles corner_cut{{0, 1, 3}, {0, 3, 5}, {1, 2, 3}, {3, 4, 5}};
const std::vector<Fan> others{
    {"LShape", corner_shape, {}, corner_cut},
    {"LShapeTurned", turned(corner_shape), {}, corner_cut},
    {"LShapeTurnedFloats", as_floats(turned(corner_shape)), {}, corner_cut},
    {"LShapeBackwards", corner_shape, {6, 5, 4, 3, 2, 1}, {{0, 3, 1}, {0, 5, 3}, {1, 3, 2}, {3, 5, 4}}},
    {"LShapeFromAnotherCorner", corner_shape, {4, 5, 6, 1, 2, 3}, corner_cut},
    {"Dart", dart, {}, {{0, 1, 2}, {0, 2, 3}}},
    {"TinyDart",
     {{0, 0, 0}, {1e-200, -1e-200, 0}, {1e-201, 0, 0}, {1e-200, 1e-200, 0}},
     {},
     {{0, 1, 2}, {0, 2, 3}}},
    {"HugeDart",
     {{0, 0, 0}, {1e200, -1e200, 0}, {1e199, 0, 0}, {1e200, 1e200, 0}},
     {},
     {{0, 1, 2}, {0, 2, 3}}},
    // All on one circle and a notch: the diagonals of the lattice square 1 2 3 4 go from the smallest number.
    {"NotchedSquare",
     {{2, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
     {2, 1, 3, 4, 5},
     {{0, 2, 3}, {0, 3, 4}, {0, 4, 1}}},
    // A hole that the polygon reaches over an edge which it runs both ways.
    {"HoleOverABridge",
     {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
     {1, 2, 3, 4, 1, 5, 8, 7, 6, 5},
     {{0, 1, 5}, {0, 4, 7}, {0, 5, 4}, {0, 7, 3}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}}},
    // Not planar: the shorter diagonal; of equal ones the one with the smallest number; never one that folds.
    {"Bent", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {}, {{1, 2, 3}, {1, 3, 0}}},
    {"BentFromAnotherCorner",
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}},
     {2, 3, 4, 1},
     {{1, 2, 3}, {1, 3, 0}}},
    {"Saddle", {{0, 0, 0}, {1, 0, 0.25}, {1, 1, 0}, {0, 1, 0.25}}, {}, square_fan},
    {"SaddleFromAnotherCorner",
     {{0, 0, 0}, {1, 0, 0.25}, {1, 1, 0}, {0, 1, 0.25}},
     {2, 3, 4, 1},
     {{2, 3, 0}, {2, 0, 1}}},
    {"BentDart", {{0, 0, 0.5}, {1, -1, 0}, {0.1, 0, 0}, {1, 1, 0}}, {}, {{0, 1, 2}, {0, 2, 3}}},
    {"BentPentagon",
     {{0, 0, 0}, {2, 0, 0.5}, {2, 2, 0}, {1, 1.5, 0}, {0, 2, 0}},
     {},
     {{0, 1, 3}, {0, 3, 4}, {1, 2, 3}}},
};

class PolygonFans : public testing::TestWithParam<Fan> {};

TEST_P(PolygonFans, Cut) {
  const test::TestFiles files;
  const std::string path = files.write("a.obj", obj(GetParam().points, GetParam().corners));
  TriangleSurface surface;
  EXPECT_EQ(files.message([&] { surface = read_surface(path); }), "no error");
  EXPECT_EQ(surface.triangles, GetParam().triangles);
}

struct Refusal {
  const char* name;
  Points points;
  std::vector<int> corners;
  std::string fault;

  friend void PrintTo(const Refusal& test, std::ostream* out) { *out << test.name; }
};

const std::vector<Refusal> refusals{
    {"Bow", {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {}, "crosses itself"},
    {"UnevenBow", {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {2, 1, 0}}, {}, "crosses itself"},
    {"BentUnevenBow", {{0, 0, 0}, {1, 0, 1}, {0, 3, 0}, {2, 1, 0}}, {}, "crosses itself"},
    {"Pentagram", regular(5, 2), {}, "crosses itself"},
    {"TwiceAround", square, {1, 2, 3, 4, 1, 2, 3, 4}, "winds more than once around"},
    {"Infinite",
     {{0, 0, 0}, {1, 0, 0}, {1, INFINITY, 0}, {0, 1, 0}},
     {},
     "has a coordinate that is not finite or too large"},
    {"TooLarge",
     {{-1e308, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {-1e308, 1e308, 0}},
     {},
     "has a coordinate that is not finite or too large"},
};

class PolygonRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(PolygonRefusals, Message) {
  const test::TestFiles files;
  const Refusal& refusal = GetParam();
  const std::string path = files.write("a.obj", obj(refusal.points, refusal.corners));
  const std::size_t corners = refusal.corners.empty() ? refusal.points.size() : refusal.corners.size();
  EXPECT_EQ(files.message([&] { read_surface(path); }), "a.obj:" + std::to_string(refusal.points.size() + 1) +
                                                            ": face with " + std::to_string(corners) +
                                                            " corners " + refusal.fault);
}

const auto name_of = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Surface, PolygonFans, testing::ValuesIn(fans), name_of);
INSTANTIATE_TEST_SUITE_P(NotConvex, PolygonFans, testing::ValuesIn(others), name_of);
INSTANTIATE_TEST_SUITE_P(Surface, PolygonRefusals, testing::ValuesIn(refusals), name_of);

// The corners are so close that no single one is noticeably reflex.
TEST(Polygons, CrescentOfManyCorners) {
  const int n = 20000;
  Points points;
  for (int i = 0; i <= n; ++i)
    points.push_back({std::cos(std::numbers::pi * i / n), std::sin(std::numbers::pi * i / n), 0});
  for (int i = n - 1; i > 0; --i)
    points.push_back({std::cos(std::numbers::pi * i / n), 0.5 * std::sin(std::numbers::pi * i / n), 0});
  const test::TestFiles files;
  const TriangleSurface surface = read_surface(files.write("a.obj", obj(points)));
  EXPECT_EQ(surface.triangles.size(), points.size() - 2);
  double area = 0;
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d a = surface.vertices[t[0]], b = surface.vertices[t[1]] - a,
                          c = surface.vertices[t[2]] - a;
    EXPECT_GT(b[0] * c[1] - b[1] * c[0], 0);
    area += (b[0] * c[1] - b[1] * c[0]) / 2;
  }
  EXPECT_NEAR(area, std::numbers::pi / 4, 1e-8);
}

// What is not planar is said: how many, and the largest bend.
TEST(Polygons, BendsAreAWarning) {
  const test::TestFiles files;
  const auto warnings = [&](const std::string& text) {
    std::string all;
    for (const std::string& warning : read_surface_file(files.write("a.obj", text)).warnings)
      all += warning.substr(warning.find("a.obj"));
    return all;
  };
  EXPECT_EQ(warnings(obj(square)), "");
  EXPECT_EQ(warnings(obj({{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-13}, {0, 1, 0}})), "");  // rounding
  EXPECT_EQ(
      warnings(obj({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}})),
      // by hand: the normals (-0.1, -0.1, 1) and (0, 0, 1)
      "a.obj: 1 quadrangle is not planar: cut along the shorter diagonal; the largest bend is 8.05 degrees");
  EXPECT_EQ(warnings("v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\nf 2 5 6 4 3\n"),
            "a.obj: 1 quadrangle is not planar: cut along the shorter diagonal; 1 polygon is not planar: cut "
            "as seen "
            "along the axis next to the normal; the largest bend is 90 degrees");
}

TEST(Polygons, TimeGrowsWithTheCorners) {
  const test::TestFiles files;
  const int n = 200000;
  const std::string path = files.write("a.obj", obj(regular(n)));
  const std::clock_t start = std::clock();  // CPU time, so that other programs do not count
  const TriangleSurface surface = read_surface(path);
  EXPECT_LT(std::clock() - start, 30 * CLOCKS_PER_SEC);  // minutes if quadratic, seconds with sanitizers
  EXPECT_EQ(surface.triangles.size(), static_cast<std::size_t>(n - 2));
  double area = 0;
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d a = surface.vertices[t[0]], b = surface.vertices[t[1]] - a,
                          c = surface.vertices[t[2]] - a;
    area += (b[0] * c[1] - b[1] * c[0]) / 2;
  }
  EXPECT_NEAR(area, std::numbers::pi, 1e-8);
}

}  // namespace
}  // namespace tetproof
