// SPDX-License-Identifier: GPL-3.0-or-later
// Crossed diagonals: quadrilaterals that are cut differently from both sides.
#include <gmock/gmock.h>

#include <limits>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::UnorderedElementsAre;
using verify::Check;
using verify::Report;

// Two pyramids on one square, each cut into two tetrahedra along a different diagonal. `bend` lifts two
// opposite corners of the square.
TetMesh with_crossed_diagonals(double bend) {
  TetMesh mesh{{{0, 0, 0}, {1, 0, bend}, {1, 1, 0}, {0, 1, bend}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
               {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 3, 1, 5}, {1, 3, 2, 5}}};
  return mesh;
}

TEST(CrossedDiagonal, OnAFlatOrRoundedQuadrilateral) {
  const double ulp = std::numeric_limits<double>::denorm_min();
  for (const double bend : {0.0, ulp, -ulp, 1e-16, -1e-16, 1e-13, -1e-13}) {
    SCOPED_TRACE(bend);
    const Report report = verify::verify(with_crossed_diagonals(bend));
    EXPECT_EQ(roots(report), Ids{"crossed-diagonal"}) << report_text(report);
    ASSERT_EQ(report[Check::crossed_diagonal].count, 1);
    const verify::Finding& finding = report[Check::crossed_diagonal].findings[0];
    EXPECT_THAT(finding.vertices, UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_THAT(finding.tets, UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_EQ(finding.faces.size(), 4u);
    EXPECT_FALSE(sound(report));
  }
}

TEST(CrossedDiagonal, OnABentQuadrilateral) {
  // If the square is bent one way the tetrahedra overlap, if it is bent the other way there is a gap between
  // them.
  const Report one = verify::verify(with_crossed_diagonals(0.1)),
               other = verify::verify(with_crossed_diagonals(-0.1));
  const bool first_overlaps = one[Check::crossed_diagonal].count == 1;
  EXPECT_EQ(roots(first_overlaps ? one : other), Ids{"crossed-diagonal"})
      << report_text(one) << report_text(other);
  EXPECT_EQ((first_overlaps ? one : other)[Check::overlap].consequences, 2);
  EXPECT_EQ((first_overlaps ? one : other).certificate, false);
  EXPECT_EQ(roots(first_overlaps ? other : one), Ids{"boundary-nonmanifold-edge"})
      << report_text(one) << report_text(other);
}

TEST(CrossedDiagonal, ATetrahedronCutIntoFourIsSound) {
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}},
               {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}}};
  EXPECT_EQ(roots(verify::verify(mesh)), Ids{});
  for (Eigen::Vector3d& p : mesh.points) p *= 1e-14;  // almost a point beside a large block
  const Report report = verify::verify(together(lattice_mesh({2, 2, 2}), [&] {
    for (Eigen::Vector3d& p : mesh.points) p += Eigen::Vector3d(3, 0, 0);
    return mesh;
  }()));
  EXPECT_EQ(report[Check::crossed_diagonal].count + report[Check::hanging_node].count, 0)
      << report_text(report);
}

// Going by the vertex numbers alone, the outer faces of a tetrahedron that is cut into four look like crossed
// diagonals.
TEST(CrossedDiagonal, ATetrahedronCutIntoFourInsideAnotherIsAnOverlap) {
  const TetMesh mesh{{{0, 0, 0},
                      {4, 0, 0},
                      {0, 4, 0},
                      {0, 0, 4},
                      {0.5, 0.5, 0.5},
                      {1.5, 0.5, 0.5},
                      {0.5, 1.5, 0.5},
                      {0.5, 0.5, 1.5},
                      {0.75, 0.75, 0.75}},
                     {{0, 1, 2, 3}, {8, 5, 6, 7}, {4, 8, 6, 7}, {4, 5, 8, 7}, {4, 5, 6, 8}}};
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::crossed_diagonal].count, 0) << report_text(report);
  EXPECT_EQ(report[Check::overlap].count, 1) << report_text(report);
}

}  // namespace
}  // namespace tetproof::test
