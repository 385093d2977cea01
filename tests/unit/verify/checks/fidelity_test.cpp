// SPDX-License-Identifier: GPL-3.0-or-later
// The distances between a mesh and the surface that it should fill; surface vertices and normals.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Region;
using verify::Report;
using verify::Verdict;
using Point = Eigen::Vector3d;

const std::vector<Check> all_distances{Check::off_surface_vertex, Check::mesh_to_surface,
                                       Check::surface_to_mesh};

TEST(Fidelity, ExactReproduction) {
  const TetMesh mesh = lattice_mesh({3, 3, 3}, {}, {0.1, 0.7, -0.3}, 1 / 3.0);
  const Report report =
      verify::verify(mesh, boundary_surface(mesh), {.region = Region::inside, .fidelity = 0, .voxels = 0});
  for (const Check check : all_distances) EXPECT_EQ(report[check].verdict, Verdict::pass) << info(check).id;
  ASSERT_TRUE(report.fidelity);
  EXPECT_EQ(report.fidelity->mesh_to_surface, 0.0);
  EXPECT_EQ(report.fidelity->surface_to_mesh, 0.0);
  EXPECT_EQ(report.fidelity->error_bound, 0);
  EXPECT_EQ(report[Check::normals].verdict, Verdict::pass);
  EXPECT_LT(*report[Check::normals].measured, 1e-6);
}

TEST(Fidelity, TheSameFacesCutOtherwiseAreInsideRounding) {
  const TetMesh thirds = lattice_mesh({3, 3, 3}, {}, {0, 0, 0}, 5);
  const TriangleSurface fifths = boundary_surface(lattice_mesh({5, 5, 5}, {}, {0, 0, 0}, 3));
  const Report report =
      verify::verify(thirds, fifths, {.region = Region::inside, .fidelity = 0, .voxels = 0});
  EXPECT_TRUE(sound(report)) << report_text(report);
  EXPECT_EQ(report[Check::off_surface_vertex].verdict, Verdict::pass) << "each lies on a face exactly";
  EXPECT_EQ(report[Check::mesh_to_surface].verdict, Verdict::undecided);
  EXPECT_EQ(report[Check::surface_to_mesh].verdict, Verdict::undecided);
  EXPECT_LE(report.fidelity->error_bound, 26 * 1e-13);
  const Report near =
      verify::verify(thirds, fifths, {.region = Region::inside, .fidelity = 1e-9, .voxels = 0});
  for (const Check check : all_distances) EXPECT_EQ(near[check].verdict, Verdict::pass) << info(check).id;
}

// Whoever asks for the verdict alone gets the same one, and intervals that still hold.
TEST(Fidelity, DecideOnlyGivesTheSameVerdicts) {
  const TriangleSurface surface = boundary_surface(lattice_mesh({3, 3, 3}));  // its diagonal is 5.2
  for (const double raised : {0.0, 1e-12, 1e-4, 4e-3, 6e-3, 0.02, 0.5})
    for (const double fidelity : {1e-9, 1e-3, 0.05}) {
      TetMesh mesh = lattice_mesh({3, 3, 3});
      mesh.points[static_cast<std::size_t>(point_at(mesh, {1, 1, 3}))].z() += raised;
      verify::Options options{.region = Region::inside, .fidelity = fidelity, .voxels = 0};
      const Report measured = verify::verify(mesh, surface, options);
      options.decide_only = true;
      const Report decided = verify::verify(mesh, surface, options);
      for (const Check check : all_distances) {
        EXPECT_EQ(decided[check].verdict, measured[check].verdict)
            << info(check).id << " raised by " << raised << ", fidelity " << fidelity;
        EXPECT_EQ(decided[check].count, measured[check].count) << info(check).id;
      }
      ASSERT_TRUE(decided.fidelity && measured.fidelity);
      EXPECT_LE(*decided.fidelity->mesh_to_surface,
                *measured.fidelity->mesh_to_surface + measured.fidelity->error_bound);
      EXPECT_GE(*decided.fidelity->mesh_to_surface + decided.fidelity->error_bound,
                *measured.fidelity->mesh_to_surface);
    }
}

TEST(Fidelity, AVertexOffTheSurfaceIsTheRoot) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  const TriangleSurface surface = boundary_surface(mesh);
  const Index vertex = point_at(mesh, {1, 1, 3});
  mesh.points[static_cast<std::size_t>(vertex)].z() += 0.125;
  const Report report = verify::verify(mesh, surface, {.region = Region::inside, .voxels = 0});
  ASSERT_EQ(report[Check::off_surface_vertex].count, 1) << report_text(report);
  EXPECT_EQ(report[Check::off_surface_vertex].findings[0].vertices, std::vector<Index>{vertex});
  EXPECT_NEAR(*report[Check::off_surface_vertex].measured, 0.125, 1e-13);
  EXPECT_EQ(report[Check::mesh_to_surface].count, 0);
  EXPECT_EQ(report[Check::mesh_to_surface].consequences, 1) << report_text(report);
  EXPECT_EQ(report[Check::mesh_to_surface].verdict, Verdict::fail);
  EXPECT_NEAR(*report.fidelity->mesh_to_surface, 0.125, 1e-3);
  EXPECT_EQ(report[Check::surface_to_mesh].consequences, 1) << report_text(report);
  const Report allowed = verify::verify(
      mesh, surface, {.region = Region::inside, .fidelity = 0.13 / std::sqrt(27), .voxels = 0});
  for (const Check check : all_distances) EXPECT_EQ(allowed[check].verdict, Verdict::pass) << info(check).id;
}

TEST(Fidelity, DecidesAsCloseAsDoublesDo) {
  // The mesh is moved along x by exactly `by`, so both distances are `by`.
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  const double by = 0x1p-7, diagonal = std::sqrt(12);
  TetMesh moved = mesh;
  for (Point& p : moved.points) p.x() += by;
  for (const double factor : {0.9, 1 - 1e-9, 1 + 1e-9, 1.1}) {
    const Report report =
        verify::verify(moved, boundary_surface(mesh),
                       {.region = Region::inside, .fidelity = factor * by / diagonal, .voxels = 0});
    const Verdict right = factor < 1 ? Verdict::fail : Verdict::pass;
    for (const Check check : all_distances)
      EXPECT_EQ(report[check].verdict, right) << info(check).id << factor;
  }
  const Report at = verify::verify(moved, boundary_surface(mesh),
                                   {.region = Region::inside, .fidelity = by / diagonal, .voxels = 0});
  for (const Check check : {Check::mesh_to_surface, Check::surface_to_mesh})
    EXPECT_EQ(at[check].verdict, Verdict::undecided) << "as large as allowed, but for rounding";
}

TEST(Fidelity, OutsideLeavesTheMeshsOwnBoundaryOut) {
  const auto around = lattice_mesh({5, 5, 5}, [](Cell c) { return c != Cell{2, 2, 2}; });
  const Report report = verify::verify(around, box_surface({2, 2, 2}, 1),
                                       {.region = Region::outside, .fidelity = 0, .voxels = 0});
  EXPECT_TRUE(sound(report)) << report_text(report);
  for (const Check check : all_distances) EXPECT_EQ(report[check].verdict, Verdict::pass) << info(check).id;
  EXPECT_EQ(report[Check::normals].verdict, Verdict::pass);
  EXPECT_LT(*report[Check::normals].measured, 1e-6) << "the mesh's faces look into the solid";

  const Report filled = verify::verify(lattice_mesh({5, 5, 5}), box_surface({2, 2, 2}, 1),
                                       {.region = Region::outside, .voxels = 0});
  ASSERT_EQ(filled[Check::surface_to_mesh].count, 1);
  EXPECT_EQ(filled[Check::surface_to_mesh].findings[0].what,
            "no face of the mesh's boundary is the surface's");
}

TEST(Fidelity, ThePartThatIsMissingIsFarFromTheMesh) {
  const TetMesh one = lattice_mesh({2, 2, 2}), other = lattice_mesh({1, 1, 1}, {}, {4, 0, 0});
  const TriangleSurface surface = together(boundary_surface(one), boundary_surface(other));
  verify::Options options{.region = Region::inside, .voxels = 0};
  const Report report = verify::verify(one, surface, options);
  EXPECT_EQ(report[Check::mesh_to_surface].verdict, Verdict::pass);
  EXPECT_EQ(report[Check::surface_to_mesh].verdict, Verdict::fail);
  EXPECT_NEAR(*report[Check::surface_to_mesh].measured, 3, 1e-2);
  ASSERT_EQ(report[Check::surface_to_mesh].findings.size(), 1u);
  EXPECT_EQ(report[Check::surface_to_mesh].findings[0].point->x(), 5);
  options.coarse = true;
  const Report coarse = verify::verify(one, surface, options);
  EXPECT_EQ(coarse[Check::surface_to_mesh].verdict, Verdict::warning);
  EXPECT_EQ(coarse[Check::normals].verdict, Verdict::skipped);
  EXPECT_EQ(coarse[Check::mesh_to_surface].verdict, Verdict::pass);
}

TEST(Fidelity, OnlyWhatIsAskedForIsMeasured) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  const auto judged = [&](std::vector<std::string> checks) {
    return verify::verify(mesh, boundary_surface(mesh),
                          {.region = Region::inside, .voxels = 0, .check = checks});
  };
  EXPECT_FALSE(judged({"topology"}).fidelity);
  const Report one = judged({"surface-to-mesh"});
  ASSERT_TRUE(one.fidelity);
  EXPECT_FALSE(one.fidelity->mesh_to_surface);
  EXPECT_EQ(one.fidelity->surface_to_mesh, 0.0);
  EXPECT_EQ(one[Check::mesh_to_surface].verdict, Verdict::skipped);
  EXPECT_EQ(one[Check::surface_to_mesh].verdict, Verdict::pass);
}

TEST(Normals, ThinPlatesEdgesAndCornersAreNoFalseAlarm) {
  const TetMesh plate = lattice_mesh({8, 8, 1});
  TetMesh thin = plate;
  for (Point& p : thin.points) p.z() *= 1e-3;
  for (const double fidelity : {0.0, 1e-6, 1e-3, 1e-1})
    for (const bool inward : {false, true}) {
      TriangleSurface surface = boundary_surface(thin);
      if (inward) surface = flipped(surface);
      const Report report =
          verify::verify(thin, surface, {.region = Region::inside, .fidelity = fidelity, .voxels = 0});
      EXPECT_EQ(report[Check::normals].verdict, Verdict::pass) << report_text(report);
      EXPECT_TRUE(sound(report)) << report_text(report);
    }
}

TEST(Normals, FacesThatLookTheOtherWay) {
  // A cavity one cell below the faces of a block. Its faces are turned towards the block's.
  const TetMesh block = lattice_mesh({3, 3, 3}), holed = lattice_mesh({3, 3, 3}, [](Cell c) {
                                                   return c != Cell{1, 1, 1};
                                                 });
  const Report report =
      verify::verify(holed, boundary_surface(block),
                     {.region = Region::inside, .fidelity = 1.1 / std::sqrt(27), .voxels = 0});
  EXPECT_EQ(report[Check::normals].count, 12) << report_text(report);
  EXPECT_EQ(report[Check::normals].verdict, Verdict::warning);
  EXPECT_NEAR(*report[Check::normals].measured, 180, 1e-6);
  EXPECT_EQ(report[Check::normals].findings[0].faces.size(), 1u);
  EXPECT_EQ(report[Check::normals].findings[0].tets.size(), 1u);
}

}  // namespace
}  // namespace tetproof::test
