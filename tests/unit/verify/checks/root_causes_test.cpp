// SPDX-License-Identifier: GPL-3.0-or-later
// Root causes: which findings follow from another one and are listed under it, and which stand on their own.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;

TEST(PlantedDefects, ConsequencesStandUnderTheirRoot) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  std::swap(mesh.tets[80][0],
            mesh.tets[80][1]);  // inside: all four faces now have both tetrahedra on one side
  const Report report = verify::verify(mesh);
  ASSERT_EQ(report[Check::inverted].count, 1);
  const auto& consequences = report[Check::inverted].findings[0].consequences;
  ASSERT_EQ(consequences.size(), 1u);
  EXPECT_EQ(consequences[0].check, Check::face_orientation);
  EXPECT_EQ(consequences[0].count, 4);
  EXPECT_EQ(report[Check::face_orientation].count, 0);
  EXPECT_EQ(report[Check::face_orientation].consequences, 4);
  EXPECT_EQ(report[Check::face_orientation].verdict, Verdict::fail);
}

// A defect that only shares a vertex with a broken tetrahedron does not follow from it.
TEST(PlantedDefects, TwoThatShareAVertexStandSideBySide) {
  const TetMesh sound = lattice_mesh({4, 4, 4});
  const auto at = std::find(sound.points.begin(), sound.points.end(), Eigen::Vector3d(2, 2, 2));
  const auto v = static_cast<Index>(at - sound.points.begin());
  std::vector<Index> around;
  for (std::size_t t = 0; t < sound.tets.size(); ++t)
    if (std::count(sound.tets[t].begin(), sound.tets[t].end(), v)) around.push_back(static_cast<Index>(t));
  const auto& wrong = sound.tets[around[0]];
  const auto other = std::find_if(around.begin(), around.end(), [&](Index t) {
    return std::count_if(sound.tets[t].begin(), sound.tets[t].end(),
                         [&](Index w) { return std::count(wrong.begin(), wrong.end(), w); }) == 1;
  });
  ASSERT_NE(other, around.end());
  TetMesh turned = sound;
  std::swap(turned.tets[around[0]][0], turned.tets[around[0]][1]);

  TetMesh missing = turned;
  missing.tets.erase(missing.tets.begin() + *other);
  EXPECT_EQ(roots(verify::verify(missing)), (Ids{"inverted", "cavity"}));

  // A separate small tetrahedron inside that one; it begins at the common vertex.
  TetMesh foreign = turned;
  std::array<Index, 4> small = sound.tets[*other];
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Index w : small) centre += sound.points[w] / 4;
  for (Index& w : small) {
    if (w == v) continue;
    foreign.points.push_back(sound.points[w] / 4 + sound.points[v] / 4 + centre / 2);
    w = static_cast<Index>(foreign.points.size() - 1);
  }
  foreign.tets.push_back(small);
  EXPECT_EQ(roots(verify::verify(foreign)), (Ids{"inverted", "overlap"}));
}

// A boundary in which one face is wound the wrong way encloses no cavity, wherever the mesh is.
TEST(PlantedDefects, AnInvertedTetrahedronAtTheBoundaryMakesNoCavity) {
  for (const double shift : {0.0, 1e6, -1e6}) {
    TetMesh mesh = lattice_mesh({3, 3, 3}, {}, Eigen::Vector3d::Constant(shift));
    std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"inverted"});
    EXPECT_EQ(report[Check::cavity].consequences, 0) << report_text(report);
  }
}

// If the winding number at a face is negative, an inverted tetrahedron covers the place, no matter how far it
// is from the face.
TEST(PlantedDefects, ANegativeCoveringFollowsFromAnInvertedTetrahedron) {
  // A block with a hole. In the hole, and not connected with the block, an inverted tetrahedron around a
  // smaller positive one.
  TetMesh mesh = lattice_mesh({5, 5, 5}, [](Cell c) { return c != Cell{2, 2, 2}; });
  const auto add = [&](double size, bool turned) {
    const auto first = static_cast<Index>(mesh.points.size());
    const Eigen::Vector3d corner = Eigen::Vector3d::Constant(2.5 - size / 4);
    mesh.points.push_back(corner);
    for (int k = 0; k < 3; ++k) mesh.points.push_back(corner + size * Eigen::Vector3d::Unit(k));
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    if (turned) std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
  };
  add(0.3, true);
  add(0.1, false);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::inverted].count, 1);
  EXPECT_EQ(report[Check::overlap].count, 0) << report_text(report);
  EXPECT_GT(report[Check::overlap].consequences, 0) << report_text(report);
}

}  // namespace
}  // namespace tetproof::test
