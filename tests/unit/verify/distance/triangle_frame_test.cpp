// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to triangles of any shape against exact rational arithmetic, and the search for the nearest
// triangle.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>
#include <gtest/gtest.h>

#include <random>

#include "corpus/surfaces.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/triangles/on_triangle.hpp"

namespace tetproof::test {
namespace {

using Point = Eigen::Vector3d;
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using verify::TriangleFrame;

Kernel::Point_3 exact(const Point& p) {
  return {CGAL::Gmpq(p.x()), CGAL::Gmpq(p.y()), CGAL::Gmpq(p.z())};
}

// Exact except for one square root.
double exact_distance(const Point& p, const std::array<Point, 3>& t) {
  const Kernel::Point_3 q = exact(p), a = exact(t[0]), b = exact(t[1]), c = exact(t[2]);
  const auto root = [](const CGAL::Gmpq& squared) { return std::sqrt(CGAL::to_double(squared)); };
  if (!CGAL::collinear(a, b, c)) return root(CGAL::squared_distance(q, Kernel::Triangle_3(a, b, c)));
  const auto to_segment = [&](const Kernel::Point_3& x, const Kernel::Point_3& y) {
    return x == y ? CGAL::squared_distance(q, x) : CGAL::squared_distance(q, Kernel::Segment_3(x, y));
  };
  return root(std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)}));
}

class Random {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  Point point() { return {(*this)() - 0.5, (*this)() - 0.5, (*this)() - 0.5}; }
  double small() { return std::pow(10, -18 * (*this)()); }

 private:
  std::mt19937_64 engine_{77};
};

TEST(TriangleFrame, LosesNothingOnNeedles) {
  Random random;
  double worst = 0;
  for (int i = 0; i < 40000; ++i) {
    std::array<Point, 3> t{random.point(), random.point(), random.point()};
    if (i % 4 > 0) t[2] = t[0] + random() * (t[1] - t[0]) + random.small() * t[2];  // flat
    if (i % 4 > 1) t[1] = t[0] + random.small() * (t[1] - t[0]);                    // and short
    if (i % 97 == 0) t[1] = t[0];
    std::swap(t[0], t[i % 3]);
    Point p = random.point();
    if (i % 5 > 0) {  // near it
      const double s = random(), r = random();
      p = t[0] + s * (t[1] - t[0]) + (1 - s) * r * (t[2] - t[0]) + random.small() * p;
    }
    worst =
        std::max(worst, std::abs(std::sqrt(TriangleFrame::of(t).squared_distance(p)) - exact_distance(p, t)));
  }
  EXPECT_LE(worst, verify::distance_slack / 2) << "what the other half is for: input rounded to units";
  EXPECT_GT(worst, 0) << "nothing was compared";
}

TEST(TriangleFrame, SidesAreNumberedAsTheTriangle) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const std::array<Point, 3> t{random.point(), random.point(), random.point()};
    const TriangleFrame frame = TriangleFrame::of(t);
    for (int k = 0; k < 3; ++k) {
      const Point beyond = (t[k] + t[(k + 1) % 3]) - t[(k + 2) % 3];
      for (int side = 0; side < 3; ++side)
        EXPECT_EQ(frame.beyond(side, frame.place(beyond)) > 1e-12, side == k);
    }
  }
}

TEST(TriangleTree, FindsTheNearest) {
  const TriangleSurface surface = corpus::make_surface("random:seed=5,n=700");
  const verify::TriangleSet set{surface.vertices, surface.triangles};
  const verify::Units units = verify::units_of(std::span(&set, 1));
  const verify::TriangleTree tree(set, units);
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Point p = random.point() * 1.5;
    double least = INFINITY;
    std::vector<Index> within;
    for (Index t = 0; t < static_cast<Index>(tree.size()); ++t) {
      const double d = exact_distance(p, tree.corners(t));
      least = std::min(least, d);
      if (d <= 0.1) within.push_back(t);
    }
    const auto guess = static_cast<Index>(random() * 500);
    EXPECT_NEAR(std::sqrt(tree.nearest(p).squared), least, 1e-14);
    EXPECT_NEAR(std::sqrt(tree.nearest(p, guess).squared), least, 1e-14);
    EXPECT_NEAR(std::sqrt(tree.frame(tree.nearest(p, guess).triangle).squared_distance(p)), least, 1e-14);
    EXPECT_LE(std::sqrt(tree.nearest(p, guess, least + 0.1).squared), least + 0.1);
    std::vector<Index> found;
    EXPECT_TRUE(tree.for_each_within(p, 0.1, [&](Index t) { return found.push_back(t), true; }));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, within);
  }
  for (Index t = 0; t < static_cast<Index>(tree.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index other = tree.across(t, k);
      ASSERT_GE(other, 0);
      const auto& v = surface.triangles[t];
      const auto& w = surface.triangles[other];
      EXPECT_TRUE(std::count(w.begin(), w.end(), v[k]) && std::count(w.begin(), w.end(), v[(k + 1) % 3]));
    }
}

TEST(OnTriangle, IsExact) {
  const std::array<Point, 3> t{Point(0, 0, 0), Point(3, 0, 3), Point(0, 3, 0)};
  EXPECT_TRUE(verify::on_triangle({0, 0, 0}, t));
  EXPECT_TRUE(verify::on_triangle({1, 0, 1}, t));
  EXPECT_TRUE(verify::on_triangle({1, 1, 1}, t));
  EXPECT_TRUE(verify::on_triangle({1.5, 1.5, 1.5}, t));
  EXPECT_FALSE(verify::on_triangle({1.5, std::nextafter(1.5, 2), 1.5}, t));
  EXPECT_FALSE(verify::on_triangle({1, 1, std::nextafter(1, 2)}, t));
  EXPECT_FALSE(verify::on_triangle({-1, 1, -1}, t));
  EXPECT_FALSE(verify::on_triangle({1, 0, 0}, {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)}));
}

}  // namespace
}  // namespace tetproof::test
