// SPDX-License-Identifier: GPL-3.0-or-later
// Planes between sets of points: found where there are some, and never between hulls that meet.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "verify/triangles/separation.hpp"

namespace tetproof::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

Points cloud(std::mt19937_64& random, std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(uniform(random), uniform(random), uniform(random));
  return points;
}

TEST(Separated, CubesApartByMoreThanTheSlack) {
  Points a, b;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) a.emplace_back(x, y, z), b.emplace_back(x + 1.25, y, z);
  EXPECT_TRUE(verify::separated(a, b, 0.2499));
  EXPECT_FALSE(verify::separated(a, b, 0.25));
  EXPECT_FALSE(verify::separated(a, b, 0.2501));
}

TEST(Separated, ThinSetsSideBySide) {
  // Long, and a millionth of their length apart.
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(6 * uniform(random), cloud(random, 1)[0].normalized()).toRotationMatrix();
    Points a, b;
    for (Points* set : {&a, &b})
      for (int k = 0; k < 20; ++k)
        set->push_back(turn * Eigen::Vector3d(uniform(random), 1e-6 * (uniform(random) + (set == &a ? 0 : 2)),
                                              1e-3 * uniform(random)));
    EXPECT_TRUE(verify::separated(a, b, 1e-9));
    EXPECT_TRUE(verify::separated(b, a, 1e-9));
  }
}

TEST(Separated, NeverIfTheHullsMeet) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    // The second set has the middle of two points of the first, exactly, and so has the first's hull.
    Points a = cloud(random, 2 + random() % 6), b = cloud(random, random() % 6);
    for (Points* set : {&a, &b})
      for (Eigen::Vector3d& p : *set) p = (1024 * p).array().floor();
    for (Eigen::Vector3d& p : b) p += (a[0] + a[1]) / 2 - (i % 2 ? b[0] : Eigen::Vector3d(p.z(), 0, 0));
    b.push_back((a[0] + a[1]) / 2);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 800) - 400);
    for (Points* set : {&a, &b})
      for (Eigen::Vector3d& p : *set) p *= scale;
    double largest = 0;
    for (const Points* set : {&a, &b})
      for (const Eigen::Vector3d& p : *set) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    EXPECT_FALSE(verify::separated(a, b, 0x1p-47 * largest));
    EXPECT_FALSE(verify::separated(b, a, 0x1p-47 * largest));
  }
}

TEST(Separated, FindsMostPlanes) {
  // A plane between the sets is found for nearly all, with a gap of a hundredth of their size.
  std::mt19937_64 random(3);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d normal = cloud(random, 1)[0].normalized();
    Points a = cloud(random, 30), b = cloud(random, 30);
    double high = -10, low = 10;
    for (const Eigen::Vector3d& p : a) high = std::max(high, normal.dot(p));
    for (const Eigen::Vector3d& p : b) low = std::min(low, normal.dot(p));
    for (Eigen::Vector3d& p : b) p += (high - low + 0.01) * normal;
    found += verify::separated(a, b, 1e-12);
  }
  EXPECT_GT(found, 990);
}

}  // namespace
}  // namespace tetproof::test
