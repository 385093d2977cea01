// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that touch along faces that do not match, and findings that are meant.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "corpus/generators/random.hpp"
#include "corpus/truth.hpp"
#include "io/error.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using verify::Check;
using verify::Report;
using verify::Verdict;

const verify::Options allow_interfaces{.allow = {"non-conforming-interface"}};

// A block of two cells a side, and on its side x = 2 another one with cells of another size.
TetMesh blocks(double size, int cells, Eigen::Vector3d at = {2, 0, 0}) {
  return together(lattice_mesh({2, 2, 2}), lattice_mesh({1, cells, cells}, {}, at, size));
}

TEST(Interfaces, TwoBlocksThatDoNotMatchTouch) {
  // 8 faces of the one on 18 of the other.
  const Report report = verify::verify(blocks(2.0 / 3, 3));
  EXPECT_TRUE(defective(report));
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(roots(report), Ids{"non-conforming-interface"}) << report_text(report);
  ASSERT_EQ(report[Check::non_conforming_interface].count, 1);
  const auto& finding = report[Check::non_conforming_interface].findings[0];
  EXPECT_EQ(finding.faces.size(), 26u);
  EXPECT_THAT(finding.what, HasSubstr("8 faces of one part lie on 18 of the other"));
  EXPECT_GT(report[Check::boundary_self_intersection].consequences, 26);
}

TEST(Interfaces, AreMeantWhereTheyAreAllowed) {
  const Report report = verify::verify(blocks(2.0 / 3, 3), allow_interfaces);
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report.certificate, true);
  ASSERT_EQ(report.allowed.size(), 1u);
  EXPECT_EQ(report.allowed[0].check, Check::non_conforming_interface);
  EXPECT_EQ(report.allowed[0].count, 1);
  for (const Check check : {Check::non_conforming_interface, Check::boundary_self_intersection})
    EXPECT_EQ(report[check].verdict, Verdict::warning);
  EXPECT_THAT(
      report_text(report),
      testing::StartsWith("sound: certified except for what is allowed (1 non-conforming-interface)"));
  EXPECT_TRUE(verify::verify(lattice_mesh({2, 2, 2}), allow_interfaces).allowed.empty());
}

TEST(Interfaces, AllowedOnesHideNothingElse) {
  TetMesh inverted = blocks(2.0 / 3, 3);
  std::swap(inverted.tets.back()[0], inverted.tets.back()[1]);
  EXPECT_TRUE(defective(verify::verify(inverted, allow_interfaces)));

  // A small tetrahedron inside the first block, which touches nothing.
  TetMesh inside = blocks(2.0 / 3, 3);
  inside = together(inside, lattice_mesh({1, 1, 1}, {}, {0.4, 0.2, 0.1}, 0.01));
  const Report report = verify::verify(inside, allow_interfaces);
  EXPECT_TRUE(defective(report));
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(report[Check::overlap].verdict, Verdict::fail);

  // One that crosses the interface.
  TetMesh across = blocks(2.0 / 3, 3);
  across = together(across, lattice_mesh({1, 1, 1}, {}, {1.9, 0.5, 0.5}, 0.2));
  EXPECT_TRUE(defective(verify::verify(across, allow_interfaces)));

  // An unrelated contact in an edge.
  TetMesh edge = together(blocks(2.0 / 3, 3), lattice_mesh({1, 1, 1}, {}, {-1, -1, 0.5}));
  EXPECT_TRUE(defective(verify::verify(edge, allow_interfaces)));
}

// A block inside another one also lies on the outer side of faces that touch a third one.
TEST(Interfaces, APartBehindTheOneThatTouchesIsAnOverlap) {
  TetMesh mesh = blocks(2.0 / 3, 3);
  mesh = together(mesh, lattice_mesh({1, 1, 1}, {}, {2.05, 0.05, 0.05}, 0.5));
  const Report report = verify::verify(mesh, allow_interfaces);
  EXPECT_TRUE(defective(report)) << report_text(report);
  EXPECT_EQ(report.certificate, false);
}

TEST(Interfaces, ByOneUnitIsNoInterface) {
  const double below = std::nextafter(2.0, 0.0), above = std::nextafter(2.0, 3.0);
  const Report overlapping = verify::verify(blocks(2.0 / 3, 3, {below, 0, 0}), allow_interfaces);
  EXPECT_EQ(overlapping[Check::non_conforming_interface].count, 0);
  EXPECT_TRUE(defective(overlapping));
  EXPECT_EQ(overlapping.certificate, false);
  const Report slit = verify::verify(blocks(2.0 / 3, 3, {above, 0, 0}), allow_interfaces);
  EXPECT_EQ(slit[Check::non_conforming_interface].count, 0);
  EXPECT_EQ(slit.certificate, true);
}

// In an edge or in a vertex no area is common.
TEST(Interfaces, ContactInAnEdgeIsNone) {
  const Report report = verify::verify(blocks(2.0 / 3, 3, {2, 2, 0.1}));
  EXPECT_EQ(roots(report), Ids{"boundary-self-intersection"}) << report_text(report);
}

// Both lie on the same side of the plane.
TEST(Interfaces, OnTheSameSideTheyOverlap) {
  const TetMesh mesh = together(lattice_mesh({2, 2, 2}), lattice_mesh({3, 3, 3}, {}, {0, 0, 0}, 0.4));
  const Report report = verify::verify(mesh, allow_interfaces);
  EXPECT_EQ(report[Check::non_conforming_interface].count, 0);
  EXPECT_TRUE(defective(report));
}

TEST(Interfaces, EachPairOfPartsIsOne) {
  // A block between two others.
  const TetMesh mesh = together(blocks(2.0 / 3, 3), lattice_mesh({1, 3, 3}, {}, {-2.0 / 3, 0, 0}, 2.0 / 3));
  const Report report = verify::verify(mesh, allow_interfaces);
  EXPECT_EQ(report[Check::non_conforming_interface].count, 2);
  EXPECT_TRUE(sound(report)) << report_text(report);
}

// Points that both parts use do not make them one part.
TEST(Interfaces, PartsMayHaveCommonPoints) {
  TetMesh mesh = blocks(2.0 / 3, 3);
  const auto at = [&](std::size_t from, const Eigen::Vector3d& p) {
    return static_cast<Index>(
        std::find(mesh.points.begin() + static_cast<std::ptrdiff_t>(from), mesh.points.end(), p) -
        mesh.points.begin());
  };
  const Index first = at(0, {2, 0, 0}), second = at(27, {2, 0, 0});
  ASSERT_LT(second, static_cast<Index>(mesh.points.size()));
  for (auto& tet : mesh.tets)
    for (Index& v : tet)
      if (v == second) v = first;
  const Report report = verify::verify(mesh, allow_interfaces);
  EXPECT_EQ(report[Check::non_conforming_interface].count, 1);
  EXPECT_FALSE(defective(report)) << report_text(report);
  EXPECT_EQ(report.certificate, true);
}

TEST(Interfaces, WithoutTheCheckTheMeetingsFail) {
  verify::Options options = allow_interfaces;
  options.skip = {"non-conforming-interface"};
  const Report report = verify::verify(blocks(2.0 / 3, 3), options);
  EXPECT_GT(report[Check::boundary_self_intersection].count, 0);
  EXPECT_TRUE(defective(report));
}

// Blocks on a coarse lattice overlap, touch in faces, edges and vertices, or match. Brute force in integers
// tells which of them overlap.
TEST(Interfaces, ACertificateMeansThatNothingOverlaps) {
  corpus::Random random(7);
  int certified = 0, overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    TetMesh mesh = lattice_mesh({1, 1, 1});
    const int more = 1 + random.below(3);
    for (int k = 0; k < more; ++k) {
      const auto at = [&] { return random.below(7) / 2.0 - 1.5; };
      const Eigen::Vector3d origin(at(), at(), at());
      mesh = together(mesh, lattice_mesh({1, 1, 1}, {}, origin, 0.5 + random.below(3) / 2.0));
    }
    const Report report = verify::verify(mesh, {.allow = {"crack", "non-conforming-interface"}});
    const corpus::Truth truth = corpus::truth(mesh);
    const bool overlap = !truth.overlaps.empty() || !truth.copies.empty();
    if (report.certificate == true) {
      EXPECT_FALSE(overlap) << i << report_text(report);
    }
    if (report[Check::non_conforming_interface].count > 0) {
      EXPECT_FALSE(truth.touching_faces.empty()) << i << report_text(report);
    }
    // Two blocks that touch in an area and do not overlap are an interface, or match.
    if (more == 1 && !overlap && !truth.touching_faces.empty()) {
      EXPECT_EQ(report.certificate, true) << i << report_text(report);
    }
    certified += report.certificate == true && !report.allowed.empty();
    overlapping += overlap;
  }
  EXPECT_GT(certified, 15);
  EXPECT_GT(overlapping, 50);
}

TEST(Allowed, CracksAreMeant) {
  const TetMesh mesh = together(lattice_mesh({2, 2, 2}), lattice_mesh({2, 2, 2}, {}, {2, 0, 0}));
  const Report failing = verify::verify(mesh);
  EXPECT_EQ(failing[Check::crack].count, 8);
  EXPECT_EQ(failing.certificate, false);
  const Report report = verify::verify(mesh, {.allow = {"crack"}});
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report.certificate, true);
  ASSERT_EQ(report.allowed.size(), 1u);
  EXPECT_EQ(report.allowed[0].count, 8);
  EXPECT_EQ(report[Check::crack].verdict, Verdict::warning);
}

TEST(Allowed, OnlyChecksThatCanBeMeant) {
  for (const char* id : {"inverted", "boundary-self-intersection", "volume-surface", "no-check"})
    EXPECT_THROW(verify::verify(lattice_mesh({1, 1, 1}), {.allow = {id}}), InputError) << id;
}

}  // namespace
}  // namespace tetproof::test
