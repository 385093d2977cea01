// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as near a triangle, by the triangle's own size; and the exact tests for what touches.
#include "verify/triangles/near_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "verify/triangles/touching.hpp"

namespace tetproof::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using verify::Near;
using verify::Triangle;

// A right triangle with sides 3, 4, 5, and beyond it a point at this height over its corner 0.
struct Scene {
  Points points;
  std::vector<Triangle> triangles{{0, 1, 2}};
  std::vector<Index> opposite{3};
};
Scene scene(double height, const Eigen::Vector3d& at = {0, 0, 0}) {
  return {{at, at + Eigen::Vector3d(3, 0, 0), at + Eigen::Vector3d(0, 4, 0),
           at + Eigen::Vector3d(0, 0, -height)}};
}

TEST(Near, ATrianglesRoomComesFromItsLongestEdge) {
  const Scene s = scene(1);
  EXPECT_DOUBLE_EQ(Near(s.points, s.triangles).room(0), 5e-12);
  EXPECT_DOUBLE_EQ(Near(s.points, s.triangles, s.opposite).room(0), 5e-12);
  EXPECT_DOUBLE_EQ(Near(s.points, s.triangles).size(0), 5);
}

TEST(Near, OrFromTheLastPlaceOfItsCoordinates) {
  const Scene s = scene(1, {0x1p30, -0x1p34, 0});
  EXPECT_DOUBLE_EQ(Near(s.points, s.triangles, s.opposite).room(0), 4 * 0x1p-52 * 0x1p34);
}

TEST(Near, ButNotFromMoreThanAThousandthOfItsTetrahedronsHeight) {
  // The corner over the right angle is the lowest: its height over the triangle is the tetrahedron's
  // smallest.
  const Scene s = scene(1e-10);
  EXPECT_NEAR(Near(s.points, s.triangles, s.opposite).room(0), 1e-13, 1e-20);
  EXPECT_DOUBLE_EQ(Near(s.points, s.triangles).room(0), 5e-12) << "without tetrahedra";
  // A needle: its smallest height is 12 / 5 thousandths of 1e-10.
  const Scene needle{{{0, 0, 0}, {4, 0, 0}, {0, 3e-10, 0}, {0, 0, -1}}};
  EXPECT_NEAR(Near(needle.points, needle.triangles).room(0), 3e-13, 1e-18);
}

TEST(Near, DistancesAreTheSameAtEveryScale) {
  // Over the inside, beside an edge, beyond a corner.
  for (const auto& [p, distance] : {std::pair{Eigen::Vector3d(1, 1, 0.25), 0.25},
                                    {Eigen::Vector3d(1, -0.5, 0), 0.5},
                                    {Eigen::Vector3d(-3, -4, 12), 13.0}})
    for (const int k : {-1000, -540, -300, 0, 300, 511, 1000}) {
      Points points{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, p};
      for (Eigen::Vector3d& q : points)
        for (int i = 0; i < 3; ++i) q[i] = std::ldexp(q[i], k);
      const std::vector<Triangle> triangles{{0, 1, 2}};
      EXPECT_DOUBLE_EQ(Near(points, triangles).to_triangle(3, 0), std::ldexp(distance, k)) << k;
    }
}

TEST(Near, WhereDoublesCannotMeasureOnlyWhatTouchesIsNear) {
  // The tetrahedron is 2^-60 thick. So its room is far below what doubles resolve at the size of the
  // triangle.
  Points points{{0, 0, 0},       {1, 0, 0},        {0, 1, 1},
                {0, 0, 0x1p-60}, {0.25, 0.5, 0.5}, {0.25, 0.5, 0.5 + 0x1p-53}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const std::vector<Index> opposite{3};
  const Near near(points, triangles, opposite);
  ASSERT_LT(near.room(0), 1e-20);
  EXPECT_TRUE(near.on_triangle(4, 0));
  EXPECT_FALSE(near.on_triangle(5, 0));
  EXPECT_TRUE(near.on_plane(4, 0));
  EXPECT_FALSE(near.on_plane(5, 0));
  EXPECT_TRUE(Near(points, triangles).on_triangle(5, 0)) << "without the tetrahedron";
}

TEST(Near, CoordinatesAtTheEndOfDoublesAreMeasured) {
  const double most = std::numeric_limits<double>::max();
  const Points points{{-most, 0, 0}, {most, 0, 0}, {0, most, 0}, {0, 1, most / 2}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const Near near(points, triangles);
  EXPECT_TRUE(std::isfinite(near.room(0)));
  EXPECT_DOUBLE_EQ(near.to_triangle(3, 0), most / 2);
}

TEST(Touching, IsExact) {
  const Eigen::Vector3d a(1, 1, 1), b(4, 7, 10), on(2, 3, 4), off(2, 3, std::nextafter(4, 5)),
      beyond(5, 9, 13);
  EXPECT_TRUE(verify::touches_segment(on, {a, b}));
  EXPECT_TRUE(verify::touches_segment(a, {a, b}));
  EXPECT_FALSE(verify::touches_segment(off, {a, b}));
  EXPECT_FALSE(verify::touches_segment(beyond, {a, b}));
  EXPECT_TRUE(verify::touches_segment(a, {a, a}));
  EXPECT_FALSE(verify::touches_segment(b, {a, a}));
  const Eigen::Vector3d aside(0, 3, 0);
  EXPECT_TRUE(verify::segments_touch({a, b}, {on, aside}));
  EXPECT_FALSE(verify::segments_touch({a, b}, {off, aside}));
  EXPECT_TRUE(verify::segments_touch({a, b}, {on, on}));
  EXPECT_FALSE(verify::segments_touch({a, b}, {beyond, aside}));
  EXPECT_TRUE(verify::touches_plane(on, {a, b, aside}));
  EXPECT_FALSE(verify::touches_plane(off, {a, b, aside}));
}

}  // namespace
}  // namespace tetproof::test
