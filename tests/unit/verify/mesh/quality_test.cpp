// SPDX-License-Identifier: GPL-3.0-or-later
// Angles and aspect ratios of tetrahedra, against values of 400 digits, at all scales.
#include <gtest/gtest.h>

#include <cmath>

#include "verify/mesh/quality.hpp"

namespace tetproof::verify {
namespace {

struct Case {
  const char* name;
  std::array<Eigen::Vector3d, 4> points;
  std::array<double, 5> right;  // least and largest dihedral and solid angle, aspect ratio
};

// Made with mpmath, mp.dps = 400, from these coordinates: a dihedral angle as the acos between the parts of
// two edges that are orthogonal to their common edge; a solid angle as the sum of three dihedral angles minus
// pi; the aspect ratio as the longest edge over 2 sqrt(6) times (3 V / sum of areas).
const std::vector<Case> cases{
    {"corner of a cube",
     {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
     {54.735610317245346, 90.0, 0.027043361992348182, 0.125, 1.3660254037844386}},
    {"needle",
     {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1e-06, 0.0}, {1.0, 0.0, 1e-06}}},
     {45.000000000014324, 90.0, 3.9788735772953936e-14, 0.125, 696923.62918324179}},
    {"sliver",
     {{{0.0, 0.0, 0.0}, {1.0, 1.0, 1e-09}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}},
     {5.7295779513082324e-8, 179.99999991897153, 4.661540357225708e-11, 4.661540357225708e-11,
      1154700538.3792515}},
    {"cap",
     {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.25, 1.0, 0.0}, {0.4, 0.3, 1e-12}}},
     {1.81720423718876e-10, 179.99999999970618, 5.0211408894191644e-14, 0.49999999999864997,
      510310363079.82878}},
    {"nearly flat in general position",
     {{{0.1, 0.2, 0.3}, {0.7, 0.30000000000000004, 0.1}, {0.4, 0.9, 0.2}, {0.4, 0.46666666666666673, 0.2}}},
     {4.6997277160060507e-15, 179.99999999999999, 1.4918796754553895e-18, 0.49999999999999996,
      17863647754516797.0}},
    {"far from the origin",
     {{{100000000.0, 100000000.0, 100000000.0},
       {100000001.0, 100000000.0, 100000000.0},
       {100000000.0, 100000001.0, 100000000.0},
       {100000000.0, 100000000.0, 100000000.00000001}}},
     {1.207418269725733e-6, 90.0, 4.9117308815852685e-10, 0.125, 38745321.272760259}},
    {"wedge with a straight angle",
     {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {-1.0, 0.001, 0.0}, {0.0, 0.001, 0.001}}},
     {18.434951687707835, 179.9594857725253, 1.9894354209117751e-8, 0.12494375013397641, 2475.8203031205088}},
};

Quality quality_of(std::array<Eigen::Vector3d, 4> points, int exponent) {
  TetMesh mesh{.points = {points.begin(), points.end()}, .tets = {{0, 1, 2, 3}}};
  for (Eigen::Vector3d& p : mesh.points)
    for (double& x : p) x = std::ldexp(x, exponent);
  return measure_quality(mesh, {});
}

TEST(Quality, AnglesDoNotCancelAtAnyScale) {
  for (const Case& c : cases)
    for (const int exponent : {0, -300, 260, -900, 900}) {
      const Quality q = quality_of(c.points, exponent);
      ASSERT_EQ(q.tets, 1) << c.name << " " << exponent;
      const std::array<double, 5> found{q.dihedral_angles.min, q.dihedral_angles.max, q.solid_angles.min,
                                        q.solid_angles.max, q.aspect_ratios.max};
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i] / c.right[i], 1, 2e-11) << c.name << " 2^" << exponent << ", value " << i;
    }
}

TEST(Quality, TheOrderOfTheVerticesHardlyMatters) {
  for (const Case& c : cases) {
    std::array<int, 4> order{0, 1, 2, 3};
    do {
      const bool even = [&] {
        int inversions = 0;
        for (int i = 0; i < 4; ++i)
          for (int k = 0; k < i; ++k) inversions += order[k] > order[i];
        return inversions % 2 == 0;
      }();
      const Quality q =
          quality_of({c.points[order[0]], c.points[order[1]], c.points[order[2]], c.points[order[3]]}, 0);
      EXPECT_EQ(q.tets, even ? 1 : 0) << "an inverted tetrahedron is not measured";
      if (!even) continue;
      EXPECT_NEAR(q.solid_angles.min / c.right[2], 1, 2e-11) << c.name;
      EXPECT_NEAR(q.dihedral_angles.min / c.right[0], 1, 2e-11) << c.name;
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Quality, AFlatTetrahedronIsNotMeasured) {
  // The four points lie in one plane exactly, though the determinant in doubles is not 0.
  const std::array<Eigen::Vector3d, 4> flat{
      {{0.1, 0.2, 0.1}, {0.7, 0.3, 0.7}, {0.3, 0.9, 0.3}, {0.35, 0.4, 0.35}}};
  EXPECT_EQ(quality_of(flat, 0).tets, 0);
  EXPECT_EQ(quality_of({flat[0], flat[0], flat[1], flat[2]}, 0).tets, 0);
}

}  // namespace
}  // namespace tetproof::verify
