// SPDX-License-Identifier: GPL-3.0-or-later
// Exact volumes against another kind of rational arithmetic, tetrahedron by tetrahedron.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "tests/support/meshes.hpp"
#include "verify/surface.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational exact_volume(const TetMesh& mesh) {
  Rational sum = 0;
  for (const auto& tet : mesh.tets) {
    std::array<std::array<Rational, 3>, 4> p;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) p[i][k] = Rational(mesh.points[tet[i]][k]);
    for (int i = 1; i < 4; ++i)
      for (int k = 0; k < 3; ++k) p[i][k] -= p[0][k];
    sum += p[1][0] * (p[2][1] * p[3][2] - p[2][2] * p[3][1]) -
           p[1][1] * (p[2][0] * p[3][2] - p[2][2] * p[3][0]) +
           p[1][2] * (p[2][0] * p[3][1] - p[2][1] * p[3][0]);
  }
  return sum / 6;
}

// Expects that no double is nearer.
void expect_nearest(double value, const Rational& exact) {
  ASSERT_TRUE(std::isfinite(value));
  const Rational error = abs(Rational(value) - exact);
  EXPECT_LE(error, abs(Rational(std::nextafter(value, INFINITY)) - exact));
  EXPECT_LE(error, abs(Rational(std::nextafter(value, -INFINITY)) - exact));
}

TetMesh shaken(double scale, double shift, std::uint64_t seed) {
  TetMesh mesh = lattice_mesh({3, 2, 2}, {}, {shift, shift, shift}, scale);
  std::mt19937_64 random(seed);
  for (auto& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] += 0.2 * scale * static_cast<double>(random() >> 11) * 0x1p-53;
  return mesh;
}

TEST(ExactVolume, IsTheNearestDouble) {
  for (const auto& [scale, shift] :
       {std::pair{1.0, 0.0}, {1.0, 1e6}, {1e-9, 0.0}, {1e-9, 1.0}, {1e6, 1e6}, {1e-60, 0.0}, {1e90, 0.0}})
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(testing::Message() << scale << " at " << shift << ", seed " << seed);
      const TetMesh mesh = shaken(scale, shift, seed);
      const Rational exact = exact_volume(mesh);
      expect_nearest(*verify::verify(mesh).mesh.volume, exact);
      const TriangleSurface surface = boundary_surface(mesh);
      const verify::SurfaceReport report = verify::judge_surface(surface);
      ASSERT_EQ(report.fault, "");
      expect_nearest(report.volume, exact);
    }
}

TEST(ExactVolume, CountsWhatDoesNotMatchToo) {
  TetMesh mesh = shaken(1, 0, 7);
  mesh.tets.push_back(mesh.tets[3]);
  std::swap(mesh.tets[20][0], mesh.tets[20][1]);
  std::swap(mesh.tets[0][2], mesh.tets[0][3]);
  expect_nearest(*verify::verify(mesh).mesh.volume, exact_volume(mesh));
}

TEST(ExactVolume, OfNestedShellsByParity) {
  const TriangleSurface outer = box_surface({0, 0, 0}, 4), middle = box_surface({1, 1, 1}, 2),
                        inner = box_surface({1.5, 1.5, 1.5}, 1);
  const double volume = 64 - 8 + 1;
  for (const auto& surface :
       {together(together(outer, flipped(middle)), inner), together(together(inner, outer), flipped(middle)),
        flipped(together(together(outer, flipped(middle)), inner))}) {
    const verify::SurfaceReport report = verify::judge_surface(surface);
    ASSERT_EQ(report.fault, "");
    EXPECT_EQ(report.volume, volume);
    EXPECT_EQ(report.components.size(), 3u);
    EXPECT_EQ(report.cavities(), 1);
  }
}

}  // namespace
}  // namespace tetproof::test
