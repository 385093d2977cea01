// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the solids that facets enclose, whatever way they run.
#include "io/surface/solid_boundary.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

struct Facets {
  std::vector<Vector3d> points;
  std::vector<std::array<Index, 3>> triangles;

  Index point(const Vector3d& p) {
    const auto found = std::find(points.begin(), points.end(), p);
    if (found != points.end()) return static_cast<Index>(found - points.begin());
    points.push_back(p);
    return static_cast<Index>(points.size()) - 1;
  }
  void quadrangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    triangles.push_back({point(a), point(b), point(c)});
    triangles.push_back({point(a), point(c), point(d)});
  }
  // The sides of a box, those of `leave_out` excepted: 0 to 5 for x low, x high, y low, ... Every second
  // triangle is wound inwards.
  void box(const Vector3d& low, const Vector3d& high, const std::vector<int>& leave_out = {}) {
    for (int side = 0; side < 6; ++side) {
      if (std::count(leave_out.begin(), leave_out.end(), side)) continue;
      const int x = side / 2, y = (x + 1) % 3, z = (x + 2) % 3;
      std::array<Vector3d, 4> corners;
      for (std::size_t k = 0; k < 4; ++k) {
        corners[k][x] = side % 2 ? high[x] : low[x];
        corners[k][y] = k == 1 || k == 2 ? high[y] : low[y];
        corners[k][z] = k >= 2 ? high[z] : low[z];
      }
      quadrangle(corners[0], corners[1], corners[2], corners[3]);
    }
    for (std::size_t t = 0; t < triangles.size(); t += 2) std::swap(triangles[t][0], triangles[t][1]);
  }
  double volume(const SolidBoundary& boundary) const {
    double volume = 0;
    for (const auto& [a, b, c] : boundary.triangles)
      volume += points[static_cast<std::size_t>(a)].dot(
                    points[static_cast<std::size_t>(b)].cross(points[static_cast<std::size_t>(c)])) /
                6;
    return volume;
  }
};

TEST(SolidBoundary, TurnsFacetsOutwards) {
  Facets facets;
  facets.box({0, 0, 0}, {1, 2, 3});
  const auto boundary = solid_boundary(facets.points, facets.triangles, {});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->triangles.size(), 12u);
  EXPECT_EQ(boundary->turned, 6u);
  EXPECT_DOUBLE_EQ(facets.volume(*boundary), 6);
}

// Two boxes that share a wall, two regions for TetGen.
TEST(SolidBoundary, LeavesOutWallsBetweenRegions) {
  Facets facets;
  facets.box({0, 0, 0}, {1, 1, 1});
  facets.box({1, 0, 0}, {2, 1, 1}, {0});
  const auto boundary = solid_boundary(facets.points, facets.triangles, {});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->triangles.size(), 20u);
  EXPECT_DOUBLE_EQ(facets.volume(*boundary), 2);
  // A point in the second box: it is a hole, and the wall is a part of the surface.
  const std::vector<Vector3d> holes{{1.5, 0.4, 0.3}};
  const auto one = solid_boundary(facets.points, facets.triangles, holes);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(facets.volume(*one), 1);
}

// Boxes in boxes that touch nowhere: solid, hole, solid; and one beside them.
TEST(SolidBoundary, BoxesInBoxes) {
  Facets facets;
  facets.box({2, 2, 2}, {3, 3, 3});
  facets.box({1, 1, 1}, {4, 4, 4});
  facets.box({0, 0, 0}, {5, 5, 5});
  facets.box({7, 0, 0}, {8, 1, 1});
  const std::vector<Vector3d> holes{{1.5, 1.4, 1.3}, {100, 0, 0}};
  const auto boundary = solid_boundary(facets.points, facets.triangles, holes);
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->triangles.size(), 48u);
  EXPECT_DOUBLE_EQ(facets.volume(*boundary), 125 - 27 + 1 + 1);
  const auto solid = solid_boundary(facets.points, facets.triangles, {});
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->triangles.size(), 24u);  // those inside separate solids from solids
  EXPECT_DOUBLE_EQ(facets.volume(*solid), 125 + 1);
}

// 6 x 6 x 6 boxes with a box in each, and one box around all. Points of holes: one in the space between the
// boxes, and one in each inner box.
TEST(SolidBoundary, ManyParts) {
  Facets facets;
  std::vector<Vector3d> holes{{3.6, 3.7, 3.8}};
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z) {
        const Vector3d low(4 * x, 4 * y, 4 * z);
        facets.box(low, low + Vector3d(3, 3, 3));
        facets.box(low + Vector3d(1, 1, 1), low + Vector3d(2, 2, 2));
        holes.push_back(low + Vector3d(1.4, 1.5, 1.6));
      }
  facets.box({-1, -1, -1}, {24, 24, 24});
  const auto boundary = solid_boundary(facets.points, facets.triangles, holes);
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->triangles.size(), 216u * 24);  // the outermost box separates two empty cells
  EXPECT_NEAR(facets.volume(*boundary), 216 * (27 - 1), 1e-9);
  EXPECT_FALSE(are_solid_boundary(facets.points, facets.triangles, holes));
  const auto solid = solid_boundary(facets.points, facets.triangles, {});
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(facets.volume(*solid), 25 * 25 * 25);
}

// A cavity and an inner wall, at scales whose cubes are no doubles.
TEST(SolidBoundary, AtEveryScale) {
  for (const int exponent : {-600, -400, 400, 600}) {
    Facets facets;
    facets.box({1, 1, 1}, {2, 2, 2});
    facets.box({0, 0, 0}, {3, 3, 3});
    facets.box({3, 0, 0}, {5, 3, 3}, {0});
    std::vector<Vector3d> points = facets.points, holes{{1.2, 1.3, 1.4}};
    for (Vector3d& p : points) p *= std::ldexp(1, exponent);
    for (Vector3d& p : holes) p *= std::ldexp(1, exponent);
    const auto boundary = solid_boundary(points, facets.triangles, holes);
    ASSERT_TRUE(boundary) << exponent;
    EXPECT_DOUBLE_EQ(facets.volume(*boundary), 45 - 1) << exponent;
    EXPECT_EQ(boundary->triangles.size(), 12u + 20u) << exponent;
  }
}

TEST(SolidBoundary, KnowsItself) {
  Facets facets;
  facets.box({0, 0, 0}, {1, 2, 3});
  facets.box({4, 0, 0}, {5, 1, 1});
  EXPECT_FALSE(are_solid_boundary(facets.points, facets.triangles, {}));
  facets.triangles = solid_boundary(facets.points, facets.triangles, {})->triangles;
  EXPECT_TRUE(are_solid_boundary(facets.points, facets.triangles, {}));
  EXPECT_FALSE(are_solid_boundary(facets.points, facets.triangles, std::vector<Vector3d>{{0.4, 0.5, 0.6}}));
  facets.triangles.pop_back();
  EXPECT_FALSE(are_solid_boundary(facets.points, facets.triangles, {}));
}

TEST(SolidBoundary, DanglingFacetsAndOpenSurfaces) {
  Facets facets;
  facets.box({0, 0, 0}, {1, 1, 1});
  facets.quadrangle({0, 0, 1}, {0, 1, 1}, {0, 1, 2}, {0, 0, 2});  // a fin on an edge
  const auto boundary = solid_boundary(facets.points, facets.triangles, {});
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->triangles.size(), 12u);
  Facets open;
  open.box({0, 0, 0}, {1, 1, 1}, {5});
  EXPECT_FALSE(solid_boundary(open.points, open.triangles, {}));
  open.triangles.push_back({0, 0, 1});
  EXPECT_FALSE(solid_boundary(open.points, open.triangles, {}));
}

TEST(SolidBoundary, OfAPolyWithItsNumbers) {
  const test::TestFiles files;
  // Two prisms with a wall between them, which is facet 1; facet 2 is wound inwards.
  const std::string text =
      "8 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 0 0 1\n6 1 0 1\n7 0 1 1\n8 1 1 1\n9 0\n"
      "1\n4 2 3 7 6\n1\n3 1 2 3\n1\n3 2 3 4\n1\n3 5 6 7\n1\n3 6 7 8\n1\n4 1 2 6 5\n1\n4 1 3 7 5\n1\n4 2 4 8 "
      "6\n1\n4 3 4 8 7\n"
      "0\n0\n";
  const SurfaceFile read = read_surface_file(files.write("a.poly", text));
  EXPECT_EQ(read.surface.triangles.size(), 12u);
  EXPECT_EQ(read.numbering.triangle(0), 2);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(
      read.warnings[0].find("the surface of the solids: 2 triangles inside of them or of holes left out, "),
      std::string::npos)
      << read.warnings[0];
}

// A box of two regions with a slot in its side and a cavity, as Debian's package tetgen brings it.
TEST(SolidBoundary, OfTetgensExample) {
  const std::string path = "/usr/share/doc/tetgen/examples/example.poly";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "tetgen is not installed";
  const TriangleSurface surface = read_surface(path);
  EXPECT_EQ(surface.triangles.size(), 48u);
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles)
    volume +=
        surface.vertices[static_cast<std::size_t>(a)].dot(surface.vertices[static_cast<std::size_t>(b)].cross(
            surface.vertices[static_cast<std::size_t>(c)])) /
        6;
  // By hand: the box 2 x 2 x 5, the cavity 1.5 x 1.25 x 0.5, the slot 1.5 x 1.5 x 0.5.
  EXPECT_DOUBLE_EQ(volume, 20 - 0.9375 - 1.125);
}

}  // namespace
}  // namespace tetproof::io
