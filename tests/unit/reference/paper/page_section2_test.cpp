// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2 of the page, steps (i) to (iv), against calculation by hand.
#include <gtest/gtest.h>

#include "corpus/surfaces.hpp"
#include "tests/unit/reference/paper/page_cube.hpp"

namespace tetproof::reference::paper {
namespace {

TEST(PageLattice, ByHand) {
  TriangleSurface s = cube();
  for (Point& v : s.vertices) v.x() *= 2;
  Page page(s, {.cells = {8, 0, 0}, .box_scale = 2});
  page.make_lattice();
  EXPECT_EQ(page.cells_, (std::array{8, 4, 4}));
  EXPECT_EQ(page.planes_[0], (std::vector<double>{-1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5, 3}));
  EXPECT_EQ(page.planes_[2], (std::vector<double>{-0.5, 0, 0.5, 1, 1.5}));
  EXPECT_EQ(page.shortest_edge_, 0.5);
  EXPECT_EQ(page.number({1, 2, 1}), 1 + 9 * (2 + 5 * 1));
  EXPECT_EQ(page.lattice_[page.number({1, 2, 1})], Point(-0.5, 0.5, 0));
  ASSERT_EQ(page.lattice_tets_.size(), 6u * 128);
  EXPECT_EQ(page.lattice_tets_[1], (Tet{0, 1, 1 + 45, 1 + 9 + 45}));  // the path x, z, y
  // Along x, y, z; a diagonal in each square, in xy, xz, yz; a diagonal in each cell.
  EXPECT_EQ(page.edges_.size(), (200u + 180 + 180) + (160 + 160 + 144) + 128);
}

TEST(PageSurface, PointsOfACube) {
  const TriangleSurface s = cube();
  const Page page(s, {});
  for (const Point& p : {Point(0, 0, 0), Point(0.5, 0.5, 1), Point(1, 0.3, 0.1), Point(0, 0.5, 1)})
    EXPECT_TRUE(page.is_on_surface(p));
  for (const Point& p : {Point(0.5, 0.5, 0.5), Point(1e-300, 0.5, 0.5), Point(0.25, 0.25, 0.25)}) {
    EXPECT_FALSE(page.is_on_surface(p));
    EXPECT_TRUE(page.is_inside(p));
  }
  for (const Point& p : {Point(-1e-300, 0.5, 0.5), Point(2, 0, 0), Point(-1, 1, 1), Point(0.5, 0.5, 3)}) {
    EXPECT_FALSE(page.is_on_surface(p));
    EXPECT_FALSE(page.is_inside(p));
  }
  EXPECT_EQ(page.closest_on_surface({0.5, 0.5, 0.75}), Point(0.5, 0.5, 1));
  EXPECT_EQ(page.closest_on_surface({2, 2, 2}), Point(1, 1, 1));
  EXPECT_EQ(page.closest_on_surface({2, -1, 0.25}), Point(1, 0, 0.25));
  EXPECT_EQ(page.closest_on_surface({0.3, 0.7, 1}), Point(0.3, 0.7, 1));
  // Of six closest points, the lexicographically smallest.
  EXPECT_EQ(page.closest_on_surface({0.5, 0.5, 0.5}), Point(0, 0.5, 0.5));
}

// Rounding moves a closest point by as much as the vertex is away from the surface here: the triangle whose
// rounded point is closest must not be passed over because its box is farther away.
TEST(PageSurface, TheClosestPointIsThatOfAllTriangles) {
  const TriangleSurface s = corpus::make_surface("terrain:seed=32215911,m=4");
  Page page(s, {.cells = {6, 0, 0}, .box_scale = 1.5});
  page.make_lattice();
  int rounded = 0;
  for (const Point& p : page.lattice_) {
    if (page.is_on_surface(p)) continue;
    Point best = page.triangles_[0][0];
    for (const Triangle& t : page.triangles_) {
      const Point q = closest_point(t, p);
      const double now = (q - p).squaredNorm(), before = (best - p).squaredNorm();
      if (now < before || (now == before && lexicographically_less(q, best))) best = q;
    }
    EXPECT_EQ(page.closest_on_surface(p), best) << p.transpose();
    rounded += (best - p).norm() < 1e-15;
  }
  EXPECT_GT(rounded, 10);
}

TEST(PageEdges, ThatMeetACube) {
  const TriangleSurface s = cube();
  const Page page(s, {});
  const auto inner = [&](const Point& p, const Point& q) { return page.intersect(p, q).inner; };
  using Inner = std::vector<Rational>;
  const Rational quarter(1, 4), half(1, 2), rest(3, 4);
  const Point outside(-0.5, 0.5, 0.25);
  EXPECT_EQ(inner(outside, {1.5, 0.5, 0.25}), (Inner{quarter, rest}));
  EXPECT_EQ(inner(outside, {0.5, 0.5, 0.25}), Inner{half});
  EXPECT_EQ(inner(outside, {0, 0.5, 0.25}), Inner{}) << "at the end: not of the open edge";
  EXPECT_EQ(inner({0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}), Inner{});
  EXPECT_EQ(inner({-1, 1, 0.5}, {1, -1, 0.5}), Inner{half}) << "touches an edge";
  EXPECT_EQ(inner({-0.5, 0.5, 1}, {1.5, 0.5, 1}), (Inner{quarter, rest})) << "in a face: two triangles";
  EXPECT_EQ(inner({-0.5, 0, 1}, {1.5, 0, 1}), (Inner{quarter, rest})) << "along an edge";
  EXPECT_EQ(inner({-1, 0, 1}, {1, 2, 1}), Inner{half}) << "a face's plane, a vertex";
  EXPECT_TRUE(page.intersect({-0.5, 0.5, 1}, {1.5, 0.5, 1}).along);
  EXPECT_FALSE(page.intersect(outside, {1.5, 0.5, 0.25}).along);

  const auto place = [&](const Point& p, const Point& q) {
    const EdgePoints met = page.intersect(p, q);
    return page.place_of_cut(p, q, met, met.inner.at(0));
  };
  EXPECT_EQ(place(outside, {0.5, 0.5, 0.25}), Point(0, 0.5, 0.25));
  EXPECT_EQ(place({-1, 0.5, 0.25}, {2, 0.5, 0.25}), Point(-1 + (1.0 / 3) * 3, 0.5, 0.25));
  EXPECT_EQ(place({-0.5, 0.5, 1}, {1.5, 0.5, 1}), Point(0, 0.5, 1)) << "where the edge begins to run along";
}

TEST(PageIndicators, AreZeroOnlyForVerticesExactlyOnTheSurface) {
  // The closest point of the vertex (1,3,1) is computed as the vertex itself, but it lies 2^-56 outside.
  const TriangleSurface s = corpus::make_surface("octahedron:rx=3,ry=2.5,rz=0.5");
  Page page(s, {.cells = {4, 6, 3}, .on_surface = 0});
  page.make_lattice();
  const int v = page.number({1, 3, 1});
  ASSERT_EQ(page.closest_on_surface(page.lattice_[v]), page.lattice_[v]);
  ASSERT_FALSE(page.is_on_surface(page.lattice_[v]));
  page.characterize();
  EXPECT_EQ(page.initial_[v], -1);
}

TEST(PageIndicators, AskedForBothSignsIsExterior) {
  const TriangleSurface s = cube();
  const Page page(s, {});
  EXPECT_EQ(page.asked_for({1}), 1);
  EXPECT_EQ(page.asked_for({-1}), -1);
  EXPECT_EQ(page.asked_for({-1, 1}), -1);
}

TEST(PageIndicators, AnEdgeWithoutItsIntersectionIsAnInternalError) {
  TriangleSurface open = cube();
  open.triangles.erase(open.triangles.begin() + 6, open.triangles.begin() + 8);  // without the face y = 1
  Page page(open, {.cells = {3, 3, 3}});
  page.make_lattice();
  try {
    page.characterize();
    FAIL() << "the lattice's edges along y leave the cube without meeting it";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("(E6)"), std::string::npos);
  }
}

TEST(PageExtraction, OfACubeInLatticePlanes) {
  // The lattice's planes are -1/2, 1/2 and 3/2: one vertex is inside, and each of its 14 edges has a cut.
  const TriangleSurface s = cube();
  Page page(s, {.cells = {2, 2, 2}, .box_scale = 2});
  page.make_lattice();
  page.characterize();
  const Grid grid = page.extract();
  EXPECT_EQ(page.cuts_.size(), 14u);
  EXPECT_EQ(grid.mesh.tets.size(), 24u);  // the lattice tetrahedra at the vertex; the others are outside
  EXPECT_EQ(grid.surface_points.size(), 14u);
  EXPECT_EQ(std::count(page.rows_.begin(), page.rows_.end(), "6"), 24);
  EXPECT_EQ(std::count(page.rows_.begin(), page.rows_.end(), "1"), 24);
  EXPECT_EQ(page.not_positive_, 0);
  Rational volume = 0;
  for (const auto& [a, b, c, d] : grid.mesh.tets) {
    const auto& p = grid.mesh.points;
    EXPECT_EQ(orientation(p[a], p[b], p[c], p[d]), 1);
    volume += determinant(p[a], p[b], p[c], p[d]) / 6;
  }
  // The cuts are the cube's face centres, edge middles along the face diagonals, and two opposite corners.
  EXPECT_EQ(volume, Rational(1, 2));
}

}  // namespace
}  // namespace tetproof::reference::paper
