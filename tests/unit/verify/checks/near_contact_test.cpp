// SPDX-License-Identifier: GPL-3.0-or-later
// Near contacts: parts of the boundary whose distance is within rounding, but which do not touch.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;

TEST(NearContact, BlocksThatAllButTouch) {
  const TetMesh block = lattice_mesh({1, 1, 1});
  struct Gap {
    double width;
    bool near;
  };
  for (const Gap& gap : {Gap{1e-15, true}, {1e-13, true}, {1e-10, false}, {0.1, false}}) {
    SCOPED_TRACE(gap.width);
    const TetMesh mesh = together(block, lattice_mesh({1, 1, 1}, {}, {1 + gap.width, 0.25, 0.3}, 0.5));
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), gap.near ? Ids{"near-contact"} : Ids{}) << report_text(report);
    EXPECT_TRUE(sound(report));
    EXPECT_EQ(report.certificate, true);
    if (!gap.near) continue;
    EXPECT_EQ(report[Check::near_contact].verdict, Verdict::warning);
    EXPECT_NEAR(*report[Check::near_contact].measured, gap.width, 4e-16);
    EXPECT_EQ(report[Check::near_contact].findings[0].faces.size(), 2u);
    EXPECT_EQ(report[Check::near_contact].findings[0].tets.size(), 2u);
  }
}

TEST(NearContact, EdgesThatAllButTouch) {
  // An edge of one tetrahedron crosses over an edge of another one.
  for (const auto& [gap, near] : {std::pair{1e-13, true}, {1e-10, false}}) {
    const TetMesh mesh{{{-1, 0, 0},
                        {1, 0, 0},
                        {0.1, 1, -1},
                        {0, -1, -1},
                        {0, -1, gap},
                        {0, 1, gap},
                        {1, 0.1, 1},
                        {-1, 0, 1}},
                       {{0, 2, 1, 3}, {4, 5, 6, 7}}};
    TetMesh positive = mesh;
    for (auto& tet : positive.tets)
      if ((mesh.points[tet[1]] - mesh.points[tet[0]])
              .cross(mesh.points[tet[2]] - mesh.points[tet[0]])
              .dot(mesh.points[tet[3]] - mesh.points[tet[0]]) < 0)
        std::swap(tet[0], tet[1]);
    EXPECT_EQ(roots(verify::verify(positive)), near ? Ids{"near-contact"} : Ids{});
  }
}

// Blocks of very different sizes side by side: each face is measured by its own size.
TEST(NearContact, TinyBlocksAreNotNearThemselves) {
  const Report report = verify::verify(
      together(lattice_mesh({2, 2, 2}, {}, {1, 0, 0}), lattice_mesh({12, 12, 12}, {}, {0, 0, 0}, 1e-14)));
  EXPECT_EQ(report.certificate, true) << report_text(report);
  EXPECT_EQ(roots(report), Ids{}) << report_text(report);
  EXPECT_TRUE(sound(report)) << report_text(report);
}

// Narrow tetrahedra all around a point, with their tips so close to it that all are near each other:
// quadratically many pairs. The report then says that it did not look for what is near, and proves the rest.
TEST(NearContact, ACrowdOfTipsEndsTheSearch) {
  TetMesh mesh;
  constexpr int count = 700;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, turn = i * 2.399963229728653;
    const Eigen::Vector3d out(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn),
                              z);
    const Eigen::Vector3d side = out.unitOrthogonal(), other = out.cross(side);
    const auto first = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(1e-13 * out);
    for (const Eigen::Vector3d& offset :
         {side, Eigen::Vector3d(other - side), Eigen::Vector3d(-other - side)})
      mesh.points.push_back(out + 0.01 * offset);
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, true) << report_text(report);
  EXPECT_EQ(report[Check::near_contact].verdict, Verdict::skipped);
  EXPECT_EQ(report[Check::hanging_node].verdict, Verdict::skipped);
  EXPECT_EQ(report[Check::boundary_self_intersection].verdict, Verdict::pass);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_THAT(report.notes[0], testing::StartsWith("more than 1000000 pairs of boundary faces are near"));
  EXPECT_FALSE(sound(report));
}

TEST(NearContact, ShortEdgesAreNone) {
  // One layer of cells has a thickness of 1e-14 of the lattice. Everything in it is near everything else, but
  // it is connected.
  for (const double thin : {1e-14, 1e-13, 3e-13, 1e-12}) {
    TetMesh mesh = lattice_mesh({4, 3, 3});
    for (Eigen::Vector3d& p : mesh.points)
      for (int k = 0; k < 3; ++k) p[k] = p[k] == 0 ? 0 : p[k] == 1 ? thin : p[k] - 1;
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{}) << thin << report_text(report);
  }
}

}  // namespace
}  // namespace tetproof::test
