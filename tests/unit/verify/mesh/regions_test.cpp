// SPDX-License-Identifier: GPL-3.0-or-later
// The account of each region of a mesh whose regions share faces.
#include <gtest/gtest.h>

#include "io/error.hpp"
#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Report;

// The region of each tetrahedron, given the region of each cell. lattice_mesh makes six tetrahedra per cell,
// cell by cell.
std::vector<std::int64_t> by_cell(std::initializer_list<std::int64_t> of_cell) {
  std::vector<std::int64_t> regions;
  for (const std::int64_t region : of_cell) regions.insert(regions.end(), 6, region);
  return regions;
}

TEST(Regions, TwoCubesWithACommonFace) {
  const TetMesh mesh = lattice_mesh({2, 1, 1}, {}, {-1, 0, 0});
  const Report report = verify::verify(mesh, {.regions = by_cell({12, -3})});
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report.mesh.boundary_faces, 20);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].tag, -3);
  EXPECT_EQ(report.regions[1].tag, 12);
  for (const auto& [tag, shape] : report.regions) {
    EXPECT_EQ(shape.points, 8);
    EXPECT_EQ(shape.tets, 6);
    EXPECT_EQ(shape.boundary_faces, 12);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 0);
    EXPECT_EQ(shape.volume, 1.0);
  }
}

TEST(Regions, AShellAroundACoreHasACavityThatTheMeshHasNot) {
  std::vector<std::int64_t> regions;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) regions.insert(regions.end(), 6, i == 1 && j == 1 && k == 1 ? 2 : 1);
  const Report report = verify::verify(lattice_mesh({3, 3, 3}), {.regions = regions});
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report.mesh.cavities, 0);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].shape.cavities, 1);
  EXPECT_EQ(report.regions[0].shape.components, 2);
  EXPECT_EQ(report.regions[0].shape.volume, 26.0);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
  EXPECT_EQ(report.regions[1].shape.boundary_faces, 12);
}

// A region of two parts, and tetrahedra that belong to no region.
TEST(Regions, PartsAndBrokenTetrahedra) {
  TetMesh mesh = lattice_mesh({3, 1, 1});
  mesh.tets.push_back({0, 1, 2, 999});
  auto regions = by_cell({1, 2, 1});
  regions.push_back(5);
  const Report report = verify::verify(mesh, {.regions = regions});
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].shape.components, 2);
  EXPECT_EQ(report.regions[0].shape.volume, 2.0);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
}

// If the regions do not share their points, the mesh is cracked.
TEST(Regions, NotSharingPointsIsACrack) {
  const TetMesh mesh = together(lattice_mesh({1, 1, 1}), lattice_mesh({1, 1, 1}, {}, {1, 0, 0}));
  const Report report = verify::verify(mesh, {.regions = by_cell({1, 2})});
  EXPECT_EQ(report.certificate, false);
  EXPECT_EQ(report[verify::Check::crack].count, 2);
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[1].shape.volume, 1.0);
}

TEST(Regions, OneRegionNeedsNoAccount) {
  EXPECT_TRUE(verify::verify(lattice_mesh({2, 1, 1}), {.regions = by_cell({4, 4})}).regions.empty());
  EXPECT_TRUE(verify::verify(lattice_mesh({2, 1, 1})).regions.empty());
}

TEST(Regions, OneForEachTetrahedronOrNone) {
  EXPECT_THROW(verify::verify(lattice_mesh({2, 1, 1}), {.regions = {1, 2}}), InputError);
}

}  // namespace
}  // namespace tetproof::test
