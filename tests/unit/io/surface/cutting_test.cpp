// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained Delaunay triangulations of polygons and facets, against a second computation.
#include "io/surface/cutting.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace tetproof::io {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using Triangles = std::vector<std::array<Index, 3>>;
using Polygons = std::vector<std::vector<Index>>;

class Random {
 public:
  double operator()() {
    seed_ = seed_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed_ >> 33) / 2147483648.0;
  }
  int below(int n) { return static_cast<int>((*this)() * n); }

 private:
  std::uint64_t seed_ = 42;
};

std::vector<Index> counted_up(std::size_t n) {
  std::vector<Index> corners(n);
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

Triangles cut_of(const std::vector<Index>& corners, const Points& points) {
  Cut cut;
  cut_polygon(corners, points, cut);
  EXPECT_EQ(cut.fault, "");
  EXPECT_EQ(cut.bend, 0);
  return cut.triangles;
}

Triangles cut_of(const Polygons& polygons, const Points& holes, const Points& points) {
  Cut cut;
  std::vector<std::span<const Index>> spans(polygons.begin(), polygons.end());
  cut_facet(spans, holes, points, cut);
  EXPECT_EQ(cut.fault, "");
  return cut.triangles;
}

double twice_area(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return (b - a).cross(c - a)[2];
}

double twice_area(const Triangles& triangles, const Points& points) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const double one = twice_area(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)],
                                  points[static_cast<std::size_t>(c)]);
    EXPECT_GT(one, 0);
    area += one;
  }
  return area;
}

// Positive if d is in the circle of a, b and c. Exact for small integers.
double in_circle(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    const Vector3d p = (i == 0 ? a : i == 1 ? b : c) - d;
    m.row(i) << p[0], p[1], p[0] * p[0] + p[1] * p[1];
  }
  return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
         m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

// Every inner side that is no side of the polygons is Delaunay; of four on a circle, the smallest has the
// diagonal.
void expect_delaunay(const Triangles& triangles, const Points& points, const Polygons& polygons) {
  std::set<std::pair<Index, Index>> given;
  for (const auto& polygon : polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto [a, b] = std::minmax(polygon[k], polygon[(k + 1) % polygon.size()]);
      given.insert({a, b});
    }
  std::map<std::pair<Index, Index>, Index> opposite;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) opposite[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  for (const auto& [side, c] : opposite) {
    const auto [a, b] = side;
    const auto other = opposite.find({b, a});
    if (other == opposite.end() || given.contains(std::minmax(a, b))) continue;
    const Index d = other->second;
    const auto p = [&](Index i) -> const Vector3d& { return points[static_cast<std::size_t>(i)]; };
    const double in = in_circle(p(a), p(b), p(c), p(d));
    EXPECT_LE(in, 0) << a << ' ' << b << ' ' << c << ' ' << d;
    if (in == 0) {
      EXPECT_LT(std::min(a, b), std::min(c, d));
    }
  }
}

// A polygon around the origin whose corners are points of a lattice, so that all is exact and ties are many.
Points star(Random& random, int corners, int size) {
  std::map<double, std::pair<int, int>> by_angle;
  while (static_cast<int>(by_angle.size()) < corners) {
    const int x = random.below(2 * size + 1) - size, y = random.below(2 * size + 1) - size;
    if (x != 0 || y != 0) by_angle.try_emplace(std::atan2(y, x), x, y);
  }
  Points points;
  for (const auto& [angle, p] : by_angle) points.emplace_back(p.first, p.second, 0);
  return points;
}

// Whether the origin is inside: no gap between two corners is half a turn or more.
bool surrounds_origin(const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].cross(points[(i + 1) % points.size()])[2] <= 0) return false;
  return true;
}

bool is_convex(const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (twice_area(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) < 0)
      return false;
  return true;
}

TEST(Cutting, StarsAreConstrainedDelaunay) {
  Random random;
  int tried = 0;
  for (int round = 0; round < 400; ++round) {
    const Points points = star(random, 4 + random.below(20), 4 + random.below(6));
    if (!surrounds_origin(points) || is_convex(points)) continue;
    ++tried;
    const std::vector<Index> corners = counted_up(points.size());
    const Triangles cut = cut_of(corners, points);
    EXPECT_EQ(cut.size(), points.size() - 2);
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      area += points[i].cross(points[(i + 1) % points.size()])[2];
    EXPECT_EQ(twice_area(cut, points), area);
    expect_delaunay(cut, points, {corners});
    EXPECT_TRUE(std::is_sorted(cut.begin(), cut.end()));
  }
  EXPECT_GT(tried, 200);
}

// The first corner does not count, nor the direction, nor the axis that the plane is seen along.
TEST(Cutting, DependsOnNothingButThePolygon) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    const Points points = star(random, 12, 6);
    if (!surrounds_origin(points) || is_convex(points)) continue;
    std::vector<Index> corners = counted_up(points.size());
    const Triangles cut = cut_of(corners, points);
    Points turned = points;
    for (Vector3d& p : turned) p = {p[2], p[0], p[1]};
    EXPECT_EQ(cut_of(corners, turned), cut);
    Points steep;  // z = x: lengths along x are longer, so that another triangulation may be Delaunay
    for (const Vector3d& p : points) steep.emplace_back(p[0] * 0.5, p[1], p[0]);
    EXPECT_EQ(cut_of(corners, steep).size(), cut.size());
    std::rotate(corners.begin(), corners.begin() + 5, corners.end());
    EXPECT_EQ(cut_of(corners, points), cut);
    std::reverse(corners.begin(), corners.end());
    Triangles backwards = cut_of(corners, points);
    for (auto& t : backwards) std::swap(t[1], t[2]);
    std::sort(backwards.begin(), backwards.end());
    EXPECT_EQ(backwards, cut);
  }
}

// Lengths are those in the polygon's plane, not those that are seen: the diagonal of the notched kite
// changes.
TEST(Cutting, MeasuresInThePlane) {
  // Seen from above, the square of side 2 with a notch; on the slope z = 3 y it is long in y.
  const Points flat{{0, 0, 0}, {1, 0.25, 0}, {2, 0, 0}, {2, 1.5, 0}, {0, 1.5, 0}};
  Points steep = flat;
  for (Vector3d& p : steep) p = {p[0], p[1], 3 * p[1]};
  const std::vector<Index> corners = counted_up(5);
  for (const Points& points : {flat, steep}) {
    const Triangles cut = cut_of(corners, points);
    ASSERT_EQ(cut.size(), 3u);
    Eigen::Matrix3d to_plane = Eigen::Matrix3d::Identity();
    if (points == steep) to_plane(1, 1) = std::sqrt(10);
    Points in_plane = flat;
    for (Vector3d& p : in_plane) p = to_plane * p;
    expect_delaunay(cut, in_plane, {corners});
  }
}

const Points square_with_ring{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {2, 2, 0}, {6, 2, 0},
                              {6, 6, 0}, {2, 6, 0}, {4, 4, 0}, {3, 3, 0}, {5, 3, 0}};
const Polygons outer{{0, 1, 2, 3}}, ring{{0, 1, 2, 3}, {4, 5, 6, 7}};

TEST(Cutting, FacetsLikeTetgen) {
  // A hole; no hole, but edges; an edge and a point inside.
  EXPECT_EQ(twice_area(cut_of(ring, {{4, 4, 0}}, square_with_ring), square_with_ring), 2 * (64 - 16));
  EXPECT_EQ(twice_area(cut_of(ring, {}, square_with_ring), square_with_ring), 2 * 64);
  expect_delaunay(cut_of(ring, {}, square_with_ring), square_with_ring, ring);
  const Polygons inner{{0, 1, 2, 3}, {9, 10}, {8}};
  const Triangles with_edge = cut_of(inner, {}, square_with_ring);
  EXPECT_EQ(with_edge.size(), 4u + 2 * 3 - 2);
  expect_delaunay(with_edge, square_with_ring, inner);
  bool has_edge = false;
  for (const auto& t : with_edge)
    has_edge = has_edge || (std::count(t.begin(), t.end(), 9) && std::count(t.begin(), t.end(), 10));
  EXPECT_TRUE(has_edge);
  // Two separate polygons, of which the second is wound the other way: all as the larger one.
  EXPECT_EQ(twice_area(cut_of({{0, 1, 4}, {6, 3, 2}}, {}, square_with_ring), square_with_ring), 16 + 16);
  // Edges alone surround nothing.
  EXPECT_TRUE(cut_of({{0, 1}, {1, 2}}, {}, square_with_ring).empty());
  // An outline of edges, as some files have it, has no normal; with a polygon beside it, it is filled.
  EXPECT_EQ(twice_area(cut_of({{4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 1, 2, 3}}, {{4, 4, 0}}, square_with_ring),
                       square_with_ring),
            2 * 48);
}

// Points on sides of polygons become corners of the triangles.
TEST(Cutting, PointsOnSides) {
  const Points points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 0}, {2, 4, 0}};
  const Triangles cut = cut_of({{0, 1, 2, 3}, {4, 5}}, {}, points);
  EXPECT_EQ(cut.size(), 4u);
  EXPECT_EQ(twice_area(cut, points), 32);
}

// A side that passes over a corner: where the polygon touches itself there, it can be cut; where it goes on
// to the other side, one of its two parts would be turned.
TEST(Cutting, CrossedAndTouchedAtACorner) {
  const Points points{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 0, 0}, {2, 3, 0}, {2, -2, 0}};
  EXPECT_EQ(cut_of({0, 1, 2, 3, 4}, points), (Triangles{{0, 3, 4}, {1, 2, 3}}));
  for (const std::vector<Index>& crossed :
       {std::vector<Index>{0, 1, 2, 3, 5}, {0, 3, 1, 2, 3, 5}, {5, 3, 2, 1, 0}}) {
    Cut cut;
    cut_polygon(crossed, points, cut);
    EXPECT_EQ(cut.fault, "crosses itself");
  }
}

TEST(Cutting, Faults) {
  Cut cut;
  const std::vector<Index> bow{0, 1, 3, 2};
  std::vector<std::span<const Index>> polygons{bow, {bow.data(), 1}};
  cut_facet(polygons, {}, {{0, 0, 0}, {4, 0, 0}, {3, 4, 0}, {0, 4, 0}}, cut);
  EXPECT_EQ(cut.fault, "crosses itself");
  EXPECT_TRUE(cut.triangles.empty());
  cut_facet(polygons, {}, {{-1e308, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {0, 1e308, 0}}, cut);
  EXPECT_EQ(cut.fault, "has a coordinate that is not finite or too large");
  const Points large{
      {0, 0, 0}, {1e200, 0, 0}, {1e200, 1e200, 0}, {0, 1e200, 0}};  // products are out of range
  EXPECT_EQ(cut_of({{0, 1, 2, 3}, {2}}, {{NAN, 0, 0}}, large).size(), 2u);
  const std::vector<Index> hourglass = counted_up(6);
  cut_polygon(hourglass, {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 1e-9}}, cut);
  EXPECT_EQ(cut.fault, "has two corners at one place, seen along its normal");
}

}  // namespace
}  // namespace tetproof::io
