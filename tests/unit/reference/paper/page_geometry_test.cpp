// SPDX-License-Identifier: GPL-3.0-or-later
// The page's questions about points and triangles, against rational arithmetic and calculation by hand.
#include <gtest/gtest.h>

#include <random>

#include "reference/paper/geometry.hpp"

namespace tetproof::reference::paper {
namespace {

const double least = std::nextafter(0.0, 1.0);
const Triangle flat{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)};

// All orders of the corners: no answer may depend on it.
std::vector<Triangle> orders(const Triangle& t) {
  return {{t[0], t[1], t[2]}, {t[1], t[2], t[0]}, {t[2], t[0], t[1]},
          {t[1], t[0], t[2]}, {t[0], t[2], t[1]}, {t[2], t[1], t[0]}};
}

TEST(PageGeometry, OrientationIsExactAtEveryScale) {
  std::mt19937_64 random(1994);
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };  // -1 .. 1
  for (int exponent = -340; exponent <= 300; exponent += 20) {
    int zeros = 0, signs = 0;
    for (int trial = 0; trial < 40; ++trial) {
      const auto point = [&] { return Point(coordinate(), coordinate(), coordinate()); };
      const Point a = point(), b = point(), c = point();
      // In the plane of the others; up to rounding; or not at all.
      Point d = point();
      if (trial % 4 == 1) d = (b + c) / 2;
      if (trial % 4 == 2) d = a + 0.3 * (b - a) + 0.6 * (c - a);
      if (trial % 4 == 3) d = a;
      const double scale = std::ldexp(1.0, exponent);
      const auto scaled = [&](const Point& p) { return Point(p * scale); };
      const int exact = determinant(scaled(a), scaled(b), scaled(c), scaled(d)).sign();
      EXPECT_EQ(orientation(scaled(a), scaled(b), scaled(c), scaled(d)), exact) << "2^" << exponent;
      EXPECT_EQ(orientation(scaled(b), scaled(a), scaled(c), scaled(d)), -exact) << "2^" << exponent;
      exact == 0 ? ++zeros : ++signs;
    }
    EXPECT_GE(zeros, 10);
    EXPECT_GE(signs, 10);
  }
}

TEST(PageGeometry, OrientationOfPointsOfVeryDifferentSize) {
  const double huge = 0x1p300, tiny = 0x1p-340;
  EXPECT_EQ(orientation({0, 0, 0}, {huge, 0, 0}, {0, tiny, 0}, {0, 0, huge}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}), 1);  // 2^-1020
  EXPECT_EQ(orientation({0, 0, 0}, {least, 0, 0}, {0, least, 0}, {huge, huge, -least}), -1);
  EXPECT_EQ(orientation({huge, 0, 0}, {0, huge, 0}, {0, 0, huge}, {huge, -tiny, 0}), -1);
}

TEST(PageGeometry, OnATriangle) {
  for (const Triangle& t : orders(flat)) {
    for (const Point& p : {Point(0, 0, 0), Point(4, 0, 0), Point(2, 2, 0), Point(1, 0, 0), Point(1, 1, 0),
                           Point(least, least, 0)})
      EXPECT_TRUE(is_on(t, p)) << p.transpose();
    for (const Point& p : {Point(1, 1, least), Point(1, -least, 0), Point(std::nextafter(2, 3), 2, 0),
                           Point(5, 5, 0), Point(4.5, 0, 0)})
      EXPECT_FALSE(is_on(t, p)) << p.transpose();
  }
  const Triangle tilted{Point(3, 0, 0), Point(0, 3, 0), Point(0, 0, 3)};
  EXPECT_TRUE(is_on(tilted, {1, 1, 1}));
  EXPECT_FALSE(is_on(tilted, {1, 1, std::nextafter(1, 2)}));
}

TEST(PageGeometry, ALineCrossesBesideEdgesAndVertices) {
  struct Case {
    Triangle t;
    double y, z;
    bool crosses;
    const char* what;
  };
  const Triangle upper{Point(0, 0, 0), Point(0, 2, 0), Point(0, 0, 2)};
  const Triangle lower{Point(0, 0, 0), Point(0, 2, 0), Point(0, 0, -2)};
  const Triangle left{Point(0, 0, 0), Point(0, -2, 0), Point(0, 0, 2)};
  // The line is moved by (epsilon, epsilon^2) in y and z (reading D4).
  const Case cases[]{{upper, 0.5, 0.5, true, "inside"},
                     {upper, 2, 2, false, "outside"},
                     {upper, 1, 0, true, "the edge below: moved up into it"},
                     {lower, 1, 0, false, "the edge above: moved up out of it"},
                     {upper, 0, 1, true, "the edge at smaller y: moved into it"},
                     {left, 0, 1, false, "the edge at larger y: moved out of it"},
                     {upper, 1, 1, false, "the slanted edge"},
                     {upper, 0, 0, true, "the vertex of smallest y and z"},
                     {upper, 2, 0, false, "the vertex of largest y"},
                     {upper, 0, 2, false, "the vertex of largest z"},
                     {lower, 0, 0, false, "a vertex with the triangle below"},
                     {left, 0, 0, false, "a vertex with the triangle at smaller y"},
                     {upper, -least, 0.5, false, "the least double beside"}};
  for (const Case& c : cases)
    for (const Triangle& t : orders(c.t)) {
      EXPECT_EQ(crosses_before(t, {1, c.y, c.z}), c.crosses) << c.what;
      EXPECT_FALSE(crosses_before(t, {-1, c.y, c.z})) << c.what << ": p comes first";
      EXPECT_EQ(crosses_before(t, {least, c.y, c.z}), c.crosses) << c.what << ": just before p";
    }
  for (const Triangle& t : orders(flat)) EXPECT_FALSE(crosses_before(t, {9, 1, 0})) << "parallel to the line";
  for (const Triangle& t : orders({Point(0, 0, 0), Point(2, 2, 0), Point(2, 0, 2)})) {  // a slanted one
    EXPECT_TRUE(crosses_before(t, {1, 0.5, 0.25}));
    EXPECT_FALSE(crosses_before(t, {0.5, 0.5, 0.25}));
  }
}

TEST(PageGeometry, ALineThroughAVertexCrossesOneTriangleOfItsFan) {
  const Point centre(0, 0, 0);
  const std::array<Point, 6> ring{Point(0, 1, 0),  Point(0, 1, 1),   Point(0, -1, 1),
                                  Point(0, -1, 0), Point(0, -1, -1), Point(0, 1, -1)};
  for (const Point& p : {Point(1, 0, 0), Point(1, 0.5, 0), Point(1, -0.5, 0), Point(1, 0.5, 0.5)}) {
    int crossed = 0;
    for (int i = 0; i < 6; ++i) crossed += crosses_before({centre, ring[i], ring[(i + 1) % 6]}, p);
    EXPECT_EQ(crossed, 1) << p.transpose();
  }
}

TEST(PageGeometry, TheCommonPartOfAnEdgeAndATriangle) {
  struct Case {
    Point p, q;
    std::optional<Interval> part;
    const char* what;
  };
  const Rational quarter(1, 4), half(1, 2);
  const auto point = [](const Rational& s) { return Interval(s, s); };
  const Case cases[]{{{1, 1, 1}, {1, 1, -3}, point(quarter), "through the inside"},
                     {{1, 1, 1}, {1, 1, -2}, point(Rational(1, 3)), "at a third, which is no double"},
                     {{1, 1, 1}, {1, 1, 0}, point(1), "up to the triangle"},
                     {{1, 1, 0}, {1, 1, 1}, point(0), "from the triangle"},
                     {{1, 1, 1}, {1, 1, least}, std::nullopt, "almost to the triangle"},
                     {{2, 2, 1}, {2, 2, -1}, point(half), "through an edge"},
                     {{0, 0, 1}, {0, 0, -1}, point(half), "through a vertex"},
                     {{3, 3, 1}, {3, 3, -1}, std::nullopt, "beside"},
                     {{3, 3, 1}, {1, 1, -1}, point(half), "slanted, through an edge"},
                     {{1, 1, 1}, {2, 1, 1}, std::nullopt, "parallel"},
                     {{-1, 1, 0}, {3, 1, 0}, Interval(quarter, 1), "in the plane, from outside to an edge"},
                     {{-4, 1, 0}, {4, 1, 0}, Interval(half, Rational(7, 8)), "in the plane, across"},
                     {{1, 1, 0}, {2, 1, 0}, Interval(0, 1), "in the plane, within"},
                     {{-4, 0, 0}, {4, 0, 0}, Interval(half, 1), "along an edge"},
                     {{-2, 2, 0}, {2, -2, 0}, point(half), "in the plane, touches a vertex"},
                     {{-2, 1, 0}, {2, -3, 0}, std::nullopt, "in the plane, beside"}};
  for (const Case& c : cases)
    for (const Triangle& t : orders(flat)) {
      EXPECT_EQ(common_part(c.p, c.q, t), c.part) << c.what;
      std::optional<Interval> back;
      if (c.part) back = Interval(1 - c.part->second, 1 - c.part->first);
      EXPECT_EQ(common_part(c.q, c.p, t), back) << c.what << ", from the other end";
    }
}

TEST(PageGeometry, ACutInDoublesIsCertifiedOrRefused) {
  const auto cut = cut_in_doubles({1, 1, 1}, {1, 1, -3}, flat);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->first, 0.25);
  EXPECT_EQ(cut->second, 0.75);
  // A needle: the rounding of its normal may turn it by more than 1e-12.
  const Triangle needle{Point(0, 0, 0), Point(1, 1 / 3.0, 0), Point(2, 2 / 3.0 + 1e-15, 0)};
  EXPECT_FALSE(cut_in_doubles({1, 1 / 3.0, 1}, {1, 1 / 3.0, -3}, needle));
  EXPECT_FALSE(cut_in_doubles({1, 1, 0}, {2, 1, 0}, flat)) << "an edge in the plane has no cut";
}

TEST(PageGeometry, TheClosestPointOfEachRegion) {
  const std::pair<Point, Point> cases[]{
      {{1, 1, 5}, {1, 1, 0}},  {{-1, -2, 1}, {0, 0, 0}}, {{9, -1, 1}, {4, 0, 0}},
      {{-1, 9, 1}, {0, 4, 0}}, {{1, -3, 2}, {1, 0, 0}},  {{-3, 1, 2}, {0, 1, 0}},
      {{4, 4, 2}, {2, 2, 0}},  {{1, 2, 0}, {1, 2, 0}},   {{4, 0, 0}, {4, 0, 0}}};
  for (const auto& [p, expected] : cases)
    for (const Triangle& t : orders(flat)) EXPECT_EQ(closest_point(t, p), expected) << p.transpose();
}

}  // namespace
}  // namespace tetproof::reference::paper
