// SPDX-License-Identifier: GPL-3.0-or-later
// What the kinds of random surfaces are built with: exact sides, hulls, polygons, volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "corpus/fuzz/exact_sides.hpp"
#include "corpus/fuzz/hull.hpp"
#include "corpus/fuzz/polygon.hpp"
#include "corpus/fuzz/shape.hpp"
#include "io/error.hpp"
#include "tests/support/exact_mesh.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

using exact_mesh::exact;
using exact_mesh::Rational;

TEST(ExactSides, AgreeWithRationalNumbersWhereDoublesFail) {
  std::mt19937_64 random(3);
  int flat = 0;
  for (int i = 0; i < 2000; ++i) {
    // Points of a plane, each moved by a few units in the last place at most.
    const auto number = [&] { return static_cast<double>(random() % 16) / 16 + 1; };
    std::array<Eigen::Vector3d, 4> p;
    for (Eigen::Vector3d& q : p) {
      const double x = number(), y = number();
      q = {x, y, x + y + static_cast<double>(random() % 3) * 0x1p-51};
    }
    const Rational volume = exact_mesh::volume6(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
    const int sign = volume > 0 ? 1 : volume < 0 ? -1 : 0;
    flat += sign == 0;
    ASSERT_EQ(side(p[0], p[1], p[2], p[3]), sign);
    for (Eigen::Vector3d& q : p) q *= 0x1p-200;  // products underflow
    ASSERT_EQ(side(p[0], p[1], p[2], p[3]), sign);
  }
  EXPECT_GT(flat, 50);
  EXPECT_EQ(turn({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(turn({0, 0}, {3, 0.3}, {1, 0.1}), side({0, 0, 0}, {3, 0.3, 0}, {1, 0.1, 0}, {0, 0, 1}));
}

TEST(ConvexHull, OfLatticePointsInAnyOrder) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, i / 3 % 3, i / 9);
  std::mt19937_64 random(1);
  for (int order = 0; order < 50; ++order) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
    const TriangleSurface hull = convex_hull(points);
    const verify::SurfaceReport report = verify::judge_surface(hull);
    EXPECT_EQ(report.fault, "");
    EXPECT_EQ(report.volume, 8);  // a cube of edge 2: nothing is cut off
    EXPECT_EQ(report.components.size(), 1u);
  }
}

TEST(ConvexHull, HasNoPointOutside) {
  std::mt19937_64 random(2);
  for (int set = 0; set < 20; ++set) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 40; ++i)
      points.emplace_back(static_cast<double>(random() % 5), static_cast<double>(random() % 5),
                          static_cast<double>(random() % 1000) / 7);
    const TriangleSurface hull = convex_hull(points);
    EXPECT_EQ(verify::judge_surface(hull).fault, "");
    for (const auto& [a, b, c] : hull.triangles)
      for (const Eigen::Vector3d& p : points)
        ASSERT_LE(exact_mesh::volume6(exact(hull.vertices[a]), exact(hull.vertices[b]),
                                      exact(hull.vertices[c]), exact(p)),
                  0);
  }
}

TEST(ConvexHull, OfPointsInOnePlaneIsRefused) {
  EXPECT_THROW(convex_hull({}), InputError);
  EXPECT_THROW(convex_hull({{1, 1, 1}, {1, 1, 1}}), InputError);
  EXPECT_THROW(convex_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), InputError);
  EXPECT_THROW(convex_hull({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {3, 4, 7}}), InputError);
}

TEST(Polygon, IsCutWithoutDegenerateTriangles) {
  // A U with vertices in the middle of its sides.
  const std::vector<Eigen::Vector2d> u{{0, 0}, {1.5, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1.5},
                                       {2, 1}, {1, 1},   {1, 2}, {0, 2}, {0, 1}};
  const auto triangles = cut_polygon(u);
  EXPECT_EQ(triangles.size(), u.size() - 2);
  for (const auto& [a, b, c] : triangles) EXPECT_EQ(turn(u[a], u[b], u[c]), 1);
  EXPECT_EQ(verify::judge_surface(prism(u, 2)).volume, 10);
  EXPECT_THROW(cut_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError);
}

TEST(EnclosedVolume, IsTheExactValueRoundedOnce) {
  TriangleSurface box = box_surface({0.1, 0.2, 0.3}, {0.7, 1e6, 1e-9 + 0.3});
  Rational six_times = 0;
  for (const auto& [a, b, c] : box.triangles)
    six_times += exact_mesh::volume6(exact({0, 0, 0}), exact(box.vertices[a]), exact(box.vertices[b]),
                                     exact(box.vertices[c]));
  const double volume = enclosed_volume(box);
  EXPECT_EQ(volume, verify::judge_surface(box).volume);
  // No neighbour is nearer.
  const Rational off = abs(Rational(six_times / 6 - Rational(volume)));
  for (const double other : {std::nextafter(volume, 0.0), std::nextafter(volume, 2 * volume)})
    EXPECT_LT(off, abs(Rational(six_times / 6 - Rational(other))));
  TriangleSurface inward;
  append(inward, box, {0, 0, 0}, true);
  EXPECT_EQ(enclosed_volume(inward), -volume);
}

}  // namespace
}  // namespace tetproof::corpus
