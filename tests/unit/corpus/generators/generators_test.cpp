// SPDX-License-Identifier: GPL-3.0-or-later
// Every generated surface keeps its promise: it is closed, manifold, oriented outward and embedded, and its
// topology and volume are known.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "corpus/surfaces.hpp"
#include "tests/support/surface_facts.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

struct Case {
  const char* spec;
  std::size_t triangles;
  int euler, components;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.spec;
}

// Counts by hand: 8 f^2, 2 nu nv, 4 k nv + 8 k - 8, twice the squares of the boundary.
const Case cases[] = {
    {"sphere", 5000, 2, 1},
    {"sphere:n=8", 8, 2, 1},
    {"sphere:n=20", 8, 2, 1},
    {"sphere:n=21", 32, 2, 1},  // half way between 8 and 32
    {"sphere:r=1e-9,n=200,x=1e-3", 200, 2, 1},
    {"sphere:r=1e9,n=32,z=-1e12", 32, 2, 1},
    {"torus", 4992, 0, 1},
    {"torus:n=18", 18, 0, 1},
    {"torus:n=18,r=0.999", 18, 0, 1},
    {"torus:R=2,r=0.002,n=600", 600, 0, 1},
    {"torus:n=26000", 26064, 0, 1},
    {"wing", 5032, 2, 1},
    {"wing:n=20", 24, 2, 1},
    {"wing:naca=4412,n=2000", 2020, 2, 1},
    {"wing:naca=0001,span=0.001,n=1000", 1000, 2, 1},
    {"wing:naca=2450,chord=2,span=9,x=-3,y=7,z=1", 4984, 2, 1},
    {"random", 5000, 2, 1},
    {"random:seed=7,n=8,roughness=0.9,waves=4", 8, 2, 1},
    {"random:seed=9007199254740992,roughness=0.9,waves=4", 5000, 2, 1},
    {"random:roughness=0,n=72", 72, 2, 1},
    {"shells", 5184, 4, 2},
    {"shells:n=16,inner=0.1", 16, 4, 2},
    {"shells:count=8,n=20000", 20736, 16, 8},
    {"octahedron", 8, 2, 1},
    {"octahedron:rx=1.5,ry=0.5,rz=2.5,x=3,y=-1", 8, 2, 1},
    {"box", 12, 2, 1},
    {"box:n=7,x0=-1,x1=1e-3", 588, 2, 1},
    {"groove", 472, 2,
     1},  // 2 (6 * 36 + 2 * 2 * 6 - 2 * 2 * 1): the groove's walls are added, its two open ends subtracted
    {"groove:m=3,width=1,depth=1,n=2", 464, 2, 1},
    {"hollow", 120, 4, 2},
    {"hollow:wall=1e-6,h=0.125", 120, 4, 2},
    {"bottle", 284, 2, 1},
    {"pair", 24, 4, 2},
    {"pair:gap=1e-6,n=3", 216, 4, 2},
};

class Generated : public testing::TestWithParam<Case> {};

TEST_P(Generated, IsClosedManifoldOutwardAndEmbedded) {
  const Case& c = GetParam();
  const TriangleSurface surface = make_surface(c.spec);
  EXPECT_EQ(surface.triangles.size(), c.triangles);
  const test::SurfaceFacts facts = test::facts(surface);
  EXPECT_TRUE(facts.closed_and_oriented);
  EXPECT_TRUE(facts.one_fan_per_vertex);
  EXPECT_EQ(facts.euler, c.euler);
  EXPECT_EQ(facts.components, c.components);
  EXPECT_GT(facts.volume, 0);

  const verify::SurfaceReport report = verify::judge_surface(surface);
  EXPECT_EQ(report.fault, "");
  EXPECT_TRUE(report.notes.empty());  // no shell has the wrong orientation
  EXPECT_EQ(report.components.size(), static_cast<std::size_t>(c.components));
}

TEST_P(Generated, VerticesAreWhatTheParametersGive) {
  const TriangleSurface surface = make_surface(GetParam().spec);
  EXPECT_EQ(surface.parameters.empty(), !surface.evaluate);
  if (surface.parameters.empty()) return;
  ASSERT_EQ(surface.parameters.size(), surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3d evaluated = surface.evaluate(surface.parameters[t][corner]);
      const Eigen::Vector3d& stored = surface.vertices[surface.triangles[t][corner]];
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(evaluated[axis]), std::bit_cast<std::uint64_t>(stored[axis]))
            << "triangle " << t << " corner " << corner;
    }
}

// The midpoint of an edge in (u,v) is close to its midpoint in space, so no corner is on the wrong side of a
// seam.
TEST_P(Generated, NoTriangleStraddlesASeam) {
  const TriangleSurface surface = make_surface(GetParam().spec);
  for (std::size_t t = 0; t < surface.parameters.size(); ++t) {
    std::array<Eigen::Vector3d, 3> x;
    for (int corner = 0; corner < 3; ++corner) x[corner] = surface.vertices[surface.triangles[t][corner]];
    const double longest = std::max({(x[0] - x[1]).norm(), (x[1] - x[2]).norm(), (x[2] - x[0]).norm()});
    for (int corner = 0; corner < 3; ++corner) {
      const int next = (corner + 1) % 3;
      const Eigen::Vector3d middle =
          surface.evaluate((surface.parameters[t][corner] + surface.parameters[t][next]) / 2);
      ASSERT_LT((middle - (x[corner] + x[next]) / 2).norm(), 1.3 * longest)
          << "triangle " << t << " corner " << corner;
    }
  }
}

TEST_P(Generated, TwiceTheSame) {
  const TriangleSurface one = make_surface(GetParam().spec), two = make_surface(GetParam().spec);
  EXPECT_EQ(one.vertices, two.vertices);
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_EQ(one.parameters, two.parameters);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Generated, testing::ValuesIn(cases), [](const auto& instance) {
  std::string name = std::to_string(instance.index) + "_";
  for (char c : std::string(instance.param.spec))
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

TEST(Generators, ManySeedsAndSectionsAreEmbedded) {
  std::vector<std::string> specs;
  for (int seed = 0; seed < 20; ++seed) {
    specs.push_back("random:n=300,roughness=0.9,waves=4,seed=" + std::to_string(seed));
    specs.push_back("terrain:m=5,seed=" + std::to_string(seed));
    specs.push_back("terrain:m=9,n=2,h=0.25,x=-1,seed=" + std::to_string(seed));
  }
  for (const char* section :
       {"0001", "0012", "0050", "1112", "2412", "2450", "4425", "6525", "9106", "9110", "9525", "9910"})
    for (const char* n : {"20", "200", "1000", "5000"})
      specs.push_back(std::string("wing:naca=") + section + ",n=" + n);
  for (const std::string& spec : specs) {
    const TriangleSurface surface = make_surface(spec);
    EXPECT_EQ(verify::judge_surface(surface).fault, "") << spec;
    EXPECT_TRUE(test::facts(surface).one_fan_per_vertex) << spec;
  }
}

TEST(Generators, AMillionTriangles) {
  for (const char* spec :
       {"sphere:n=1000000", "torus:n=1000000", "wing:n=1000000", "random:n=1000000", "box:n=289"}) {
    const TriangleSurface surface = make_surface(spec);
    EXPECT_NEAR(static_cast<double>(surface.triangles.size()), 1e6, 1e4) << spec;
    EXPECT_EQ(surface.vertices.size(), surface.triangles.size() / 2 + (spec[0] == 't' ? 0 : 2)) << spec;
    EXPECT_NEAR(static_cast<double>(test::signed_volume(surface)) / *exact_volume(spec), 1, 1e-4) << spec;
  }
}

}  // namespace
}  // namespace tetproof::corpus
