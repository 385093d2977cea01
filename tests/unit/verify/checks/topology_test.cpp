// SPDX-License-Identifier: GPL-3.0-or-later
// Compares each component of the mesh's boundary with the component of the surface that it should be.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using verify::Check;
using verify::Finding;
using verify::Region;
using verify::Report;
using verify::Verdict;

Report judged(const TetMesh& mesh, const TriangleSurface& surface, Region region = Region::inside) {
  return verify::verify(mesh, surface, {.region = region, .voxels = 0, .check = {"topology"}});
}

const auto around_the_middle = [](Cell c) { return c[0] != 1 || c[1] != 1; };
const auto hollow = [](Cell c) { return c != Cell{1, 1, 1}; };

TEST(Topology, GenusIsComparedComponentByComponent) {
  // A ring and a block, and the same two with exchanged places: the total numbers are equal.
  const TetMesh mesh =
      together(lattice_mesh({3, 3, 3}, around_the_middle), lattice_mesh({3, 3, 3}, {}, {5, 0, 0}));
  const TetMesh other =
      together(lattice_mesh({3, 3, 3}), lattice_mesh({3, 3, 3}, around_the_middle, {5, 0, 0}));
  EXPECT_EQ(judged(mesh, boundary_surface(mesh))[Check::topology].verdict, Verdict::pass);
  const Report report = judged(mesh, boundary_surface(other));
  ASSERT_EQ(report[Check::topology].count, 2) << report_text(report);
  for (const Finding& finding : report[Check::topology].findings) {
    ASSERT_EQ(finding.faces.size(), 1u);
    const bool at_ring = mesh.points[static_cast<std::size_t>(finding.faces[0][0])].x() < 4;
    EXPECT_THAT(finding.what,
                HasSubstr(at_ring ? "has genus 1, the surface's" : "has genus 0, the surface's"));
    EXPECT_THAT(finding.what, HasSubstr(at_ring ? ") has 0" : ") has 1"));
  }
}

TEST(Topology, WhatIsMissingOrTooMuchIsNamed) {
  const TetMesh one = lattice_mesh({2, 2, 2}), two = together(one, lattice_mesh({1, 1, 1}, {}, {4, 0, 0}));
  const Report missing = judged(one, boundary_surface(two));
  ASSERT_EQ(missing[Check::topology].count, 1) << report_text(missing);
  EXPECT_THAT(missing[Check::topology].findings[0].what, HasSubstr("component 1 (triangle"));
  EXPECT_THAT(missing[Check::topology].findings[0].what, HasSubstr("has no counterpart"));
  EXPECT_GE(missing[Check::topology].findings[0].point->x(), 4);

  const Report more = judged(two, boundary_surface(one));
  ASSERT_EQ(more[Check::topology].count, 1) << report_text(more);
  EXPECT_THAT(more[Check::topology].findings[0].what, HasSubstr("is none of the surface's"));
  EXPECT_GE(two.points[static_cast<std::size_t>(more[Check::topology].findings[0].faces[0][0])].x(), 4);
}

TEST(Topology, CavitiesAreComponentsToo) {
  const TetMesh full = lattice_mesh({3, 3, 3}), shell = lattice_mesh({3, 3, 3}, hollow);
  EXPECT_EQ(judged(shell, boundary_surface(shell))[Check::topology].verdict, Verdict::pass);
  const Report filled = judged(full, boundary_surface(shell));
  ASSERT_EQ(filled[Check::topology].count, 1) << report_text(filled);
  EXPECT_THAT(filled[Check::topology].findings[0].what, HasSubstr("has no counterpart"));
  const Report holed = judged(shell, boundary_surface(full));
  ASSERT_EQ(holed[Check::topology].count, 1) << report_text(holed);
  EXPECT_THAT(holed[Check::topology].findings[0].what, HasSubstr("of 12 faces"));
  // The mesh fills the core instead of the shell around it.
  const Report core = judged(lattice_mesh({1, 1, 1}, {}, {1, 1, 1}), boundary_surface(shell));
  EXPECT_EQ(core[Check::topology].count, 2) << report_text(core);
}

TEST(Topology, Outside) {
  const TetMesh around = lattice_mesh({5, 5, 5}, [](Cell c) {
    return c != Cell{1, 2, 2} && c != Cell{3, 2, 2};
  });
  const TriangleSurface solids = together(box_surface({1, 2, 2}, 1), box_surface({3, 2, 2}, 1));
  EXPECT_EQ(judged(around, solids, Region::outside)[Check::topology].verdict, Verdict::pass);
  const Report report = judged(lattice_mesh({5, 5, 5},
                                            [](Cell c) {
                                              return c != Cell{1, 2, 2};
                                            }),
                               solids, Region::outside);
  ASSERT_EQ(report[Check::topology].count, 1) << report_text(report);
  EXPECT_GE(report[Check::topology].findings[0].point->x(), 3);
}

}  // namespace
}  // namespace tetproof::test
