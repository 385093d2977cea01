// SPDX-License-Identifier: GPL-3.0-or-later
// Overlaps that no single tetrahedron shows: a part of the mesh is inside another part.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;

const TetMesh large{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 1, 2, 3}}};

TEST(Nesting, SmallInsideLarge) {
  struct Case {
    std::string name;
    std::vector<Eigen::Vector3d> points;  // further points, from number 4
    std::array<Index, 4> small;
  };
  const std::vector<Case> cases{
      {"sharing nothing", {{0.5, 0.5, 0.5}, {1, 0.5, 0.5}, {0.5, 1, 0.5}, {0.5, 0.5, 1}}, {4, 5, 6, 7}},
      {"sharing a vertex", {{1, 0.5, 0.5}, {0.5, 1, 0.5}, {0.5, 0.5, 1}}, {0, 4, 5, 6}},
      {"sharing an edge", {{1, 1, 0.5}, {1, 0.5, 1}}, {0, 1, 4, 5}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    TetMesh mesh = large;
    mesh.points.insert(mesh.points.end(), c.points.begin(), c.points.end());
    mesh.tets.push_back(c.small);
    const Report report = verify::verify(mesh);
    ASSERT_EQ(report[Check::inverted].count, 0);
    EXPECT_FALSE(sound(report));
    EXPECT_EQ(report.certificate, false);
    ASSERT_EQ(report[Check::overlap].count, 1) << report_text(report);
    EXPECT_EQ(report[Check::boundary_self_intersection].count, 0);
    const verify::Finding& finding = report[Check::overlap].findings[0];
    EXPECT_EQ(finding.tets, (std::vector<Index>{1, 0}));
    EXPECT_EQ(finding.faces.size(), 1u);
    EXPECT_TRUE(finding.point);
    EXPECT_THAT(finding.point_exact[0], testing::HasSubstr("/"));
  }
}

TEST(Nesting, ConformingBlocksThatInterpenetrate) {
  const TetMesh mesh = together(lattice_mesh({2, 2, 2}), lattice_mesh({2, 2, 2}, {}, {1.3, 1.4, 1.45}));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"boundary-self-intersection"}) << report_text(report);
  EXPECT_EQ(report.certificate, false);
}

TEST(Nesting, BlocksThatTouchWithoutSharingVertices) {
  const TetMesh mesh = together(lattice_mesh({2, 2, 2}), lattice_mesh({2, 2, 2}, {}, {2, 0.25, 0.25}));
  EXPECT_EQ(roots(verify::verify(mesh)), Ids{"non-conforming-interface"});
}

TEST(Nesting, BlockInsideBlockShouldBeACavity) {
  const TetMesh mesh =
      together(lattice_mesh({3, 3, 3}), lattice_mesh({1, 1, 1}, {}, {1.25, 1.25, 1.25}, 0.5));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"overlap"});
  EXPECT_EQ(report[Check::overlap].findings[0].tets.size(), 2u);
  EXPECT_GE(report[Check::overlap].findings[0].tets[0], 162)
      << "the small block's outer side is covered, not the large one's";
  EXPECT_LT(report[Check::overlap].findings[0].tets[1], 162);
}

TEST(Nesting, BlockInsideACavityIsRight) {
  const auto hollow = lattice_mesh({3, 3, 3}, [](Cell c) { return !(c[0] == 1 && c[1] == 1 && c[2] == 1); });
  const TetMesh mesh = together(hollow, lattice_mesh({1, 1, 1}, {}, {1.25, 1.25, 1.25}, 0.5));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, true) << report_text(report);
  EXPECT_EQ(report.mesh.components, 3);
  EXPECT_EQ(report.mesh.cavities, 1);
  EXPECT_DOUBLE_EQ(*report.mesh.volume, 26.125);
}

TEST(Nesting, FoldOverWoundPositive) {
  // A fan that goes nearly twice around an edge: every tetrahedron is positive and every face is matched.
  TetMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (int i = 0; i < 12; ++i) {
    const double angle = i * 1.03, radius = 1 + 0.05 * i;
    mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.5});
    if (i > 0) mesh.tets.push_back({0, static_cast<Index>(i + 1), static_cast<Index>(i + 2), 1});
  }
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::inverted].count, 0);
  EXPECT_EQ(report[Check::face_orientation].count, 0);
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(roots(report), Ids{"boundary-self-intersection"}) << report_text(report);
}

TEST(Nesting, ManyPartsInsideOneAnother) {
  // Boxes in boxes, each overlapping all larger ones, at coordinates around 1e6 and around 1e-9.
  for (const auto& [shift, scale] : {std::pair{0.0, 1.0}, {1e6, 1.0}, {0.0, 1e-9}}) {
    TetMesh mesh;
    for (int i = 0; i < 20; ++i) {
      const double low = shift + scale * i / 64;
      mesh = together(mesh, lattice_mesh({1, 1, 1}, {}, {low, low, low}, scale * (1 - i / 32.0)));
    }
    const Report report = verify::verify(mesh);
    EXPECT_EQ(report[Check::overlap].count, 19);
    EXPECT_EQ(report[Check::boundary_self_intersection].count, 0);
  }
}

TEST(Nesting, OverlapByOneUnitInTheLastPlace) {
  // Two blocks with a common face, one of which is moved. Moved away by one unit the mesh is sound; moved
  // into the other block it intersects itself.
  const TetMesh block = lattice_mesh({1, 1, 1});
  for (const auto& [x, certificate] :
       {std::pair{std::nextafter(1.0, 2.0), true}, {1.0, false}, {std::nextafter(1.0, 0.0), false}}) {
    const TetMesh mesh = together(block, lattice_mesh({1, 1, 1}, {}, {x, 0.25, 0.25}, 0.5));
    EXPECT_EQ(verify::verify(mesh).certificate, certificate);
  }
}

}  // namespace
}  // namespace tetproof::test
