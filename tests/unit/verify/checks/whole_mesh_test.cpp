// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that concern the mesh as a whole are named once, and the judge tells what hides behind them.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using verify::Check;
using verify::Report;
using verify::Verdict;

using Runs = std::vector<std::array<Index, 2>>;

void turn(TetMesh& mesh, std::size_t first, std::size_t last) {
  for (std::size_t t = first; t < last; ++t) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
}

void shift(TetMesh& mesh, Index by) {
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v += by;
}

// The checks that fail in the mended mesh.
Ids remaining(const Report& report) {
  Ids ids;
  if (!report.if_mended) return {"nothing was mended"};
  for (const auto& result : report.if_mended->checks)
    if (result.verdict == Verdict::fail) ids.push_back(info(result.check).id);
  return ids;
}

TEST(WholeMesh, ASoundMeshHasNoSuchFault) {
  EXPECT_FALSE(verify::verify(lattice_mesh({2, 2, 2})).if_mended);
}

TEST(WholeMesh, TheOtherVertexOrderIsOneFinding) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  turn(mesh, 0, 48);
  const Report report = verify::verify(mesh);
  EXPECT_TRUE(defective(report));
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(roots(report), Ids{"inverted"});
  ASSERT_EQ(report[Check::inverted].count, 1);
  const auto& finding = report[Check::inverted].findings[0];
  EXPECT_EQ(finding.tet_runs, (Runs{{0, 47}}));
  EXPECT_THAT(finding.what,
              HasSubstr("all 48 tetrahedra are negative: their vertices are in the other order"));
  ASSERT_TRUE(report.if_mended);
  EXPECT_EQ(report.if_mended->how, "48 tetrahedra in the other vertex order");
  EXPECT_EQ(report.if_mended->certificate, true);
  EXPECT_EQ(remaining(report), Ids{});
}

// In a file with the other vertex order the tetrahedra that are positive are the inverted ones.
TEST(WholeMesh, BehindTheOtherOrderThePositiveOnesAreInverted) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  turn(mesh, 3, 48);
  const Report report = verify::verify(mesh);
  ASSERT_EQ(report[Check::inverted].count, 1);
  EXPECT_THAT(report[Check::inverted].findings[0].what, HasSubstr("45 of 48 tetrahedra are negative"));
  EXPECT_EQ(report[Check::inverted].findings[0].tet_runs, (Runs{{3, 47}}));
  ASSERT_TRUE(report.if_mended);
  const auto& inverted = report.if_mended->checks[static_cast<std::size_t>(Check::inverted)];
  ASSERT_EQ(inverted.count, 3);
  EXPECT_EQ(inverted.findings[2].tets, std::vector<Index>{2});
}

// Nine tenths are nearly all, and less is not.
TEST(WholeMesh, NineTenthsAreNearlyAll) {
  for (const std::size_t negative : {26u, 27u, 28u}) {
    TetMesh mesh = lattice_mesh({5, 1, 1});
    ASSERT_EQ(mesh.tets.size(), 30u);
    turn(mesh, 0, negative);
    const Report report = verify::verify(mesh);
    EXPECT_EQ(report[Check::inverted].count, negative < 27 ? static_cast<std::int64_t>(negative) : 1);
    EXPECT_EQ(report.if_mended.has_value(), negative >= 27);
  }
}

TEST(WholeMesh, OneRegionInTheOtherOrder) {
  TetMesh mesh = lattice_mesh({4, 1, 1});
  std::vector<std::int64_t> regions(24, 7);
  for (std::size_t t = 12; t < 24; ++t) regions[t] = 3;
  turn(mesh, 12, 24);
  const Report report = verify::verify(mesh, {.regions = regions});
  EXPECT_EQ(roots(report), Ids{"inverted"});
  ASSERT_EQ(report[Check::inverted].count, 1);
  EXPECT_THAT(report[Check::inverted].findings[0].what,
              HasSubstr("all 12 tetrahedra of region 3 are negative: their vertices are in the other order"));
  EXPECT_EQ(report[Check::inverted].findings[0].tet_runs, (Runs{{12, 23}}));
  EXPECT_EQ(report.if_mended->how, "12 tetrahedra of region 3 in the other vertex order");
  EXPECT_EQ(report.if_mended->certificate, true);
  // A region that a file names is called as it is there.
  for (std::int64_t& region : regions) region = region == 3 ? 1 : 0;
  const Report named = verify::verify(
      mesh, {.regions = regions, .region_tags = {{"entity", 7, ""}, {"physical", 3, "steel"}}});
  EXPECT_EQ(named.if_mended->how, "12 tetrahedra of physical 3 (steel) in the other vertex order");
  EXPECT_THAT(named[Check::inverted].findings[0].what,
              HasSubstr("all 12 tetrahedra of physical 3 (steel) are"));
  // Without the regions, they are twelve defects.
  EXPECT_EQ(verify::verify(mesh)[Check::inverted].count, 12);
}

// Two blocks share the points of a side, which each cuts along another diagonal.
TEST(WholeMesh, CrossedDiagonalsBehindTheOtherOrderAreFound) {
  TetMesh mesh = lattice_mesh({2, 1, 1});
  // The mirrored second cell has its other diagonal in the common side.
  for (std::size_t t = 6; t < 12; ++t)
    for (Index& v : mesh.tets[t]) {
      const Eigen::Vector3d p = mesh.points[v], mirrored(p.x(), 1 - p.y(), p.z());
      v = static_cast<Index>(std::find(mesh.points.begin(), mesh.points.end(), mirrored) -
                             mesh.points.begin());
    }
  turn(mesh, 6, 12);
  ASSERT_EQ(roots(verify::verify(mesh)), Ids{"crossed-diagonal"});
  turn(mesh, 0, 12);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.if_mended->how, "12 tetrahedra in the other vertex order");
  EXPECT_THAT(remaining(report), testing::Contains("crossed-diagonal"));
  EXPECT_EQ(report.if_mended->checks[static_cast<std::size_t>(Check::crossed_diagonal)].count, 1);
  EXPECT_THAT(
      report_text(report),
      HasSubstr("judged again with 12 tetrahedra in the other vertex order: no certificate; this remains\n"
                "  FAIL crossed-diagonal: 1\n"));
}

TEST(WholeMesh, ShiftedNumbersAreOneFinding) {
  for (const Index by : {-1, 1, 2}) {
    SCOPED_TRACE(by);
    TetMesh mesh = lattice_mesh({3, 2, 2});
    shift(mesh, by);
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"index-range"}) << report_text(report);
    ASSERT_EQ(report[Check::index_range].count, 1);
    const auto& finding = report[Check::index_range].findings[0];
    EXPECT_THAT(finding.what, HasSubstr(by == -1  ? "all vertex numbers are 1 too low, as if numbers from 0 "
                                                    "were read as numbers from 1: "
                                        : by == 1 ? "all vertex numbers are 1 too high, as if numbers from "
                                                    "1 were read as numbers from 0: "
                                                  : "all vertex numbers are 2 too high: "));
    EXPECT_EQ(finding.tet_runs, (Runs{{0, 71}}));
    EXPECT_EQ(report[Check::unused_point].consequences, std::abs(by));
    EXPECT_EQ(report.if_mended->certificate, true);
    EXPECT_EQ(report.if_mended->how, by == -1  ? "all vertex numbers 1 higher"
                                     : by == 1 ? "all vertex numbers 1 lower"
                                               : "all vertex numbers 2 lower");
  }
}

// The last points are used by nobody, so that every shifted number has its point.
TEST(WholeMesh, AShiftIsFoundWhereAllNumbersHavePoints) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  mesh.points.push_back({9, 9, 9});
  mesh.points.push_back({7, 8, 9});
  shift(mesh, 2);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"index-range"}) << report_text(report);
  EXPECT_THAT(report[Check::index_range].findings[0].what,
              HasSubstr("all vertex numbers are 2 too high: 0 tetrahedra name points that do not exist"));
}

TEST(WholeMesh, ShiftedAndInTheOtherOrder) {
  TetMesh mesh = lattice_mesh({3, 2, 2});
  turn(mesh, 0, 72);
  shift(mesh, 1);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"index-range"});
  EXPECT_EQ(report.if_mended->how, "all vertex numbers 1 lower, 72 tetrahedra in the other vertex order");
  EXPECT_EQ(report.if_mended->certificate, true);
}

// A single wrong number beside an unused point is no shift of all numbers.
TEST(WholeMesh, OneNumberTooHighIsNoShift) {
  TetMesh mesh = lattice_mesh({3, 2, 2});
  shift(mesh, 1);
  mesh.points.insert(mesh.points.begin(), {5, 5, 5});  // the first point is used by nobody
  ASSERT_TRUE(sound(verify::verify(mesh)));
  mesh.tets[40][2] = static_cast<Index>(mesh.points.size());
  const Report report = verify::verify(mesh);
  ASSERT_EQ(report[Check::index_range].count, 1);
  EXPECT_EQ(report[Check::index_range].findings[0].what, "names a point that does not exist");
  EXPECT_FALSE(report.if_mended);
}

TEST(WholeMesh, TheMeshTwice) {
  const TetMesh once = lattice_mesh({2, 2, 2});
  const Report report = verify::verify(together(once, once));
  EXPECT_EQ(roots(report), Ids{"duplicate-tet"}) << report_text(report);
  ASSERT_EQ(report[Check::duplicate_tet].count, 1);
  const auto& finding = report[Check::duplicate_tet].findings[0];
  EXPECT_EQ(finding.tet_runs, (Runs{{0, 47}, {48, 95}}));
  EXPECT_THAT(finding.what, HasSubstr("the mesh stands twice: 48 of 96 tetrahedra, with equal coordinates"));
  EXPECT_GT(report[Check::boundary_self_intersection].consequences, 0);
  EXPECT_EQ(report[Check::duplicate_point].consequences, 27);
  ASSERT_TRUE(report.if_mended);
  EXPECT_EQ(report.if_mended->how, "one of each set of equal tetrahedra (48 left out)");
  EXPECT_EQ(report.if_mended->certificate, true);
  for (const auto& result : report.if_mended->checks)
    EXPECT_TRUE(result.verdict == Verdict::pass || result.verdict == Verdict::skipped)
        << info(result.check).id;
}

// Also in another order of points and tetrahedra.
TEST(WholeMesh, APartOfTheMeshTwice) {
  const TetMesh once = lattice_mesh({3, 3, 3});
  TetMesh part = once;
  part.tets.assign({once.tets[70], once.tets[20], once.tets[71]});
  std::reverse(part.points.begin(), part.points.end());
  for (auto& tet : part.tets)
    for (Index& v : tet) v = static_cast<Index>(part.points.size()) - 1 - v;
  const Report report = verify::verify(together(once, part));
  ASSERT_EQ(report[Check::duplicate_tet].count, 1);
  const auto& finding = report[Check::duplicate_tet].findings[0];
  EXPECT_EQ(finding.tets, (std::vector<Index>{20, 163, 70, 162, 71, 164}));
  EXPECT_THAT(finding.what, HasSubstr("3 tetrahedra stand there again, with equal coordinates"));
  EXPECT_EQ(report.if_mended->certificate, true);
}

// What the mended mesh says of its points it says in the numbers of the file.
TEST(WholeMesh, WhatRemainsIsNamedAsInTheFile) {
  const TetMesh once = lattice_mesh({2, 1, 1});
  TetMesh mesh = once;
  mesh.tets.assign({once.tets[0]});  // the copy comes first, with points of its own
  mesh = together(mesh, once);       // points 12 to 23, tetrahedra 1 to 12
  std::swap(mesh.tets[9][0], mesh.tets[9][1]);
  const Report report = verify::verify(mesh);
  ASSERT_TRUE(report.if_mended);
  const auto& inverted = report.if_mended->checks[static_cast<std::size_t>(Check::inverted)];
  ASSERT_EQ(inverted.count, 1);
  EXPECT_EQ(inverted.findings[0].tets, std::vector<Index>{9});
}

TEST(WholeMesh, FarAndTinyMeshesTwice) {
  for (const double size : {1e-200, 1e-9, 1e200}) {
    const TetMesh once = lattice_mesh({2, 1, 1}, {}, {0, 0, 0}, size);
    EXPECT_EQ(roots(verify::verify(together(once, once))), Ids{"duplicate-tet"}) << size;
  }
}

}  // namespace
}  // namespace tetproof::test
