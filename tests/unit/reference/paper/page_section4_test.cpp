// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4 of the page and its parametric surfaces, against calculation by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/reference/paper/page_cube.hpp"

namespace tetproof::reference::paper {
namespace {

const double least = std::nextafter(0.0, 1.0);

TEST(PageQuality, OfKnownTetrahedra) {
  const Corners right_angled{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
  const Corners regular{Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)};
  // At the right-angled corner an eighth of the sphere. At the others, the three dihedral angles less pi:
  // 2 arctan(sqrt 2) + pi/2 - pi.
  EXPECT_NEAR(solid_angle(smallest_solid_angle(right_angled)),
              (2 * std::atan(std::sqrt(2.0)) - std::numbers::pi / 2) / (4 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(solid_angle(smallest_solid_angle(regular)), std::acos(23.0 / 27) / (4 * std::numbers::pi),
              1e-15);
  // D/A: the largest face, of area sqrt(3)/2, has the smallest distance, 1/sqrt(3).
  EXPECT_NEAR(aspect_ratio(right_angled), (1 / std::sqrt(3.0)) / (std::sqrt(3.0) / 2), 1e-15);
  EXPECT_NEAR(aspect_ratio(regular), (4 / std::sqrt(3.0)) / (2 * std::sqrt(3.0)), 1e-15);
}

// Two or three tetrahedra on five points: a triangle of radius 1 and an edge through its middle.
TEST(PageFlips, TheBetterOfTwoTriangulations) {
  const double s = std::sqrt(0.75);
  const auto flips = [&](double up, double down, bool two, Criterion criterion) {
    const std::vector<Point> points{{1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}, {0.01, 0, up}, {0, 0.01, -down}};
    const TriangleSurface surface = cube();
    int records = 0;
    Options options{.adapt = AdaptOptions{.improve = criterion}};
    options.listener.record = [&](const trace::Record& record) {
      const auto& flip = std::get<trace::Flip>(record);
      ++records;
      EXPECT_EQ(flip.two_to_three, two);
      EXPECT_EQ(flip.face, (std::array{points[0], points[1], points[2]}));
      EXPECT_EQ(flip.edge, (std::array{points[3], points[4]}));
      EXPECT_GT(flip.quality_after, flip.quality_before);
    };
    Page page(surface, options);
    give_grid(page, points, {},
              two ? std::vector<Tet>{{0, 1, 2, 3}, {0, 2, 1, 4}}
                  : std::vector<Tet>{{3, 4, 1, 0}, {3, 4, 2, 1}, {3, 4, 0, 2}});
    page.improve(two ? Numbers{0, 1} : Numbers{0, 1, 2});
    EXPECT_EQ(records, page.flips_);
    for (const auto& [number, tet] : page.tets_) EXPECT_TRUE(Page::positive(page.corners(tet.v)));
    return std::pair(records, page.tets_.size());
  };
  using Made = std::pair<int, std::size_t>;
  for (const Criterion criterion : {Criterion::solid_angle, Criterion::aspect_ratio}) {
    // High: each half is well shaped, the three are needles.
    EXPECT_EQ(flips(3, 3, true, criterion), (Made{0, 2}));
    EXPECT_EQ(flips(3, 3, false, criterion), (Made{1, 2}));
    // One half is flat: the three share what there is.
    EXPECT_EQ(flips(0.6, 0.05, true, criterion), (Made{1, 3}));
    EXPECT_EQ(flips(0.6, 0.05, false, criterion), (Made{0, 3}));
  }
}

TEST(PageFlips, OnlyOfAStrictlyConvexHexahedron) {
  const TriangleSurface surface = cube();
  const auto possible = [&](const Point& up, const Point& down) {
    Page page(surface, {.adapt = AdaptOptions{}});
    give_grid(page, {{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, up, down}, {}, {{0, 1, 2, 3}, {0, 2, 1, 4}});
    return page.flip_of({0, 1}).has_value();
  };
  EXPECT_TRUE(possible({0, 0, 0.2}, {0, 0, -0.2}));
  EXPECT_FALSE(possible({2, 0, 0.2}, {2, 0, -0.2})) << "the edge passes outside the triangle";
  EXPECT_FALSE(possible({1, 0, 0.2}, {1, 0, -0.2})) << "through a vertex";
  EXPECT_FALSE(possible({-0.5, 0, 0.2}, {-0.5, 0, -0.2})) << "through an edge";
  EXPECT_TRUE(possible({std::nextafter(-0.5, 0), 0, 0.2}, {std::nextafter(-0.5, 0), 0, -0.2}));
  EXPECT_FALSE(possible({0, 0, 0.2}, {0, 0, 0.1})) << "both on one side";
}

TEST(PageFlips, TheSetHasThePiecesAndTheFaceNeighbours) {
  // 0123 was replaced by 0 1 2 5 and others; 1 2 3 4 shares a face with it, 0 1 4 6 only an edge.
  const TriangleSurface surface = cube();
  Page page(surface, {.adapt = AdaptOptions{}});
  give_grid(page, std::vector<Point>(7, Point(0, 0, 0)), {}, {{1, 2, 3, 4}, {0, 1, 4, 6}, {0, 1, 2, 5}});
  EXPECT_EQ(page.surroundings({0, 1, 2, 3}, {2}), (Numbers{0, 2}));
}

TEST(PageFaces, MeetByTheNumberOfCommonVertices) {
  const Face base{{0, 1, 2}, {Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)}};
  struct Case {
    const char* what;
    Face face;
    bool meet;
  };
  const Case cases[]{
      {"apart", {{3, 4, 5}, {Point(0, 0, 1), Point(4, 0, 1), Point(0, 4, 1)}}, false},
      {"through", {{3, 4, 5}, {Point(1, 1, 1), Point(1, 1, -1), Point(9, 9, 0)}}, true},
      {"touching in a point", {{3, 4, 5}, {Point(1, 1, 0), Point(1, 1, 1), Point(1, 2, 1)}}, true},
      {"the least double above", {{3, 4, 5}, {Point(1, 1, least), Point(1, 1, 1), Point(1, 2, 1)}}, false},
      {"coplanar, apart", {{3, 4, 5}, {Point(4, 4, 0), Point(5, 4, 0), Point(4, 5, 0)}}, false},
      {"coplanar, overlapping", {{3, 4, 5}, {Point(1, 1, 0), Point(5, 4, 0), Point(4, 5, 0)}}, true},
      {"coplanar, within", {{3, 4, 5}, {Point(1, 1, 0), Point(2, 1, 0), Point(1, 2, 0)}}, true},
      {"a common vertex", {{0, 4, 5}, {Point(0, 0, 0), Point(-1, 0, 1), Point(0, -1, 1)}}, false},
      {"a common vertex, through", {{0, 4, 5}, {Point(0, 0, 0), Point(1, 1, 1), Point(1, 1, -1)}}, true},
      {"a common vertex, an edge upon the face",
       {{4, 0, 5}, {Point(1, 1, 0), Point(0, 0, 0), Point(0, -1, 1)}},
       true},
      {"a common edge", {{1, 0, 5}, {Point(4, 0, 0), Point(0, 0, 0), Point(1, 1, 3)}}, false},
      {"a common edge, flat beside", {{1, 0, 5}, {Point(4, 0, 0), Point(0, 0, 0), Point(1, -1, 0)}}, false},
      {"a common edge, folded flat", {{1, 0, 5}, {Point(4, 0, 0), Point(0, 0, 0), Point(1, 3, 0)}}, true},
      {"a common edge, folded almost flat",
       {{5, 1, 0}, {Point(1, 3, least), Point(4, 0, 0), Point(0, 0, 0)}},
       false},
      {"the same", base, true}};
  for (const Case& c : cases) {
    EXPECT_EQ(faces_meet(base, c.face), c.meet) << c.what;
    EXPECT_EQ(faces_meet(c.face, base), c.meet) << c.what;
  }
}

// The unit square, mapped to a height that depends on (u,v).
TriangleSurface square(const std::function<double(double, double)>& height) {
  TriangleSurface s;
  s.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const auto& t : s.triangles) {
    std::array<Eigen::Vector2d, 3> uv;
    for (int i = 0; i < 3; ++i) uv[i] = s.vertices[t[i]].head<2>();
    s.parameters.push_back(uv);
  }
  s.evaluate = [height](const Eigen::Vector2d& uv) { return Point(uv.x(), uv.y(), height(uv.x(), uv.y())); };
  return s;
}

TEST(PageParametric, APointGoesToWhereItsClosestPointIsMapped) {
  const TriangleSurface s = square([](double u, double v) { return u * v; });
  const Page page(s, {});
  EXPECT_TRUE(page.is_parametric());
  EXPECT_EQ(page.on_parametric_surface({0.5, 0.25, 0.75}), Point(0.5, 0.25, 0.125));
  EXPECT_EQ(page.on_parametric_surface({0.25, 0.5, -3}), Point(0.25, 0.5, 0.125));
  EXPECT_EQ(page.on_parametric_surface({1, 1, 0}), Point(1, 1, 1));
  EXPECT_EQ(page.on_parametric_surface({3, 0.5, 0}), Point(1, 0.5, 0.5)) << "the closest point is on an edge";
  const TriangleSurface none = square([](double, double) { return NAN; });
  EXPECT_EQ(Page(none, {}).on_parametric_surface({0.5, 0.25, 7}), Point(0.5, 0.25, 7));
  EXPECT_FALSE(Page(s, {.parametric = false}).is_parametric());
}

TEST(PageParametric, APointStaysWhereItWouldInvertATetrahedronOrCrossTheBoundary) {
  // One tetrahedron with its apex, a surface point, at a height of 1; another high above it.
  const std::vector<Point> points{{0, 0, 0},     {1, 0, 0},     {0, 1, 0},     {0.25, 0.25, 1},
                                  {0.1, 0.1, 2}, {0.6, 0.1, 2}, {0.1, 0.6, 2}, {0.25, 0.25, 2.5}};
  const auto apex = [&](double height) {
    const TriangleSurface s = square([height](double, double) { return height; });
    std::vector<trace::Mapped> records;
    Options options;
    options.listener.record = [&](const trace::Record& record) {
      records.push_back(std::get<trace::Mapped>(record));
    };
    Page page(s, options);
    give_grid(page, points, {3}, {{0, 1, 2, 3}, {4, 5, 6, 7}});
    page.map_grid();
    EXPECT_EQ(records.size(), 1u);
    EXPECT_EQ(records.at(0).from, points[3]);
    EXPECT_EQ(records.at(0).to, page.points_[3]);
    EXPECT_EQ(page.mapped_ + page.not_mapped_, 1);
    EXPECT_EQ(page.mapped_ == 1, page.points_[3] != points[3]);
    return page.points_[3].z();
  };
  EXPECT_EQ(apex(1.5), 1.5);
  EXPECT_EQ(apex(0.001), 0.001);
  EXPECT_EQ(apex(0), 1) << "flat";
  EXPECT_EQ(apex(-1), 1) << "inverted";
  EXPECT_EQ(apex(2), 1) << "touches the other tetrahedron's lower face";
  EXPECT_EQ(apex(std::nextafter(2, 0)), std::nextafter(2, 0));
  EXPECT_EQ(apex(2.3), 1) << "through that face";
}

TEST(PageParametric, ANewPointOfASplitMustNotCrossTheBoundary) {
  const TriangleSurface s = square([](double, double) { return -0.5; });
  Page page(s, {.adapt = AdaptOptions{}});
  // The lower face of the first tetrahedron is on the surface. The second lies below it.
  give_grid(
      page,
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -0.4}, {1, 0, -0.4}, {0, 1, -0.4}, {0, 0, -0.8}},
      {0, 1, 2}, {{0, 1, 2, 3}, {4, 6, 5, 7}});
  const Split split = page.split_of(page.tets_.at(0));
  EXPECT_EQ(tables::table4[split.row].name, "3b");
  EXPECT_TRUE(split.moved);
  EXPECT_EQ(split.point.z(), -0.5);
  EXPECT_TRUE(page.crosses_boundary(page.tets_.at(0).v, split));
  Split above = split;
  above.point.z() = -0.3;
  EXPECT_FALSE(page.crosses_boundary(page.tets_.at(0).v, above));
  page.tets_.at(0).left = true;
  EXPECT_EQ(page.split_of(page.tets_.at(0)).point, Point(1.0 / 3, 1.0 / 3, 0)) << "left in place";
}

}  // namespace
}  // namespace tetproof::reference::paper
