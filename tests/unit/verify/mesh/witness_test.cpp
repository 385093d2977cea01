// SPDX-License-Identifier: GPL-3.0-or-later
// Where tetrahedra overlap, the report's exact point lies strictly inside both, by another kind of rational
// arithmetic.
#include <gmock/gmock.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "tests/support/meshes.hpp"
#include "verify/mesh/witness.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;

Point exact(const Eigen::Vector3d& p) {
  return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}

Rational volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> m;
  for (int k = 0; k < 3; ++k) m[0][k] = b[k] - a[k], m[1][k] = c[k] - a[k], m[2][k] = d[k] - a[k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Whether the four parts into which the point cuts a tetrahedron all have its orientation.
bool strictly_inside(const TetMesh& mesh, Index t, const Point& p) {
  std::array<Point, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = exact(mesh.points[mesh.tets[t][i]]);
  const bool positive = volume(corners[0], corners[1], corners[2], corners[3]) > 0;
  for (int i = 0; i < 4; ++i) {
    auto part = corners;
    part[i] = p;
    const Rational v = volume(part[0], part[1], part[2], part[3]);
    if (positive ? v <= 0 : v >= 0) return false;
  }
  return true;
}

Point point_of(const std::array<std::string, 3>& text) {
  return {Rational(text[0]), Rational(text[1]), Rational(text[2])};
}

void expect_witness(const TetMesh& mesh, const verify::Finding& finding) {
  ASSERT_EQ(finding.tets.size(), 2u);
  EXPECT_NE(finding.tets[0], finding.tets[1]);
  ASSERT_FALSE(finding.point_exact[0].empty()) << finding.what;
  const Point p = point_of(finding.point_exact);
  EXPECT_TRUE(strictly_inside(mesh, finding.tets[0], p)) << finding.what;
  EXPECT_TRUE(strictly_inside(mesh, finding.tets[1], p)) << finding.what;
  ASSERT_TRUE(finding.point);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR((*finding.point)[k], static_cast<double>(p[k]), 1e-12 * (1 + std::abs((*finding.point)[k])));
}

TEST(Witness, OfEveryOverlapFound) {
  std::vector<TetMesh> meshes{
      together(lattice_mesh({3, 3, 3}), lattice_mesh({1, 1, 1}, {}, {1.25, 1.25, 1.25}, 0.5)),
      together(lattice_mesh({2, 2, 2}), lattice_mesh({2, 2, 2}, {}, {0, 0, 0}, 0.25)),
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 0.5}, {1, 0.5, 1}}, {{0, 1, 2, 3}, {0, 1, 4, 5}}},
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0.5, 0.5}, {0.5, 1, 0.5}, {0.5, 0.5, 1}},
       {{0, 1, 2, 3}, {0, 4, 5, 6}}}};
  for (const TetMesh& mesh : meshes) {
    const Report report = verify::verify(mesh);
    bool found = false;
    for (const verify::Finding& finding : report[Check::overlap].findings)
      expect_witness(mesh, finding), found = true;
    for (const verify::Finding& finding : report[Check::boundary_self_intersection].findings)
      if (!finding.point_exact[0].empty()) expect_witness(mesh, finding), found = true;
    EXPECT_TRUE(found) << report_text(report);
  }
}

TEST(Witness, BetweenOverlapsOfOneUnitInTheLastPlace) {
  // The tip of one tetrahedron lies in a face of the other, just before it, or just behind it. The common
  // part is so small that hardly any double lies in it.
  int found = 0;
  for (const double shift : {0.0, 1.0, 1e6}) {
    const double z = 0.7 + shift;
    for (const double tip : {std::nextafter(z, 1e9), z, std::nextafter(z, -1e9)}) {
      const TetMesh mesh{{{shift, shift, z},
                          {1 + shift, shift, z},
                          {shift, 1 + shift, z},
                          {shift, shift, z - 1},
                          {0.2 + shift, 0.2 + shift, tip},
                          {0.7 + shift, 0.2 + shift, z + 1},
                          {0.2 + shift, 0.7 + shift, z + 1},
                          {0.1 + shift, 0.1 + shift, z + 1}},
                         {{0, 2, 1, 3}, {4, 5, 6, 7}}};
      const Report report = verify::verify(mesh);
      ASSERT_EQ(report[Check::inverted].count, 0);
      const auto& meetings = report[Check::boundary_self_intersection];
      EXPECT_EQ(meetings.count > 0, tip <= z) << report_text(report);
      EXPECT_EQ(report[Check::near_contact].count > 0, tip > z) << report_text(report);
      for (const verify::Finding& finding : meetings.findings) {
        EXPECT_EQ(finding.point_exact[0].empty(), tip == z) << "touching they share no volume";
        if (tip < z) expect_witness(mesh, finding), ++found;
      }
    }
  }
  EXPECT_GT(found, 0);
}

TEST(Witness, OfRandomPairsJustWhereTheyShareVolume) {
  std::mt19937_64 random(4);
  int shared = 0, apart = 0;
  for (int i = 0; i < 80; ++i) {
    TetMesh mesh;
    const bool integers = i % 2 == 0;  // small integers give every special position
    for (int k = 0; k < 8; ++k) {
      Eigen::Vector3d p;
      for (int c = 0; c < 3; ++c)
        p[c] = integers ? static_cast<double>(random() % 4) : static_cast<double>(random() >> 11) * 0x1p-53;
      mesh.points.push_back(p);
    }
    mesh.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    const auto witness = verify::common_point(mesh.points, mesh.tets[0], mesh.tets[1]);
    if (witness) {
      ++shared;
      EXPECT_TRUE(strictly_inside(mesh, 0, point_of(witness->exact)));
      EXPECT_TRUE(strictly_inside(mesh, 1, point_of(witness->exact)));
      continue;
    }
    ++apart;
    // If they are apart, a plane through three of the points, or parallel to an edge of each, separates them.
    bool separated = false;
    std::array<Point, 8> p;
    for (int k = 0; k < 8; ++k) p[k] = exact(mesh.points[k]);
    const auto flat = [&](int a) { return volume(p[a], p[a + 1], p[a + 2], p[a + 3]) == 0; };
    const auto try_normal = [&](const Point& n) {
      if (n == Point{0, 0, 0}) return;
      Rational low[2], high[2];
      for (int k = 0; k < 8; ++k) {
        const Rational h = n[0] * p[k][0] + n[1] * p[k][1] + n[2] * p[k][2];
        if (k % 4 == 0 || h < low[k / 4]) low[k / 4] = h;
        if (k % 4 == 0 || h > high[k / 4]) high[k / 4] = h;
      }
      separated = separated || high[0] <= low[1] || high[1] <= low[0];
    };
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
        for (int c = 0; c < 8; ++c)
          for (int d = 0; d < 8; ++d) {
            if (a == b || c == d || a / 4 != b / 4 || c / 4 != d / 4) continue;
            Point u, v;
            for (int k = 0; k < 3; ++k) u[k] = p[b][k] - p[a][k], v[k] = p[d][k] - p[c][k];
            if (!separated)
              try_normal({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]});
          }
    EXPECT_TRUE(separated || flat(0) || flat(4)) << i;
  }
  EXPECT_GT(shared, 10);
  EXPECT_GT(apart, 10);
}

}  // namespace
}  // namespace tetproof::test
