// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: qualities of known tetrahedra, and which flips are found.
#include "reference/engine/adaptation/improve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/engine/first_grid/exact.hpp"
#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using Tet = std::array<Vector3d, 4>;

const Tet regular{Vector3d(1, 1, 1), Vector3d(1, -1, -1), Vector3d(-1, 1, -1),
                  Vector3d(-1, -1, 1)};  // edge 2 sqrt 2
const Tet corner{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)};

TEST(SolidAngle, OfKnownTetrahedra) {
  const double regular_angle = std::acos(23.0 / 27);  // at each vertex
  EXPECT_NEAR(std::tan(regular_angle / 2), smallest_solid_angle(regular), 1e-15);
  EXPECT_NEAR(solid_angle_of(smallest_solid_angle(regular)), regular_angle / (4 * std::numbers::pi), 1e-16);
  // The solid angle at the right angle is pi/2. At each other vertex the dihedral angles are pi/2 and twice
  // arccos(1/sqrt 3), and by Girard's theorem the solid angle is their sum minus pi.
  const double slanted = std::acos(1 / std::sqrt(3.0));
  const double other = std::numbers::pi / 2 + 2 * slanted - std::numbers::pi;
  EXPECT_NEAR(solid_angle_of(smallest_solid_angle(corner)), other / (4 * std::numbers::pi), 1e-16);
}

TEST(SolidAngle, DoesNotDependOnOrderScaleOrPlace) {
  Tet t{Vector3d(0.3, 0.1, 0), Vector3d(5, 0.25, 1), Vector3d(1, 4, 0), Vector3d(2, 1, 3)};
  const double angle = smallest_solid_angle(t), ratio = aspect_ratio(t);
  for (Vector3d& p : t) p = 4 * p;
  EXPECT_EQ(smallest_solid_angle(t), angle);
  EXPECT_EQ(aspect_ratio(t), ratio / 4);
  std::rotate(t.begin(), t.begin() + 1, t.end());
  EXPECT_NEAR(smallest_solid_angle(t), angle, 1e-15);
  EXPECT_NEAR(dimensionless_aspect_ratio(t),
              ratio * std::sqrt([&] {
                double largest = 0;
                for (const auto& [i, j, k] : tet_faces)
                  largest = std::max(largest, (t[j] - t[i]).cross(t[k] - t[i]).norm() / 32);
                return largest;
              }()),
              1e-14);
}

TEST(AspectRatio, IsTheSmallestHeightOverItsFace) {
  const double edge = 2 * std::sqrt(2.0), area = std::sqrt(3.0) / 4 * edge * edge,
               height = edge * std::sqrt(2.0 / 3);
  EXPECT_NEAR(aspect_ratio(regular), height / area, 1e-15);
  EXPECT_NEAR(dimensionless_aspect_ratio(regular), height / std::sqrt(area), 1e-15);
  const double slanted = std::sqrt(3.0) / 2;  // the largest face of the cube's corner, at distance 1/sqrt 3
  EXPECT_NEAR(aspect_ratio(corner), 1 / std::sqrt(3.0) / slanted, 1e-15);
}

// A bipyramid over the triangle 0 1 2 with the apexes 3 (above) and 4 (below), as two or as three tetrahedra.
struct Bipyramid {
  double above, below;
  Vector3d over{0, 0, 0};  // the place that the apexes are above and below

  std::vector<Vector3d> points() const {
    return {
        {2, 0, 0}, {-1, 1.75, 0}, {-1, -1.75, 0}, over + Vector3d(0, 0, above), over - Vector3d(0, 0, below)};
  }
  Triangulation as_two() const { return make({{0, 1, 2, 3}, {0, 2, 1, 4}}); }
  Triangulation as_three() const { return make({{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}}); }
  Triangulation make(std::vector<Corners> tets) const {
    TetMesh mesh{points(), std::move(tets)};
    EXPECT_EQ(exact_mesh::fault(mesh), "");
    return Triangulation(std::move(mesh), std::vector<std::uint8_t>(5, 0));
  }
};

TEST(Flips, FlatBipyramidGetsTwoTetrahedraAndATallOneThree) {
  for (const Criterion criterion : {Criterion::solid_angle, Criterion::aspect_ratio}) {
    const Bipyramid flat{0.3, 0.3}, tall{9, 9};
    const auto two_of_flat = flat.as_two(), three_of_flat = flat.as_three(), two_of_tall = tall.as_two(),
               three_of_tall = tall.as_three();
    ASSERT_EQ(possible_flips(two_of_flat, {0, 1}, criterion).size(), 1u);
    ASSERT_EQ(possible_flips(three_of_flat, {0, 1, 2}, criterion).size(), 1u);
    // One direction raises the smallest quality, the other one lowers it by the same amount.
    for (const Bipyramid& b : {flat, tall}) {
      const auto to_three = possible_flips(b.as_two(), {0, 1}, criterion)[0];
      const auto to_two = possible_flips(b.as_three(), {0, 1, 2}, criterion)[0];
      EXPECT_EQ(to_three.before, to_two.after);
      EXPECT_EQ(to_three.after, to_two.before);
      EXPECT_EQ(to_three.gain(), -to_two.gain());
      EXPECT_EQ(to_three.face, (std::array<Index, 3>{0, 1, 2}));
      EXPECT_EQ(to_two.edge, (std::array<Index, 2>{3, 4}));
      EXPECT_TRUE(to_three.two_to_three());
      EXPECT_FALSE(to_two.two_to_three());
    }
    EXPECT_NE(best_flip(two_of_flat, {0, 1}, criterion).has_value(),
              best_flip(three_of_flat, {0, 1, 2}, criterion).has_value());
    EXPECT_NE(best_flip(two_of_tall, {0, 1}, criterion).has_value(),
              best_flip(three_of_tall, {0, 1, 2}, criterion).has_value());
  }
  EXPECT_TRUE(best_flip(Bipyramid{0.3, 0.3}.as_three(), {0, 1, 2}, Criterion::solid_angle).has_value() ||
              best_flip(Bipyramid{9, 9}.as_three(), {0, 1, 2}, Criterion::solid_angle).has_value());
}

TEST(Flips, QualitiesAreThoseOfTheTetrahedra) {
  const Bipyramid b{1, 2};
  const auto points = b.points();
  const auto flip = possible_flips(b.as_two(), {0, 1}, Criterion::solid_angle).at(0);
  double before = 1, after = 1;
  for (const auto& t : {std::array{0, 1, 2, 3}, {0, 1, 2, 4}})
    before = std::min(before, smallest_solid_angle({points[t[0]], points[t[1]], points[t[2]], points[t[3]]}));
  for (const auto& t : {std::array{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}})
    after = std::min(after, smallest_solid_angle({points[t[0]], points[t[1]], points[t[2]], points[t[3]]}));
  EXPECT_EQ(flip.before, before);
  EXPECT_EQ(flip.after, after);
}

TEST(Flips, OnlyWithinTheSet) {
  EXPECT_TRUE(possible_flips(Bipyramid{1, 1}.as_two(), {0}, Criterion::solid_angle).empty());
  EXPECT_TRUE(possible_flips(Bipyramid{1, 1}.as_three(), {0, 2}, Criterion::solid_angle).empty());
}

TEST(Flips, OnlyOfStrictlyConvexHexahedra) {
  // The edge between the apexes passes outside the triangle, or exactly through its side, or just inside.
  const Bipyramid beside{1, 1, {-1.5, 0, 0}}, through_side{1, 1, {-1, 0, 0}},
      just_inside{1, 1, {std::nextafter(-1, 0), 0, 0}};
  EXPECT_TRUE(possible_flips(beside.as_two(), {0, 1}, Criterion::solid_angle).empty());
  EXPECT_TRUE(possible_flips(through_side.as_two(), {0, 1}, Criterion::solid_angle).empty());
  EXPECT_EQ(possible_flips(just_inside.as_two(), {0, 1}, Criterion::solid_angle).size(), 1u);
}

TEST(Flips, NotAroundAnEdgeOfFour) {
  const std::vector<Vector3d> points{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  std::vector<Corners> tets{{2, 3, 1, 0}, {3, 4, 1, 0}, {4, 5, 1, 0}, {5, 2, 1, 0}};
  TetMesh mesh{points, tets};
  ASSERT_EQ(exact_mesh::fault(mesh), "");
  const Triangulation grid(mesh, std::vector<std::uint8_t>(6, 0));
  // Two neighbours form a pyramid over a flat square, which is not strictly convex. Three of four tetrahedra
  // do not form a closed ring.
  EXPECT_TRUE(possible_flips(grid, {0, 1, 2, 3}, Criterion::solid_angle).empty());
}

TEST(Flips, ExchangeKeepsTheVolumeAndConforms) {
  for (const bool from_two : {true, false}) {
    Triangulation grid = from_two ? Bipyramid{1, 2}.as_two() : Bipyramid{1, 2}.as_three();
    const std::vector<Index> all = from_two ? std::vector<Index>{0, 1} : std::vector<Index>{0, 1, 2};
    const auto volume = exact_mesh::volume6(grid.mesh());
    const auto flip = possible_flips(grid, all, Criterion::solid_angle).at(0);
    const Index first = grid.replace(flip.old, flip.fresh);
    EXPECT_EQ(exact_mesh::volume6(grid.mesh()), volume);
    EXPECT_EQ(exact_mesh::fault(grid.mesh()), "");
    EXPECT_EQ(updated_set(all, flip, first).size(), from_two ? 3u : 2u);
    // The reverse flip.
    const auto back = possible_flips(grid, updated_set(all, flip, first), Criterion::solid_angle).at(0);
    EXPECT_EQ(back.gain(), -flip.gain());
    EXPECT_EQ(back.face, flip.face);
    EXPECT_EQ(back.edge, flip.edge);
  }
}

}  // namespace
}  // namespace tetproof::reference
