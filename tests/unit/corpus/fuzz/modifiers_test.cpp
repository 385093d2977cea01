// SPDX-License-Identifier: GPL-3.0-or-later
// The modifiers of random surfaces: what they do to the coordinates, and what they must not do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "corpus/fuzz/decimals.hpp"
#include "corpus/fuzz_surface.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

FuzzSurface built(const std::string& recipe) {
  return build(parse_recipe(recipe));
}

std::string error_of(const std::string& recipe) {
  try {
    built(recipe);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FuzzModifiers, MoveEachVertexAsTheyShould) {
  const std::vector<Eigen::Vector3d> before = built("comb(teeth=3,gap=0.5)").surface.vertices;
  const struct {
    const char* modifier;
    Eigen::Vector3d (*map)(const Eigen::Vector3d&);
  } cases[] = {
      {"offset(x=10,y=-20,z=1000)",
       [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p[0] + 10, p[1] - 20, p[2] + 1000); }},
      {"scale(x=2,z=0.5)",
       [](const Eigen::Vector3d& p) { return Eigen::Vector3d(2 * p[0], p[1], p[2] / 2); }},
      {"shear(xy=2,xz=-1,yz=0.5)",
       [](const Eigen::Vector3d& p) {
         return Eigen::Vector3d(p[0] + 2 * p[1] - p[2], p[1] + p[2] / 2, p[2]);
       }},
      {"rotate(a=1,d=1)", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p[1], p[0], p[2]); }},
      {"rotate(a=1,b=1)", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p[0], -p[2], p[1]); }},
      {"rotate(a=1,c=1)", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p[2], p[1], -p[0]); }},
      {"size(s=0.25)", [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p / 4); }},
  };
  for (const auto& [modifier, map] : cases) {
    const std::vector<Eigen::Vector3d> after =
        built(std::string("comb(teeth=3,gap=0.5)+") + modifier).surface.vertices;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i], map(before[i])) << modifier;
  }
}

TEST(FuzzModifiers, RotationsKeepTheVolumeAlmost) {
  const double before = built("star(seed=4,f=3)").volume.value();
  EXPECT_NEAR(built("star(seed=4,f=3)+rotate(a=3,b=1,c=4,d=1)").volume.value(), before, 1e-14 * before);
  const double coarse = built("star(seed=4,f=3)+rotate(a=3,b=1,c=4,d=1,digits=3)").volume.value();
  EXPECT_NEAR(coarse, before, 1e-2 * before);
  EXPECT_NE(coarse, before);
}

TEST(FuzzModifiers, Rounding) {
  const FuzzSurface floats = built("star(seed=4,f=2)+floats"),
                    decimals = built("star(seed=4,f=2)+decimals(digits=3)");
  for (const Eigen::Vector3d& v : floats.surface.vertices)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(v[k], static_cast<float>(v[k]));
  for (const Eigen::Vector3d& v : decimals.surface.vertices)
    for (int k = 0; k < 3; ++k) {
      char text[40];
      std::snprintf(text, sizeof text, "%.2e", v[k]);
      EXPECT_EQ(std::strtod(text, nullptr), v[k]);
    }
}

TEST(Decimals, RoundTiesToEven) {
  EXPECT_EQ(to_significant_digits(0.40625, 4), 0.4062);
  EXPECT_EQ(to_significant_digits(0.40375, 4), 0.4037);  // the double is less than the decimal number
  EXPECT_EQ(to_significant_digits(-0.46875, 4), -0.4688);
  EXPECT_EQ(to_significant_digits(2.5, 1), 2);
  EXPECT_EQ(to_significant_digits(123456, 2), 120000);
  EXPECT_EQ(to_significant_digits(0, 3), 0);
  EXPECT_EQ(to_decimal_places(0.0625, 3), 0.062);
  EXPECT_EQ(to_decimal_places(-12.3456, 3), -12.346);
  for (const double x : {1.0, 0.1, -1e-300, 123456.789, 5e-324, 1e300, 0.0})
    EXPECT_EQ(shortest_decimal(x).value(), x);
  EXPECT_EQ(shortest_decimal(-0.00120).digits, "12");
  EXPECT_EQ(shortest_decimal(-0.00120).exponent, -3);
}

TEST(FuzzModifiers, RenumberingKeepsTheTriangles) {
  const auto triangles = [](const TriangleSurface& surface) {
    std::vector<std::array<double, 9>> all;
    for (auto t : surface.triangles) {
      // The corner with the least coordinates first.
      const auto before = [&](Index a, Index b) {
        const Eigen::Vector3d &p = surface.vertices[a], &q = surface.vertices[b];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
      };
      std::rotate(t.begin(), std::min_element(t.begin(), t.end(), before), t.end());
      std::array<double, 9> one;
      for (int k = 0; k < 9; ++k) one[k] = surface.vertices[t[k / 3]][k % 3];
      all.push_back(one);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  const FuzzSurface plain = built("knot"), other = built("knot+renumber(seed=8)");
  EXPECT_EQ(triangles(plain.surface), triangles(other.surface));
  EXPECT_NE(plain.surface.triangles, other.surface.triangles);
  EXPECT_NE(plain.surface.vertices, other.surface.vertices);
  EXPECT_EQ(plain.volume, other.volume);
}

TEST(FuzzModifiers, WhatTheyBreakIsNamed) {
  EXPECT_EQ(error_of("thin-plate(h=1e-9)+offset(z=1e6)+floats").substr(0, 90),
            "thin-plate(seed=0,n=0,h=1e-09)+offset(x=0,y=0,z=1e+06)+floats(): 8 triangles have no area ");
  EXPECT_NE(error_of("nested-boxes(n=2,gap=1e-7)+decimals(digits=3)"), "no error");
  EXPECT_EQ(error_of("comb+rotate(a=0)"), "rotate: a: expected a number other than 0 among a, b, c, d");
}

}  // namespace
}  // namespace tetproof::corpus
