// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in which nothing is right: verify does not crash, and its search ends.
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>

#include "tests/support/meshes.hpp"
#include "verify/triangles/intersections.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;

TEST(PlantedDefects, NothingOfItCrashes) {
  // Every tetrahedron is unusable, in all ways at once.
  TetMesh mesh = lattice_mesh({2, 2, 2});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t % 3 == 0) mesh.tets[t] = {-5, 1000, 3, 3};
    if (t % 3 == 1) mesh.tets[t][0] = mesh.tets[t][1];
  }
  for (std::size_t i = 0; i < mesh.points.size(); i += 2) mesh.points[i].z() = std::nan("");
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, false);
  EXPECT_FALSE(report_json(report).empty());
  EXPECT_EQ(verify::verify(TetMesh{}).mesh.tets, 0);
  EXPECT_EQ(verify::verify(TetMesh{{}, {{0, 1, 2, 3}}})[Check::index_range].count, 1);
}

// With random vertices, quadratically many faces meet. The search must end, say so, and give the same report
// for any number of threads. A run that is asked only for overlaps must find them, too.
TEST(PlantedDefects, ManyThousandRandomTetrahedra) {
  TetMesh mesh = lattice_mesh({8, 8, 8});
  std::mt19937 random(3);
  const auto points = static_cast<Index>(mesh.points.size());
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v = static_cast<Index>(random() % static_cast<unsigned>(points));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, false);
  const auto& meeting = report[Check::boundary_self_intersection];
  EXPECT_EQ(meeting.count + meeting.consequences, verify::most_counted_pairs);
  EXPECT_EQ(report[Check::hanging_node].verdict, Verdict::skipped);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("more than 1000000 pairs of boundary faces meet"), std::string::npos);
  const Report alone = verify::verify(mesh, {.check = {"overlap"}});
  EXPECT_EQ(alone[Check::overlap].verdict, Verdict::fail);
  ASSERT_FALSE(alone[Check::overlap].findings.empty());
  EXPECT_TRUE(alone[Check::overlap].findings[0].point);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(report_json(verify::verify(mesh)), report_json(report));
}

}  // namespace
}  // namespace tetproof::test
