// SPDX-License-Identifier: GPL-3.0-or-later
// Sections 1 and 2 of the second implementation by itself, against hand calculation: a witness must be right
// before it testifies.
#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "tests/second/cube.hpp"
#include "tests/second/edge_intersections.hpp"
#include "tests/second/table2.hpp"

namespace tetproof::second {
namespace {

// --- Table 2, in rational numbers

using Barycentric = std::array<Rational, 4>;

// Every cut at a third of its edge from the interior end: then the cuts and the vertices on the surface lie
// in one plane.
Barycentric place(const Name& name) {
  Barycentric b{0, 0, 0, 0};
  if (name.size() == 1) b[name[0] - 1] = 1;
  if (name.size() == 2) {
    b[name[0] - 1] = Rational(2) / 3;
    b[name[1] - 1] = Rational(1) / 3;
  }
  if (name.empty())
    for (const Name& corner : {Name{1}, Name{2}, Name{3}, Name{1, 4}, Name{2, 4}, Name{3, 4}})
      for (int i = 0; i < 4; ++i) b[i] += place(corner)[i] / 6;
  return b;
}

// The volume of a tetrahedron in volumes of v1 v2 v3 v4, signed.
Rational volume(const NamedTet& tet) {
  std::array<std::array<Rational, 3>, 3> m;
  const Barycentric o = place(tet[0]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m[i][j] = place(tet[i + 1])[j + 1] - o[j + 1];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The part of the volume with b_x / (b_x + b_i) below 1/3, where b_x is the sum over the exterior, b_i over
// the interior vertices: the ratio has a beta distribution with as many exterior and interior vertices as
// parameters.
Rational inside_part(const std::string& indicators) {
  const auto count = [&](char c) { return std::count(indicators.begin(), indicators.end(), c); };
  const Rational t = Rational(1) / 3;
  const std::map<std::pair<long, long>, Rational> parts{{{3, 1}, t * t * t},
                                                        {{2, 1}, t * t},
                                                        {{1, 1}, t},
                                                        {{2, 2}, 3 * t * t - 2 * t * t * t},
                                                        {{1, 2}, 2 * t - t * t},
                                                        {{1, 3}, 1 - (1 - t) * (1 - t) * (1 - t)}};
  if (count('-') == 0) return 1;
  if (count('+') == 0) return 0;
  return parts.at({count('-'), count('+')});
}

TEST(SecondTables, EveryRowTilesTheInsidePart) {
  std::map<std::string, int> rows_of_case;
  for (const std::string a : {"+", "0", "-"})
    for (const std::string b : {"+", "0", "-"})
      for (const std::string c : {"+", "0", "-"})
        for (const std::string d : {"+", "0", "-"}) {
          const auto order = [](char x) { return std::string("+0-").find(x); };
          const std::string signs = a + b + c + d;
          if (!std::is_sorted(signs.begin(), signs.end(),
                              [&](char x, char y) { return order(x) < order(y); }))
            continue;
          const std::string number = table1(signs);
          for (const auto& [row, tets] : table2()) {
            if (row != number && !(row.size() == 3 && row.substr(0, 2) == number)) continue;
            SCOPED_TRACE("row " + row);
            ++rows_of_case[number];
            Rational sum = 0;
            std::map<std::set<Name>, int> faces;
            for (const NamedTet& tet : tets) {
              EXPECT_NE(volume(tet), 0);
              sum += abs(volume(tet));
              for (const Name& without : tet) {
                std::set<Name> face(tet.begin(), tet.end());
                face.erase(without);
                ++faces[face];
              }
            }
            EXPECT_EQ(sum, inside_part(signs));
            // A face of one tetrahedron lies on the boundary: one of the four planes or the surface's.
            for (const auto& [face, times] : faces) {
              EXPECT_LE(times, 2);
              bool on_boundary = false;
              for (int plane = 0; plane < 5; ++plane)
                on_boundary |= std::all_of(face.begin(), face.end(), [&](const Name& name) {
                  if (plane < 4) return place(name)[plane] == 0;
                  Rational x = 0, i = 0;
                  for (int v = 0; v < 4; ++v)
                    (signs[v] == '-'   ? x
                     : signs[v] == '+' ? i
                                       : x) += signs[v] == '0' ? Rational(0) : place(name)[v];
                  return 2 * x == i;
                });
              EXPECT_EQ(times == 1, on_boundary);
            }
          }
        }
  EXPECT_EQ(rows_of_case.size(), 15u);
  EXPECT_EQ(rows_of_case["10"], 4);
  EXPECT_EQ(rows_of_case["11"], 2);
  EXPECT_EQ(rows_of_case["12"], 8);
}

// --- the surface

TEST(SecondGeometry, PointsOfACube) {
  const TriangleSurface s = cube();
  for (const Point& p : {Point(0, 0, 0), Point(0.5, 0.5, 1), Point(1, 0.3, 0.1), Point(0, 0.5, 1)})
    EXPECT_TRUE(is_on(s, p));
  for (const Point& p : {Point(0.5, 0.5, 0.5), Point(1e-300, 0.5, 0.5), Point(0.25, 0.25, 0.25)}) {
    EXPECT_FALSE(is_on(s, p));
    EXPECT_TRUE(is_inside(s, p));
  }
  for (const Point& p : {Point(-1e-300, 0.5, 0.5), Point(2, 0, 0), Point(-1, 1, 1), Point(0.5, 0.5, 3)}) {
    EXPECT_FALSE(is_on(s, p));
    EXPECT_FALSE(is_inside(s, p));
  }
  EXPECT_EQ(closest_on_surface(s, {0.5, 0.5, 0.75}), Point(0.5, 0.5, 1));
  EXPECT_EQ(closest_on_surface(s, {2, 2, 2}), Point(1, 1, 1));
  EXPECT_EQ(closest_on_surface(s, {2, -1, 0.25}), Point(1, 0, 0.25));
  EXPECT_EQ(closest_on_surface(s, {0.5, 0.5, 0.5}),
            Point(0, 0.5, 0.5));  // of six the lexicographically smallest
}

TEST(SecondGeometry, EdgesThatMeetACube) {
  const TriangleSurface s = cube();
  using Parts = std::vector<std::pair<Rational, Rational>>;
  const Rational quarter = Rational(1) / 4, half = Rational(1) / 2;
  const Point outside(-0.5, 0.5, 0.25);
  EXPECT_EQ(meets(s, outside, {1.5, 0.5, 0.25}), (Parts{{quarter, quarter}, {3 * quarter, 3 * quarter}}));
  EXPECT_EQ(meets(s, outside, {0.5, 0.5, 0.25}), (Parts{{half, half}}));
  EXPECT_EQ(meets(s, outside, {0, 0.5, 0.25}), (Parts{{1, 1}}));
  EXPECT_EQ(meets(s, {0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}), Parts{});
  EXPECT_EQ(meets(s, {-1, 1, 0.5}, {1, -1, 0.5}), (Parts{{half, half}}));               // touches an edge
  EXPECT_EQ(meets(s, {-0.5, 0.5, 1}, {1.5, 0.5, 1}), (Parts{{quarter, 3 * quarter}}));  // in a face
  EXPECT_EQ(meets(s, {-0.5, 0, 1}, {1.5, 0, 1}), (Parts{{quarter, 3 * quarter}}));      // along an edge
  EXPECT_EQ(meets(s, {-1, 0, 1}, {1, 2, 1}), (Parts{{half, half}}));  // a face's plane, a vertex
  EXPECT_EQ(along({0, 0, 0}, {3, 1, 0}, Rational(1) / 3), Point(1, 1.0 / 3, 0));
}

}  // namespace
}  // namespace tetproof::second
