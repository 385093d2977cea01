// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3 of the page, steps (v) and (vi), against calculation by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/reference/paper/page_cube.hpp"

namespace tetproof::reference::paper {
namespace {

const std::vector<Point> right_angled{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Options adapting(const AdaptOptions& adapt, bool literal = false) {
  return {.literal = literal, .adapt = adapt};
}

// --- step (v)

TEST(PageEquations, TheWeightOfATetrahedron) {
  const TriangleSurface s = cube();
  Page page(s, adapting({}));
  page.law_ = {.v0 = 1, .v1 = 2, .d1 = std::sqrt(3.0), .p = 1};
  // The centroid (1/4, 1/4, 1/4) has the vertex (0, 0, 0) of the cube at a distance of sqrt(3)/4.
  const Weight w = page.weigh({right_angled[0], right_angled[1], right_angled[2], right_angled[3]});
  EXPECT_DOUBLE_EQ(w.d, std::sqrt(3.0) / 4);
  EXPECT_DOUBLE_EQ(w.volume, 1.0 / 6);
  EXPECT_EQ(w.omega, 1);
  EXPECT_FALSE(w.kappa);
  EXPECT_DOUBLE_EQ(w.desired, 1.25);
  EXPECT_DOUBLE_EQ(w.error, 1.25 - 1.0 / 6);

  // With curvature: kappa of the closest vertex; of several, of the lexicographically smallest.
  page.kappas_ = {2, 3, 4, 2, 2, 2, 2, 2};
  page.kappa_min_ = 2, page.kappa_max_ = 4;
  const auto weight_at = [&page](const Point& centre) {
    Corners t;
    for (std::size_t i = 0; i < 4; ++i) t[i] = right_angled[i] - Point(0.25, 0.25, 0.25) + centre;
    return page.weigh(t);
  };
  EXPECT_EQ(weight_at({0.9, 0.1, 0}).kappa, 3);
  EXPECT_DOUBLE_EQ(weight_at({0.9, 0.1, 0}).omega, 0.55);
  EXPECT_EQ(weight_at({0, 1, 0}).kappa, 4);
  EXPECT_DOUBLE_EQ(weight_at({0, 1, 0}).omega, 0.1);
  EXPECT_EQ(weight_at({0.5, 0, 0}).kappa, 2) << "vertex 0 and vertex 1 are equally close";
  EXPECT_EQ(weight_at({0.5, 1, 0}).kappa, 4) << "vertex 2 and vertex 3 are equally close";
}

TEST(PageEquations, EAvgAfterASplitIsAsPrintedOnlyIfLiteral) {
  const TriangleSurface s = cube();
  for (const bool literal : {false, true}) {
    Page page(s, adapting({}, literal));
    give_grid(page, right_angled, {}, {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}});
    EXPECT_EQ(page.e_avg_after(10, -1, 4), 9.0 / 7);
    EXPECT_EQ(page.e_avg_after(10, -1, 3), literal ? 9.0 / 7 : 9.0 / 6);  // L+3, or L+m-1 (reading D16)
    EXPECT_EQ(page.e_avg_after(10, -1, 2), literal ? 9.0 / 7 : 9.0 / 5);
  }
}

TEST(PageCurvature, OfAQuadricIsExact) {
  // f = (c20 u^2 + 2 c11 u v + c02 v^2) / 2 over a square of 5 x 5 points, which a half turn maps to itself:
  // the normal in its middle is z.
  const auto middle = [](double c20, double c11, double c02) {
    TriangleSurface s;
    for (int v = -2; v <= 2; ++v)
      for (int u = -2; u <= 2; ++u)
        s.vertices.emplace_back(u, v, (c20 * u * u + 2 * c11 * u * v + c02 * v * v) / 2);
    for (int v = 0; v < 4; ++v)
      for (int u = 0; u < 4; ++u) {
        const int a = u + 5 * v, b = a + 1, c = a + 5, d = c + 1;
        s.triangles.push_back({a, b, d});
        s.triangles.push_back({a, d, c});
      }
    return Page(s, {}).absolute_curvature(12);
  };
  EXPECT_NEAR(middle(2, 0, 1), 3, 1e-12);
  EXPECT_NEAR(middle(2, 0, -1), 3, 1e-12);
  EXPECT_NEAR(middle(0, 1.5, 0), 3, 1e-12);  // eigenvalues 1.5 and -1.5
  EXPECT_NEAR(middle(0, 0, 0), 0, 1e-15);
}

TEST(PageCurvature, TakesTheSecondRingWhereTheFirstDoesNotSuffice) {
  // The four neighbours (1,0), (0,1), (-1,0), (0,-1) do not know c11.
  TriangleSurface s;
  const auto f = [](double u, double v) { return Point(u, v, u * v); };
  s.vertices = {f(0, 0), f(1, 0), f(0, 1), f(-1, 0), f(0, -1), f(2, 1), f(-1, 2), f(-2, -1), f(1, -2)};
  s.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 5, 2}, {2, 6, 3}, {3, 7, 4}, {4, 8, 1}};
  EXPECT_NEAR(Page(s, {}).absolute_curvature(0), 2, 1e-12);
  s.triangles.resize(4);
  EXPECT_EQ(Page(s, {}).absolute_curvature(0), 0) << "nor do two rings";
}

// --- Table 4

using Made = std::pair<std::string_view, std::vector<int>>;

Made split_of_first(const std::vector<Point>& points, const std::set<int>& surface_points,
                    const std::vector<Tet>& tets) {
  const TriangleSurface far = far_cube();
  Page page(far, adapting({}));
  give_grid(page, points, surface_points, tets);
  const Split split = page.split_of(page.tets_.at(0));
  EXPECT_EQ(split.on_surface, split.replaced.size() < 4);
  return {tables::table4[split.row].name, split.replaced};
}

TEST(PageTable4, ATetrahedronAlone) {
  const std::vector<Point> points{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  const auto split = [&](const std::set<int>& on_surface) {
    return split_of_first(points, on_surface, {{0, 1, 2, 3}});
  };
  EXPECT_EQ(split({}), (Made{"0", {0, 1, 2, 3}}));
  EXPECT_EQ(split({1}), (Made{"1", {0, 1, 2, 3}}));
  EXPECT_EQ(split({1, 3}), (Made{"2b", {1, 3}}));
  EXPECT_EQ(split({0, 1, 2}), (Made{"3b", {0, 1, 2}}));
  EXPECT_EQ(split({0, 1, 2, 3}), (Made{"4e", {2, 3}}));  // the longest edge: 3-4-5

  const TriangleSurface far = far_cube();
  Page page(far, adapting({}));
  give_grid(page, points, {}, {{0, 1, 2, 3}});
  EXPECT_EQ(page.centroid_of({0, 1, 2, 3}, {0, 1, 2, 3}), Point(0.5, 0.75, 1));
  EXPECT_EQ(page.centroid_of({0, 1, 2, 3}, {0, 1, 2}), Point(2.0 / 3, 1, 0));
  EXPECT_EQ(page.centroid_of({0, 1, 2, 3}, {1, 3}), Point(1, 0, 2));
}

TEST(PageTable4, WithNeighbours) {
  // A large tetrahedron 0123, and small ones at its faces.
  const std::vector<Point> points{{0, 0, 0},         {2, 0, 0},     {0, 3, 0},
                                  {0, 0, 4},         {-0.01, 1, 1}, {1, -0.01, 1},
                                  {0.5, 0.5, -0.01}, {1, 1.2, 1.2}, {0, 1, -0.01}};
  const Tet whole{0, 1, 2, 3}, x{0, 3, 2, 4}, y{0, 1, 3, 5}, z{0, 2, 1, 6}, slanted{1, 2, 3, 7},
      at_edge{0, 2, 8, 4};
  const auto split = [&](std::set<int> on_surface, std::vector<Tet> tets) {
    tets.insert(tets.begin(), whole);
    return split_of_first(points, on_surface, tets);
  };
  const std::set<int> all{0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(split(all, {x, y, z, slanted}), (Made{"4a", {0, 1, 2, 3}}));
  EXPECT_EQ(split(all, {x, y, z}), (Made{"4b", {1, 2, 3}}));
  EXPECT_EQ(split(all, {y, slanted}), (Made{"4c", {0, 2}})) << "the planes x = 0 and z = 0 are unshared";
  EXPECT_EQ(split(all, {y, slanted, at_edge}), (Made{"4c", {0, 2, 3}})) << "their edge is shared: x = 0";
  EXPECT_EQ(split(all, {y}), (Made{"4d", {2, 3}})) << "the longest edge that is no edge of y";
  EXPECT_EQ(split(all, {slanted}), (Made{"4d", {0, 3}}));
  EXPECT_EQ(split({0, 2}, {at_edge}), (Made{"2a", {0, 1, 2, 3}}));
  EXPECT_EQ(split({0, 2}, {y}), (Made{"2b", {0, 2}}));
  EXPECT_EQ(split({0, 1, 3}, {y}), (Made{"3a", {0, 1, 2, 3}}));
  EXPECT_EQ(split({0, 1, 2}, {y}), (Made{"3b", {0, 1, 2}}));
}

TEST(PageTable4, EqualEdgesGoByTheirNumbers) {
  const std::vector<Point> regular{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_EQ(split_of_first(regular, {0, 1, 2, 3}, {{3, 1, 0, 2}}), (Made{"4e", {1, 2}}));  // 1 and 0
}

// --- step (vi)

trace::End end_of(Page& page) {
  page.weigh_grid();
  page.insert_points();
  return {.stopped = page.stopped_, .insertions = page.insertions_, .refused = page.refused_};
}

TEST(PageInsertion, ASplitThatDegeneratesIsRefused) {
  // Too small for doubles to have a point within: the centroid is rounded to a corner.
  const double e = std::nextafter(1.0, 2.0);
  const TriangleSurface far = far_cube();
  Page page(far, adapting({.points = 5, .v0 = {0.001}, .v1 = {0.001}}));
  give_grid(page, {{1, 1, 1}, {e, 1, 1}, {1, e, 1}, {1, 1, e}}, {}, {{0, 1, 2, 3}});
  const trace::End end = end_of(page);
  EXPECT_EQ(end.refused, 1);
  EXPECT_EQ(end.insertions, 0);
  EXPECT_EQ(end.stopped, "no-gain");
}

TEST(PageInsertion, EndsAtAnAverageError) {
  const TriangleSurface far = far_cube();
  std::vector<double> averages;
  Options options = adapting({.v0 = {0.001}, .v1 = {0.001}, .e_avg = {0.05}, .improve = Criterion::none});
  options.listener.record = [&](const trace::Record& record) {
    if (const auto* made = std::get_if<trace::Insertion>(&record)) averages.push_back(made->e_avg);
  };
  Page page(far, options);
  give_grid(page, right_angled, {}, {{0, 1, 2, 3}});
  EXPECT_EQ(end_of(page).stopped, "e-avg");
  const double goal = 0.05 / 6;  // in mean volumes of the first grid
  ASSERT_GE(averages.size(), 2u);
  EXPECT_LE(averages.back(), goal);
  EXPECT_GT(averages[averages.size() - 2], goal);
  EXPECT_EQ(averages.back(), page.e_avg());

  Page absolute(far, adapting({.e_avg = {1, true}}));
  give_grid(absolute, right_angled, {}, {{0, 1, 2, 3}});
  EXPECT_EQ(end_of(absolute).stopped, "e-avg");
  EXPECT_EQ(absolute.insertions_, 0);
}

TEST(PageInsertion, EndsAtANumberOfPointsAndByDilution) {
  const TriangleSurface far = far_cube();
  Page counted(far, adapting({.points = 3, .v0 = {0.001}, .v1 = {0.001}}));
  give_grid(counted, right_angled, {}, {{0, 1, 2, 3}});
  EXPECT_EQ(end_of(counted).stopped, "points");
  EXPECT_EQ(counted.insertions_, 3);
  EXPECT_EQ(counted.points_.size(), 7u);
  const TriangleSurface near = cube();
  Page diluted(near, adapting({}));
  EXPECT_TRUE(diluted.is_diluted({.volume = 1, .desired = 1}));
  EXPECT_FALSE(diluted.is_diluted({.volume = 2, .desired = 1}));
}

// Every split seems to lower the average error, and none does.
class Hopeful : public Page {
 public:
  using Page::Page;
  double e_avg_after(double, double, int) const override { return -1; }
};

TEST(PageInsertion, EndsWhereTheAverageHasNoNewMinimumForLong) {
  const TriangleSurface far = far_cube();
  Hopeful page(
      far,
      adapting(
          {.points = 1100, .v0 = {100}, .v1 = {100}, .past_dilution = true, .improve = Criterion::none}));
  give_grid(page, right_angled, {}, {{0, 1, 2, 3}});
  EXPECT_EQ(end_of(page).stopped, "stalled");
  EXPECT_EQ(page.insertions_, 1000);  // max(1000, L/10), reading D23
}

TEST(PageInsertion, ASplitKeptIsTheSplitEvaluatedAnew) {
  TriangleSurface s = cube();
  for (Point& v : s.vertices) v = (v - Point(0.5, 0.5, 0.5)) * 2 + Point(0.01, 0.02, 0.03).cwiseProduct(v);
  Options options = adapting({.points = 150, .v0 = {0.1}, .v1 = {1}, .improve_below = 0.01});
  options.cells = {4, 0, 0};
  Page page(s, options);
  page.run();
  EXPECT_GT(page.flips_, 0);
  int kept = 0;
  for (const auto& [number, tet] : page.tets_) {
    if (!tet.split) continue;
    ++kept;
    const Split anew = page.split_of(tet);
    EXPECT_EQ(anew.row, tet.split->row);
    EXPECT_EQ(anew.replaced, tet.split->replaced);
    EXPECT_EQ(anew.point, tet.split->point);
    EXPECT_EQ(anew.change, tet.split->change);
  }
  EXPECT_GT(kept, 100);
}

}  // namespace
}  // namespace tetproof::reference::paper
