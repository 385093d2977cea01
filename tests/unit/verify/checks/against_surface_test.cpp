// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh against the surface that it should fill: volume, voxels, topology; inside and outside.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Region;
using verify::Report;
using verify::Verdict;

bool in_the_middle(Cell c) {
  return c == Cell{1, 1, 1};
}

TEST(AgainstSurface, ExactReproduction) {
  const TetMesh mesh = lattice_mesh({3, 3, 3});
  const Report report =
      verify::verify(mesh, boundary_surface(mesh), {.region = Region::inside, .fidelity = 0, .voxels = 16});
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report.certificate, true);
  EXPECT_EQ(report[Check::volume_surface].measured, 0.0);
  EXPECT_EQ(report[Check::topology].verdict, Verdict::pass);
  EXPECT_EQ(report.volume.mesh, 27);
  EXPECT_EQ(report.volume.surface, 27);
}

TEST(AgainstSurface, ExactReproductionMissesTheLastPlace) {
  // The mesh's exact volume rounds to the surface's but differs from it. At fidelity 0 that is a finding.
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const TriangleSurface surface = boundary_surface(mesh);
  for (auto& p : mesh.points)
    if (p == Eigen::Vector3d(3, 1, 1)) p.x() = std::nextafter(3, 4);
  const Report exact = verify::verify(mesh, surface, {.region = Region::inside, .fidelity = 0, .voxels = 0});
  EXPECT_EQ(exact[Check::volume_surface].verdict, Verdict::fail);
  EXPECT_EQ(exact.certificate, true);
  const Report near = verify::verify(mesh, surface, {.region = Region::inside, .voxels = 0});
  EXPECT_EQ(near[Check::volume_surface].verdict, Verdict::pass);
}

TEST(AgainstSurface, AMissingTetrahedron) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const TriangleSurface surface = boundary_surface(mesh);
  mesh.tets.erase(mesh.tets.begin() + 80);
  const Report report =
      verify::verify(mesh, surface, {.region = Region::inside, .fidelity = 1e-5, .voxels = 64});
  EXPECT_EQ(report.certificate, true) << "what is left is a valid triangulation, of another solid";
  EXPECT_EQ(report[Check::cavity].count, 1);
  EXPECT_EQ(report[Check::topology].verdict, Verdict::warning);
  EXPECT_EQ(report[Check::volume_surface].verdict, Verdict::fail);
  EXPECT_NEAR(*report[Check::volume_surface].measured, 1.0 / 6, 1e-12);
  const Report strict =
      verify::verify(mesh, surface, {.region = Region::inside, .strict_topology = true, .voxels = 0});
  EXPECT_EQ(strict[Check::cavity].verdict, Verdict::fail);
  EXPECT_EQ(strict[Check::topology].verdict, Verdict::fail);
}

TEST(AgainstSurface, ACavityThatBelongsThere) {
  const TetMesh mesh = lattice_mesh({3, 3, 3}, [](Cell c) { return !in_the_middle(c); });
  const Report report =
      verify::verify(mesh, boundary_surface(mesh), {.region = Region::inside, .fidelity = 0, .voxels = 0});
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report[Check::cavity].verdict, Verdict::pass);
  EXPECT_EQ(verify::verify(mesh)[Check::cavity].verdict, Verdict::warning)
      << "without a surface nobody knows";

  TetMesh holed = mesh;  // a second hole; the finding names the smaller one
  const Index corner = point_at(mesh, {1, 1, 1});
  ASSERT_LT(corner, 64);
  const TetMesh large = lattice_mesh({5, 5, 5}, [](Cell c) { return c != Cell{1, 1, 1}; });
  holed = large;
  holed.tets.erase(holed.tets.begin() + (3 * 25 + 3 * 5 + 3 - 1) * 6);
  const Report more = verify::verify(holed, boundary_surface(large), {.region = Region::inside, .voxels = 0});
  ASSERT_EQ(more[Check::cavity].count, 1);
  EXPECT_EQ(more[Check::cavity].findings[0].faces.size(), 4u);
}

TEST(AgainstSurface, Outside) {
  const auto around = lattice_mesh({3, 3, 3}, [](Cell c) { return !in_the_middle(c); });
  const TriangleSurface surface = box_surface({1, 1, 1}, 1);
  const Report report =
      verify::verify(around, surface, {.region = Region::outside, .fidelity = 0, .voxels = 8});
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report[Check::cavity].verdict, Verdict::pass);
  EXPECT_EQ(report[Check::volume_surface].measured, 0.0);
  EXPECT_EQ(report[Check::topology].verdict, Verdict::pass);

  const Report filled =
      verify::verify(lattice_mesh({3, 3, 3}), surface, {.region = Region::outside, .voxels = 0});
  EXPECT_FALSE(sound(filled));
  EXPECT_EQ(filled[Check::volume_surface].verdict, Verdict::fail);
  EXPECT_EQ(filled[Check::topology].verdict, Verdict::warning);

  // A hollow solid: its cavity is outside, too, and is a component of the outside mesh.
  const auto both = lattice_mesh({5, 5, 5}, [](Cell c) {
    const int ring = std::max({std::abs(c[0] - 2), std::abs(c[1] - 2), std::abs(c[2] - 2)});
    return ring != 1;
  });
  const TriangleSurface shell = together(box_surface({1, 1, 1}, 3), flipped(box_surface({2, 2, 2}, 1)));
  // The boxes have fewer and larger triangles than the mesh's boundary. Volumes and topology are the same.
  const Report hollow = verify::verify(both, shell, {.region = Region::outside, .fidelity = 0, .voxels = 0});
  EXPECT_TRUE(sound(hollow)) << report_text(hollow);
  EXPECT_EQ(hollow[Check::volume_surface].measured, 0.0);
  EXPECT_EQ(hollow[Check::topology].verdict, Verdict::pass);
}

TEST(AgainstSurface, AnotherTopology) {
  const TetMesh block = lattice_mesh({3, 3, 3}),
                ring = lattice_mesh({3, 3, 3}, [](Cell c) { return c[0] != 1 || c[1] != 1; });
  const Report report =
      verify::verify(block, boundary_surface(ring), {.region = Region::inside, .voxels = 0});
  ASSERT_EQ(report[Check::topology].count, 1);
  EXPECT_THAT(
      report[Check::topology].findings[0].what,
      testing::MatchesRegex("the boundary's component with this face has genus 0, the surface's component 0 "
                            "\\(triangle 0 and [0-9]+ more\\) has 1"));
  EXPECT_EQ(report[Check::topology].findings[0].faces.size(), 1u);
}

TEST(AgainstSurface, VoxelsDecideOutsideTheirError) {
  const TetMesh block = lattice_mesh({3, 3, 3});
  const TriangleSurface larger = box_surface({-0.5, -0.5, -0.5}, 4.5);
  const Report wrong = verify::verify(block, larger, {.region = Region::inside, .check = {"volume-voxel"}});
  EXPECT_EQ(wrong[Check::volume_voxel].verdict, Verdict::fail);
  EXPECT_FALSE(sound(wrong));
  // There are too few voxels to tell 27 from 31: an account that agrees within its error contradicts nothing.
  const Report coarse =
      verify::verify(block, box_surface({-0.08, -0.08, -0.08}, 3.16),
                     {.region = Region::inside, .fidelity = 1e-6, .voxels = 8, .check = {"volume-voxel"}});
  EXPECT_EQ(coarse[Check::volume_voxel].verdict, Verdict::pass);
  EXPECT_LE(coarse[Check::volume_voxel].measured, coarse[Check::volume_voxel].allowed);
  EXPECT_TRUE(sound(coarse));
}

TEST(AgainstSurface, AnUnusableSurfaceIsBadInput) {
  TriangleSurface open = box_surface({0, 0, 0}, 1);
  open.triangles.pop_back();
  try {
    verify::verify(lattice_mesh({1, 1, 1}), open, {.region = Region::inside});
    FAIL() << "an open surface was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the surface is open: 3 edges have one triangle"));
  }
}

}  // namespace
}  // namespace tetproof::test
