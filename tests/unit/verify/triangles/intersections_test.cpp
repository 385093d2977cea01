// SPDX-License-Identifier: GPL-3.0-or-later
// The pair test and the search for intersecting triangles, against another kind of rational arithmetic on all
// pairs of small sets of triangles, and against CGAL's own test where it applies.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "corpus/surfaces.hpp"
#include "tests/support/meshes.hpp"
#include "verify/triangles/intersections.hpp"

namespace tetproof::test {
namespace {

using verify::Triangle;
using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;
using Points = std::vector<Eigen::Vector3d>;

Point exact(const Eigen::Vector3d& p) {
  return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}
Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The part of a convex polygon with normal . (p - origin) >= 0.
std::vector<Point> clip(const std::vector<Point>& polygon, const Point& normal, const Point& origin) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational sp = dot(normal, p - origin), sq = dot(normal, q - origin);
    if (sp >= 0) kept.push_back(p);
    if ((sp < 0 && sq > 0) || (sp > 0 && sq < 0)) {
      const Rational s = sp / (sp - sq);
      kept.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])});
    }
  }
  return kept;
}

// The definition: cut the second triangle down to the first. What remains must lie in the convex hull of the
// common vertices.
bool meet_by_clipping(const Points& points, const Triangle& s, const Triangle& t) {
  const std::array<Point, 3> a{exact(points[s[0]]), exact(points[s[1]]), exact(points[s[2]])};
  std::vector<Point> rest{exact(points[t[0]]), exact(points[t[1]]), exact(points[t[2]])};
  const Point n = cross(a[1] - a[0], a[2] - a[0]);
  rest = clip(rest, n, a[0]);
  rest = clip(rest, {-n[0], -n[1], -n[2]}, a[0]);
  for (int k = 0; k < 3; ++k) rest = clip(rest, cross(n, a[(k + 1) % 3] - a[k]), a[k]);
  if (rest.empty()) return false;
  std::vector<Point> common;
  for (const Index v : s)
    if (std::count(t.begin(), t.end(), v)) common.push_back(exact(points[v]));
  const Point zero{0, 0, 0};
  for (const Point& p : rest) {
    if (common.empty() || common.size() == 3) return true;
    if (common.size() == 1 && p - common[0] != zero) return true;
    if (common.size() == 2 && cross(common[1] - common[0], p - common[0]) != zero) return true;
  }
  return false;
}

bool degenerate(const Points& points, const Triangle& t) {
  return cross(exact(points[t[1]]) - exact(points[t[0]]), exact(points[t[2]]) - exact(points[t[0]])) ==
         Point{0, 0, 0};
}

struct Soup {
  Points points;
  std::vector<Triangle> triangles;
};

Soup random_soup(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Soup soup;
  // Small integers give every special position. The others are in general position, around 0, 1e6 or 1e-9.
  const int kind = static_cast<int>(seed % 5);
  const double scale = kind == 3 ? 1e-9 : 1, shift = kind == 4 ? 1e6 : 0;
  for (int i = 0; i < 14; ++i) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k)
      p[k] = kind < 2 ? static_cast<double>(random() % 3)
                      : shift + scale * static_cast<double>(random() >> 11) * 0x1p-53;
    if (kind == 1) p[2] = 0;  // all in one plane
    soup.points.push_back(p);
  }
  for (int i = 0; i < 16; ++i) {
    Triangle t;
    for (Index& v : t) v = static_cast<Index>(random() % soup.points.size());
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !degenerate(soup.points, t))
      soup.triangles.push_back(t);
  }
  return soup;
}

TEST(Intersections, AgreeWithRationalArithmeticOnSoups) {
  std::int64_t meeting = 0, apart = 0;
  std::array<int, 4> common_vertices{};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Soup soup = random_soup(seed);
    std::vector<std::array<Index, 2>> pairs;
    for (Index i = 0; i < static_cast<Index>(soup.triangles.size()); ++i)
      for (Index j = i + 1; j < static_cast<Index>(soup.triangles.size()); ++j) {
        const Triangle &s = soup.triangles[i], &t = soup.triangles[j];
        const bool meet = meet_by_clipping(soup.points, s, t);
        (meet ? meeting : apart) += 1;
        common_vertices[std::count_if(s.begin(), s.end(),
                                      [&](Index v) { return std::count(t.begin(), t.end(), v) > 0; })] += 1;
        if (meet) pairs.push_back({i, j});
        ASSERT_EQ(verify::triangles_meet(soup.points, s, t), meet) << i << " and " << j;
        ASSERT_EQ(verify::triangles_meet(soup.points, t, s), meet) << j << " and " << i;
      }
    const verify::Intersections found = verify::self_intersections(soup.points, soup.triangles, {});
    ASSERT_EQ(found.pairs, pairs);
    ASSERT_EQ(found.count, static_cast<std::int64_t>(pairs.size()));
    // If near pairs are asked for, too, the search takes another path to the same pairs.
    const verify::Near near(soup.points, soup.triangles);
    ASSERT_EQ(verify::self_intersections(soup.points, soup.triangles, {}, 100000, &near).pairs, pairs);
  }
  EXPECT_GT(meeting, 500);
  EXPECT_GT(apart, 500);
  for (const int count : {0, 1, 2, 3}) EXPECT_GT(common_vertices[count], 5) << count << " common vertices";
}

// A power of two along an axis changes no digit, and not which triangles meet. It once did: where products
// of coordinates underflowed, the filter in front of the exact test dismissed pairs that meet.
TEST(Intersections, AreTheSameAtEveryPowerOfTwo) {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Soup soup = random_soup(seed);
    const auto pairs = verify::self_intersections(soup.points, soup.triangles, {}).pairs;
    for (const auto& [x, y, z] : std::initializer_list<std::array<int, 3>>{{-1000, -1000, -1000},
                                                                           {-700, -700, -700},
                                                                           {-540, -540, -540},
                                                                           {-522, -522, -522},
                                                                           {-340, -340, -340},
                                                                           {400, 400, 400},
                                                                           {511, 511, 511},
                                                                           {930, 930, 930},
                                                                           {0, -600, 600},
                                                                           {-900, 0, 0},
                                                                           {900, 900, -900},
                                                                           {0, 0, -40}}) {
      Soup other = soup;
      bool same_digits = true;
      for (std::size_t i = 0; i < soup.points.size(); ++i) {
        Eigen::Vector3d& p = other.points[i];
        p = {std::ldexp(p[0], x), std::ldexp(p[1], y), std::ldexp(p[2], z)};
        same_digits = same_digits && p.allFinite() &&
                      Eigen::Vector3d(std::ldexp(p[0], -x), std::ldexp(p[1], -y), std::ldexp(p[2], -z)) ==
                          soup.points[i];
      }
      if (!same_digits) continue;
      ++judged;
      SCOPED_TRACE(testing::Message() << "seed " << seed << " times 2^ " << x << ' ' << y << ' ' << z);
      EXPECT_EQ(verify::self_intersections(other.points, other.triangles, {}).pairs, pairs);
      const verify::Near near(other.points, other.triangles);
      EXPECT_EQ(verify::self_intersections(other.points, other.triangles, {}, 100000, &near).pairs, pairs);
    }
  }
  EXPECT_GT(judged, 400);
}

// With few triangles, and with so many that they are searched in slabs.
class CrumpledSphere : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, CrumpledSphere, testing::Values(2000, 80000));

TEST_P(CrumpledSphere, IntersectsItselfWhereCgalSays) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  TriangleSurface sphere = corpus::make_surface("sphere:r=1,n=" + std::to_string(GetParam()));
  std::mt19937_64 random(1);
  for (Eigen::Vector3d& p : sphere.vertices)
    for (int k = 0; k < 3; ++k)
      p[k] += 0.12 * std::sqrt(2000.0 / GetParam()) * static_cast<double>(random() >> 11) * 0x1p-53;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const auto& p : sphere.vertices)
    vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())));
  for (const auto& t : sphere.triangles)
    ASSERT_NE(mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]), Mesh::null_face());
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> theirs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(theirs));
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [f, g] : theirs) {
    const auto [low, high] = std::minmax({static_cast<Index>(f), static_cast<Index>(g)});
    pairs.push_back({low, high});
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_GT(pairs.size(), 50u);
  EXPECT_EQ(verify::self_intersections(sphere.vertices, sphere.triangles, {}, pairs.size() + 1).pairs, pairs);
  const verify::Near near(sphere.vertices, sphere.triangles);
  EXPECT_EQ(verify::self_intersections(sphere.vertices, sphere.triangles, {}, pairs.size() + 1, &near).pairs,
            pairs);
}

TEST(Intersections, FirstPairsAndFullCount) {
  Soup soup;
  for (int i = 0; i < 25; ++i) {  // each of one kind meets each of the other
    const double x = i / 64.0;
    soup.points.insert(soup.points.end(),
                       {{x, -2, -2}, {x, 3, -2}, {x, 0, 3}, {-1, x, -2}, {2, x, -2}, {0.2, x, 3}});
    soup.triangles.push_back({6 * i, 6 * i + 1, 6 * i + 2});
    soup.triangles.push_back({6 * i + 3, 6 * i + 4, 6 * i + 5});
  }
  const verify::Intersections all = verify::self_intersections(soup.points, soup.triangles, {});
  const verify::Intersections first = verify::self_intersections(soup.points, soup.triangles, {}, 10);
  ASSERT_EQ(all.count, 25 * 25);
  EXPECT_EQ(first.count, all.count);
  EXPECT_EQ(first.pairs, (std::vector(all.pairs.begin(), all.pairs.begin() + 10)));
}

}  // namespace
}  // namespace tetproof::test
