// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks: coincident faces that are not shared, because each side has its own copies of the points.
#include <gmock/gmock.h>

#include <functional>
#include <map>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;

// The mesh with own points for the tetrahedra that `apart` selects.
TetMesh cracked(const TetMesh& mesh, const std::function<bool(Index)>& apart) {
  TetMesh bad = mesh;
  std::map<Index, Index> own;
  std::vector<std::uint8_t> kept(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index v : mesh.tets[t])
      if (!apart(static_cast<Index>(t))) kept[v] = 1;
  for (std::size_t t = 0; t < bad.tets.size(); ++t) {
    if (!apart(static_cast<Index>(t))) continue;
    for (Index& v : bad.tets[t]) {
      if (!kept[v]) continue;
      const auto [at, added] = own.try_emplace(v, static_cast<Index>(bad.points.size()));
      if (added) bad.points.push_back(mesh.points[v]);
      v = at->second;
    }
  }
  return bad;
}

TEST(Crack, BetweenTwoHalves) {
  const TetMesh mesh = lattice_mesh({4, 2, 2});
  const Report report = verify::verify(cracked(mesh, [](Index t) { return t >= 2 * 2 * 2 * 6; }));
  EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  EXPECT_EQ(report[Check::crack].count, 8);
  EXPECT_EQ(report[Check::duplicate_point].consequences, 9);
  EXPECT_EQ(report[Check::duplicate_point].count, 0);
  EXPECT_EQ(report.certificate, false);
  const verify::Finding& finding = report[Check::crack].findings[0];
  EXPECT_EQ(finding.tets.size(), 2u);
  EXPECT_EQ(finding.faces.size(), 2u);
  EXPECT_EQ(finding.vertices.size(), 6u);
  EXPECT_EQ(report.mesh.components, 1) << "with its cracks closed";
  EXPECT_DOUBLE_EQ(*report.mesh.volume, 16);
}

TEST(Crack, AroundOneTetrahedron) {
  for (const Index t : {0, 13 * 6}) {
    const Report report = verify::verify(cracked(lattice_mesh({3, 3, 3}), [=](Index i) { return i == t; }));
    EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  }
}

TEST(Crack, EveryTetrahedronForItself) {
  const TetMesh mesh = lattice_mesh({12, 12, 12});
  TetMesh exploded;
  for (const auto& tet : mesh.tets) {
    const auto first = static_cast<Index>(exploded.points.size());
    for (const Index v : tet) exploded.points.push_back(mesh.points[v]);
    exploded.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  const Report report = verify::verify(exploded);
  EXPECT_EQ(roots(report), Ids{"crack"}) << report_text(report);
  const std::int64_t inner = (4 * 6 * 1728 - 2 * 6 * 144) / 2;
  EXPECT_EQ(report[Check::crack].count, inner);
  EXPECT_EQ(report[Check::duplicate_point].consequences, 13 * 13 * 13) << "every corner has several";
  EXPECT_EQ(report.mesh.boundary_faces, 4 * 6 * 1728) << "as written";
}

TEST(Crack, WhatElseIsWrongIsFoundBehindIt) {
  // A crack between the halves, and a smaller block that overlaps one of them.
  TetMesh bad = cracked(lattice_mesh({4, 2, 2}), [](Index t) { return t >= 2 * 2 * 2 * 6; });
  bad = together(bad, lattice_mesh({1, 1, 1}, {}, {3.25, 0.25, 0.25}, 0.5));
  const Report report = verify::verify(bad);
  EXPECT_EQ(roots(report), (Ids{"crack", "overlap"})) << report_text(report);
  // The same tetrahedron twice, each time with its own points. When the cracks are closed, its faces belong
  // to three tetrahedra.
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  TetMesh twice = cracked(mesh, [](Index t) { return t % 2 == 0; });
  const auto first = static_cast<Index>(twice.points.size());
  for (const Index v : mesh.tets[5]) twice.points.push_back(mesh.points[v]);
  twice.tets.push_back({first, first + 1, first + 2, first + 3});
  const Report again = verify::verify(twice);
  EXPECT_THAT(roots(again), testing::IsSupersetOf({"crack", "duplicate-tet"}));
  EXPECT_EQ(again.certificate, false);
  EXPECT_GT(again[Check::overlap].consequences + again[Check::boundary_self_intersection].consequences, 0)
      << report_text(again);
}

TEST(Crack, TwoBlocksInOnePlaceAreNone) {
  const TetMesh mesh = lattice_mesh({1, 1, 1});
  const Report report = verify::verify(together(mesh, mesh));
  EXPECT_EQ(roots(report), Ids{"duplicate-tet"});
  EXPECT_GT(report[Check::boundary_self_intersection].consequences, 0);
  EXPECT_EQ(report.certificate, false);
}

}  // namespace
}  // namespace tetproof::test
