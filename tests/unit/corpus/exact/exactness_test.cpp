// SPDX-License-Identifier: GPL-3.0-or-later
// Why the generators give the same on every machine: their own sine and cosine, and a random engine that the
// standard defines. Also coordinates known by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "corpus/generators/random.hpp"
#include "corpus/generators/turns.hpp"
#include "corpus/random_surface.hpp"
#include "corpus/surfaces.hpp"
#include "tests/support/surface_facts.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

TEST(Turns, NearTheTrueValues) {
  long double worst = 0;
  for (int i = -20000; i <= 20000; ++i) {
    const double t = i / 4999.0;
    const long double angle = 2 * std::numbers::pi_v<long double> * static_cast<long double>(t);
    worst = std::max({worst, std::abs(cos_sin_turns(t).cos - std::cos(angle)),
                      std::abs(cos_sin_turns(t).sin - std::sin(angle))});
  }
  EXPECT_LT(static_cast<double>(worst), 2.3e-16);
}

TEST(Turns, ExactAtQuartersAndOddAndPeriodic) {
  for (int turn = -3; turn <= 3; ++turn) {
    const double expected[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int quarter = 0; quarter < 4; ++quarter) {
      EXPECT_EQ(cos_sin_turns(turn + quarter / 4.0).cos, expected[quarter][0]);
      EXPECT_EQ(cos_sin_turns(turn + quarter / 4.0).sin, expected[quarter][1]);
    }
  }
  for (int i = 0; i < 1024; ++i) {
    const double t = i / 1024.0;
    EXPECT_EQ(cos_sin_turns(t).cos, cos_sin_turns(t + 5).cos);
    EXPECT_EQ(cos_sin_turns(t).sin, cos_sin_turns(t - 7).sin);
    EXPECT_EQ(cos_sin_turns(t).sin, -cos_sin_turns(-t).sin);
    EXPECT_EQ(cos_sin_turns(t).cos, cos_sin_turns(-t).cos);
    // At odd multiples of 1/8 one of the two is computed as a cosine, the other one as a sine.
    if (i % 256 != 128) {
      EXPECT_EQ(cos_sin_turns(t + 0.25).cos, -cos_sin_turns(t).sin);
    }
  }
}

TEST(Random, IsTheStandardsEngine) {
  // [rand.predef]: the 10000th number of a default-constructed mt19937_64, whose seed is 5489, is
  // 9981545732273789042.
  Random random(5489);
  for (int i = 0; i < 9999; ++i) random.unit();
  EXPECT_EQ(random.unit(), static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
}

TEST(Coordinates, OfTheSmallestSphereByHand) {
  const TriangleSurface surface = make_surface("sphere:r=2,n=8,x=1,y=10,z=100");
  std::set<std::array<double, 3>> found,
      expected{{3, 10, 100}, {-1, 10, 100}, {1, 12, 100}, {1, 8, 100}, {1, 10, 102}, {1, 10, 98}};
  for (const Eigen::Vector3d& v : surface.vertices) found.insert({v[0], v[1], v[2]});
  EXPECT_EQ(found, expected);
}

TEST(Coordinates, OfATorusAtQuarterTurnsByHand) {
  const TriangleSurface surface = make_surface("torus:R=2,r=0.5");
  const struct {
    double u, v;
    Eigen::Vector3d point;
  } cases[] = {{0, 0, {2.5, 0, 0}},       {0.25, 0, {0, 2.5, 0}},      {1, 0.5, {1.5, 0, 0}},
               {0.5, 0.25, {-2, 0, 0.5}}, {0.75, 0.75, {0, -2, -0.5}}, {0, 1, {2.5, 0, 0}}};
  for (const auto& c : cases) EXPECT_EQ(surface.evaluate({c.u, c.v}), c.point) << c.u << ' ' << c.v;
}

TEST(Coordinates, OfAWingByHand) {
  const TriangleSurface surface = make_surface("wing:naca=2412,chord=2,span=6,x=1,y=1,z=1");
  EXPECT_EQ(surface.evaluate({0, 0}), Eigen::Vector3d(1, 1, 1));                   // leading edge
  EXPECT_LT((surface.evaluate({1, 1}) - Eigen::Vector3d(3, 7, 1)).norm(), 1e-15);  // trailing edge
  EXPECT_EQ(surface.evaluate({1, 0.5}), surface.evaluate({-1, 0.5}));              // sharp
  // At x = p = 0.4 the mean line is highest, m = 0.02, and level: the thickness is upright there, half of it
  // 0.058029855.
  const double u = 2 / std::numbers::pi * std::asin(std::sqrt(0.4));
  const double half =
      0.6 * (0.2969 * std::sqrt(0.4) - 0.126 * 0.4 - 0.3516 * 0.16 + 0.2843 * 0.064 - 0.1036 * 0.0256);
  EXPECT_LT((surface.evaluate({u, 0}) - Eigen::Vector3d(1.8, 1, 1 + 2 * (0.02 + half))).norm(), 1e-14);
  EXPECT_LT((surface.evaluate({-u, 1}) - Eigen::Vector3d(1.8, 7, 1 + 2 * (0.02 - half))).norm(), 1e-14);
}

TEST(Coordinates, OfLatticeBodiesAreTheLatticesOwn) {
  const double h = 0.1, x = 0.3;
  for (const char* spec : {"groove:m=9,h=0.1,x=0.3,y=0.3,z=0.3", "terrain:m=9,h=0.1,x=0.3,y=0.3,z=0.3"}) {
    std::set<double> lattice;
    for (int i = 0; i <= 9; ++i) lattice.insert(x + h * i);
    for (const Eigen::Vector3d& v : make_surface(spec).vertices)
      for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(lattice.contains(v[axis])) << spec;
  }
}

TEST(RandomStar, RadiusStaysWithinItsBounds) {
  for (const double roughness : {0.1, 0.5, 0.9}) {
    const TriangleSurface surface =
        make_surface("random:seed=11,r=3,waves=3,roughness=" + std::to_string(roughness));
    double least = INFINITY, most = 0;
    for (const Eigen::Vector3d& v : surface.vertices) {
      least = std::min(least, v.norm());
      most = std::max(most, v.norm());
    }
    EXPECT_GE(least, 3 * (1 - roughness) * (1 - 1e-15));
    EXPECT_LE(most, 3 * (1 + roughness) * (1 + 1e-15));
    EXPECT_GT(most - least, 0.5 * roughness);  // the surface is rough indeed
  }
}

TEST(RandomStar, AnotherSeedIsAnotherBody) {
  EXPECT_NE(make_surface("random:seed=1").vertices, make_surface("random:seed=2").vertices);
}

TEST(RandomClosedSurface, IsUsableForEverySeed) {
  int nested = 0, several = 0, inward = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const TriangleSurface surface = random_closed_surface(seed);
    const test::SurfaceFacts facts = test::facts(surface);
    const verify::SurfaceReport report = verify::judge_surface(surface);
    ASSERT_EQ(report.fault, "") << "seed " << seed << ": " << describe_random_surface(seed);
    ASSERT_TRUE(facts.closed_and_oriented && facts.one_fan_per_vertex) << seed;
    ASSERT_LE(surface.triangles.size(), 4000u) << seed;
    several += facts.components > 1;
    nested += report.cavities() > 0;
    inward += facts.volume < 0;
    EXPECT_EQ(surface.vertices, random_closed_surface(seed).vertices);
  }
  EXPECT_GT(several, 100);  // two kinds of five
  EXPECT_GT(nested, 40);
  EXPECT_GT(inward, 20);
}

}  // namespace
}  // namespace tetproof::corpus
