// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that a segment meets.
#include "io/surface/crossed_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tetproof::io {
namespace {

using Eigen::Vector3d;

std::vector<std::size_t> met(const CrossedTriangles& triangles, const Vector3d& from, const Vector3d& to) {
  std::vector<std::size_t> all = triangles.of(from, to);
  std::sort(all.begin(), all.end());
  return all;
}

// Ten triangles in the planes z = 0 to 9, at every scale.
TEST(CrossedTriangles, AreExact) {
  for (const int exponent : {0, -500, 500}) {
    const auto at = [&](double x, double y, double z) -> Vector3d {
      return std::ldexp(1, exponent) * Vector3d(x, y, z);
    };
    std::vector<Vector3d> points;
    std::vector<std::array<Index, 3>> all;
    for (int z = 0; z < 10; ++z) {
      const auto first = static_cast<Index>(points.size());
      for (const Vector3d& p : {at(0, 0, z), at(4, 0, z), at(0, 4, z)}) points.push_back(p);
      all.push_back({first, first + 1, first + 2});
    }
    const CrossedTriangles triangles(points, all);
    using Numbers = std::vector<std::size_t>;
    EXPECT_EQ(met(triangles, at(1, 1, 2.5), at(1, 1, 5.5)), (Numbers{3, 4, 5}));
    EXPECT_EQ(met(triangles, at(1, 1, 3), at(1, 1, 4)), (Numbers{3, 4}));     // ends on two of them
    EXPECT_EQ(met(triangles, at(0, 0, -1), at(0, 0, 0.5)), (Numbers{0}));     // a corner
    EXPECT_EQ(met(triangles, at(2, 2, -1), at(2, 2, 1.5)), (Numbers{0, 1}));  // a side
    EXPECT_EQ(met(triangles, at(2, std::nextafter(2, 3), -1), at(2, std::nextafter(2, 3), 99)), Numbers{});
    EXPECT_EQ(met(triangles, at(-1, 1, 3), at(9, 1, 3)), (Numbers{3}));  // in its plane
    EXPECT_EQ(met(triangles, at(5, 5, 0), at(6, 7, 8)), Numbers{});
    EXPECT_EQ(met(triangles, at(0, 1, 0.5), at(8, 1, 4.5)), (Numbers{1, 2}));  // at x = 1 and x = 3
  }
}

}  // namespace
}  // namespace tetproof::io
