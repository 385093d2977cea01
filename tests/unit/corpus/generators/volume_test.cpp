// SPDX-License-Identifier: GPL-3.0-or-later
// The stated volumes of generated bodies against closed forms and against triangulations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "corpus/generators/quadrature.hpp"
#include "corpus/surfaces.hpp"
#include "tests/support/surface_facts.hpp"

namespace tetproof::corpus {
namespace {

constexpr double pi = std::numbers::pi;

// The NACA thickness integrated term by term: 10 t (0.2969 2/3 - 0.1260 / 2 - 0.3516 / 3 + 0.2843 / 4 -
// 0.1036 / 5).
const double naca_area_per_thickness =
    10 * (0.2969 * 2 / 3 - 0.1260 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1036 / 5);

TEST(ExactVolume, ClosedForms) {
  const struct {
    const char* spec;
    double volume;
  } cases[] = {
      {"sphere", 4 * pi / 3},
      {"sphere:r=2,n=8,x=1", 32 * pi / 3},
      {"torus", 2 * pi * pi * 0.16},
      {"torus:R=3,r=0.5", 2 * pi * pi * 3 * 0.25},
      {"wing", naca_area_per_thickness * 0.12 * 3},
      {"wing:naca=0024,chord=2,span=5", naca_area_per_thickness * 0.24 * 4 * 5},
      {"random:roughness=0,r=2", 32 * pi / 3},
      {"shells", 4 * pi / 3 * (1 - 0.125)},
      {"shells:count=3,inner=0.5", 4 * pi / 3 * (1 - 0.421875 + 0.125)},
      {"octahedron:rx=2,ry=3,rz=0.5", 4},
      {"box:x0=-1,x1=3,y1=0.5", 2},
      {"groove:m=6,depth=2,width=1,h=0.5", (216 - 12) / 8.0},
      {"hollow:m=6,wall=0.5", 216 - 125},
      {"bottle:m=6,wall=1,neck=0.5", 216 - 64 - 0.25},
      {"pair:m=3", 54},
  };
  for (const auto& c : cases) EXPECT_NEAR(exact_volume(c.spec).value() / c.volume, 1, 1e-14) << c.spec;
}

TEST(ExactVolume, OfPolyhedraIsTheirSurfaces) {
  for (const char* spec :
       {"octahedron:rx=0.3", "box:x0=-0.1,n=5", "groove:m=7,width=2,h=0.3", "terrain:seed=3,m=12",
        "hollow:wall=0.01", "bottle:neck=0.01,n=2", "pair:gap=0.125,x=7"})
    EXPECT_NEAR(static_cast<double>(test::signed_volume(make_surface(spec))) / exact_volume(spec).value(), 1,
                1e-13)
        << spec;
}

// The volume of an inscribed triangulation of a smooth body is off by c h^2 + O(h^4) with h^2 ~ 1/n. A
// triangulation with four times as many triangles has a quarter of the error, and extrapolating from the last
// two leaves much less than either.
TEST(ExactVolume, TriangulationsConvergeAtSecondOrder) {
  for (const char* body :
       {"sphere:", "torus:", "torus:R=2,r=1.5,", "wing:", "wing:naca=4412,", "wing:naca=9525,span=1,",
        "random:seed=7,", "random:seed=3,roughness=0.9,", "shells:count=3,"}) {
    double error[3], size[3];
    for (int i = 0; i < 3; ++i) {
      const std::string spec = body + std::string("n=") + std::to_string(10000 << (2 * i));
      const TriangleSurface surface = make_surface(spec);
      size[i] = static_cast<double>(surface.triangles.size());
      error[i] = static_cast<double>(test::signed_volume(surface)) / exact_volume(spec).value() - 1;
      RecordProperty(spec, std::to_string(error[i]));
    }
    for (int i = 0; i < 2; ++i) {
      const double order = std::log(error[i] / error[i + 1]) / std::log(std::sqrt(size[i + 1] / size[i]));
      EXPECT_NEAR(order, 2, 0.12) << body;
    }
    const double ratio = size[2] / size[1];
    EXPECT_NEAR((ratio * error[2] - error[1]) / (ratio - 1), 0, 0.03 * std::abs(error[2])) << body;
  }
}

TEST(Quadrature, GaussIsExactForPolynomialsOfItsDegree) {
  for (const int n : {1, 2, 3, 5, 8, 64, 129}) {
    const GaussRule rule = gauss_legendre(n);
    for (int degree = 0; degree < 2 * n && degree < 60; ++degree) {
      Sum sum;
      for (int i = 0; i < n; ++i) sum.add(rule.weights[i] * std::pow(rule.nodes[i], degree));
      EXPECT_NEAR(sum.value() * (degree + 1), 1, 3e-14) << n << " nodes, degree " << degree;
    }
  }
  // Two nodes: (1 -+ 1/sqrt(3)) / 2
  const GaussRule two = gauss_legendre(2);
  EXPECT_NEAR(two.nodes[0], (1 - 1 / std::sqrt(3.0)) / 2, 1e-15);
  EXPECT_NEAR(two.weights[0], 0.5, 1e-15);
}

}  // namespace
}  // namespace tetproof::corpus
