// SPDX-License-Identifier: GPL-3.0-or-later
// Missing and excess regions of a mesh: where they are, how large they are, and which findings follow from
// them.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "corpus/surfaces.hpp"
#include "tests/support/meshes.hpp"
#include "verify/mesh/tets_at.hpp"
#include "verify/verify.hpp"
#include "verify/voxels/deep_voxels.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Region;
using verify::Report;
using verify::Verdict;
using Point = Eigen::Vector3d;

bool within(const Point& p, const Point& low, const Point& high) {
  return (p.array() > low.array()).all() && (p.array() < high.array()).all();
}

TEST(MissingRegion, AHoleInTheMeshIsFoundAndMeasured) {
  const TetMesh block = lattice_mesh({6, 6, 6});
  const TetMesh holed = lattice_mesh({6, 6, 6}, [](Cell c) {
    return !(c[0] >= 2 && c[0] < 4 && c[1] >= 2 && c[1] < 4 && c[2] >= 2 && c[2] < 4);
  });
  const Report report =
      verify::verify(holed, boundary_surface(block), {.region = Region::inside, .voxels = 64});
  ASSERT_EQ(report[Check::missing_region].count, 1) << report_text(report);
  EXPECT_EQ(report[Check::missing_region].verdict, Verdict::fail);
  const verify::Finding& finding = report[Check::missing_region].findings[0];
  EXPECT_TRUE(within(*finding.point, {2.5, 2.5, 2.5}, {3.5, 3.5, 3.5})) << "far from the hole's faces";
  EXPECT_TRUE(finding.tets.empty());
  EXPECT_EQ(finding.faces.size(), 1u);
  EXPECT_NEAR(*report.volume.missing, 8, 1.3);
  EXPECT_EQ(report.volume.excess, 0.0);
  EXPECT_EQ(report[Check::excess_region].verdict, Verdict::pass);
  for (const Check check : {Check::volume_surface, Check::topology}) {
    EXPECT_EQ(report[check].count, 0) << info(check).id << report_text(report);
    EXPECT_GE(report[check].consequences, 1) << info(check).id;
  }
  EXPECT_EQ(report[Check::volume_surface].verdict, Verdict::fail);
}

TEST(MissingRegion, OnlyWhatIsDeeperThanAllowed) {
  const TetMesh block = lattice_mesh({6, 6, 6}), holed = lattice_mesh({6, 6, 6}, [](Cell c) {
                                                   return c != Cell{2, 2, 2};
                                                 });
  const double diagonal = std::sqrt(108);
  for (const double depth : {0.4, 0.6}) {  // the cell's centre is at distance 0.5 from the mesh
    const Report report =
        verify::verify(holed, boundary_surface(block),
                       {.region = Region::inside, .fidelity = depth / diagonal, .voxels = 101});
    EXPECT_EQ(report[Check::missing_region].count, depth < 0.5 ? 1 : 0) << report_text(report);
  }
}

TEST(MissingRegion, TheLastLayerAndASecondPart) {
  const TriangleSurface surface =
      together(boundary_surface(lattice_mesh({3, 3, 3})), box_surface({5, 0, 0}, 1));
  const Report report =
      verify::verify(lattice_mesh({3, 3, 2}), surface, {.region = Region::inside, .voxels = 60});
  ASSERT_EQ(report[Check::missing_region].count, 2) << report_text(report);
  const auto& findings = report[Check::missing_region].findings;
  EXPECT_TRUE(within(*findings[0].point, {0, 0, 2}, {3, 3, 3})) << "the largest first";
  EXPECT_TRUE(within(*findings[1].point, {5, 0, 0}, {6, 1, 1}));
  EXPECT_EQ(report[Check::surface_to_mesh].count, 0);
  EXPECT_EQ(report[Check::surface_to_mesh].consequences, 1);
}

TEST(ExcessRegion, ABlockThatIsNotTheSurfaces) {
  const TetMesh mesh = lattice_mesh({3, 3, 3}), more = together(mesh, lattice_mesh({1, 1, 1}, {}, {5, 1, 1}));
  const Report report =
      verify::verify(more, boundary_surface(mesh), {.region = Region::inside, .voxels = 60});
  ASSERT_EQ(report[Check::excess_region].count, 1) << report_text(report);
  const verify::Finding& finding = report[Check::excess_region].findings[0];
  EXPECT_TRUE(within(*finding.point, {5, 1, 1}, {6, 2, 2}));
  ASSERT_FALSE(finding.tets.empty());
  for (const Index t : finding.tets) EXPECT_GE(t, static_cast<Index>(mesh.tets.size()));
  EXPECT_NEAR(*report.volume.excess, 1, 0.4);
  EXPECT_EQ(report.volume.missing, 0.0);
  EXPECT_EQ(report[Check::off_surface_vertex].count, 0) << report_text(report);
  EXPECT_EQ(report[Check::off_surface_vertex].consequences, 8);
  EXPECT_EQ(report[Check::mesh_to_surface].consequences, 1);
  EXPECT_EQ(report[Check::missing_region].verdict, Verdict::pass);
}

TEST(ExcessRegion, Outside) {
  const auto ring = [](Cell c) {
    return std::max({std::abs(c[0] - 2), std::abs(c[1] - 2), std::abs(c[2] - 2)});
  };
  const TetMesh around = lattice_mesh({5, 5, 5}, [&](Cell c) { return ring(c) > 1; });
  const TriangleSurface solid = boundary_surface(lattice_mesh({3, 3, 3}, {}, {1, 1, 1}));
  const verify::Options options{.region = Region::outside, .voxels = 60};
  const Report right = verify::verify(around, solid, options);
  EXPECT_TRUE(sound(right)) << report_text(right);
  EXPECT_EQ(right.volume.missing, 0.0);
  EXPECT_EQ(right.volume.excess, 0.0);

  // The outside mesh covers one cell of the solid, too. Or it lacks a cell of the outside, and its own
  // boundary is still closed.
  const Report more = verify::verify(lattice_mesh({5, 5, 5},
                                                  [&](Cell c) {
                                                    return ring(c) > 1 || c == Cell{1, 2, 2};
                                                  }),
                                     solid, options);
  ASSERT_EQ(more[Check::excess_region].count, 1) << report_text(more);
  EXPECT_TRUE(within(*more[Check::excess_region].findings[0].point, {1, 2, 2}, {2, 3, 3}));
  EXPECT_EQ(more[Check::missing_region].count, 0);
  const TetMesh large = lattice_mesh({7, 7, 7}, [](Cell c) {
    return std::max({std::abs(c[0] - 3), std::abs(c[1] - 3), std::abs(c[2] - 3)}) > 1 && c != Cell{1, 1, 1};
  });
  const Report less =
      verify::verify(large, boundary_surface(lattice_mesh({3, 3, 3}, {}, {2, 2, 2})), options);
  ASSERT_EQ(less[Check::missing_region].count, 1) << report_text(less);
  EXPECT_TRUE(within(*less[Check::missing_region].findings[0].point, {1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(less[Check::excess_region].count, 0);
}

TEST(MissingRegion, WhatIsCoveredTwiceIsNotMissing) {
  // Every point is in two tetrahedra: counting crossings modulo two sees nothing, counting tetrahedra does.
  const TetMesh block = lattice_mesh({3, 3, 3});
  const Report report = verify::verify(together(block, block), boundary_surface(block),
                                       {.region = Region::inside, .voxels = 30});
  EXPECT_EQ(report[Check::missing_region].verdict, Verdict::pass) << report_text(report);
}

TEST(MissingRegion, SameBytesForAnyNumberOfThreads) {
  const TetMesh mesh = lattice_mesh(
      {9, 9, 9}, [](Cell c) { return (c[0] + c[1] + c[2]) % 5 != 0; }, {-1, -1, -1}, 0.21);
  const TriangleSurface surface = corpus::make_surface("random:seed=3,n=1500");
  std::array<std::string, 3> reports;
  for (int i = 0; i < 3; ++i) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::array{1, 2, 7}[i]);
    reports[i] = report_json(verify::verify(mesh, surface, {.region = Region::inside, .voxels = 50}));
  }
  EXPECT_EQ(reports[1], reports[0]);
  EXPECT_EQ(reports[2], reports[0]);
}

TEST(MissingRegion, ASurfaceThatIsUsedAgainGivesTheSameReports) {
  // The first mesh has the same box as the surface, and so the same voxels. The others have different ones.
  const TetMesh whole = lattice_mesh({4, 4, 4});
  const std::vector<TetMesh> meshes{lattice_mesh({4, 4, 4},
                                                 [](Cell c) {
                                                   return c != Cell{1, 1, 1};
                                                 }),
                                    lattice_mesh({6, 4, 4}), lattice_mesh({4, 4, 2}), whole};
  const TriangleSurface surface = boundary_surface(whole);
  const verify::JudgedSurface judged(surface);
  for (const int voxels : {32, 20, 32})
    for (const TetMesh& mesh : meshes) {
      const verify::Options options{.region = Region::inside, .fidelity = 0.01, .voxels = voxels};
      EXPECT_EQ(report_json(verify::verify(mesh, judged, options)),
                report_json(verify::verify(mesh, surface, options)));
    }
}

TEST(MissingRegion, IsSeenWhereTheBoxesDifferMuch) {
  // A mesh that is a thousand times too large, too small, or elsewhere lacks the whole solid (or all but a
  // thousand millionth of it), and all of the mesh is in excess. In one lattice over both boxes, the smaller
  // one would be less than a voxel.
  const TriangleSurface surface = boundary_surface(lattice_mesh({2, 2, 2}));
  const auto judged = [&](double size, const Point& at) {
    return verify::verify(lattice_mesh({2, 2, 2}, {}, at, size), surface,
                          {.region = Region::inside, .voxels = 40, .skip = {"bounding-box"}});
  };
  const Report small = judged(1e-3, {1, 1, 1}), elsewhere = judged(1, {3e4, -1e5, 0});
  for (const Report* report : {&small, &elsewhere}) {
    ASSERT_EQ((*report)[Check::missing_region].count, 1) << report_text(*report);
    EXPECT_TRUE(within(*(*report)[Check::missing_region].findings[0].point, {0, 0, 0}, {2, 2, 2}));
    EXPECT_NEAR(*report->volume.missing, 8, 1.2);
  }
  EXPECT_EQ(*small.volume.excess, 0.0) << "it lies inside";
  ASSERT_EQ(elsewhere[Check::excess_region].count, 1) << report_text(elsewhere);
  EXPECT_NEAR(*elsewhere.volume.excess, 8, 1.2);
  const Report large = judged(1e3, {-700, -900, -800});
  EXPECT_EQ(large[Check::missing_region].count, 0) << report_text(large);
  ASSERT_EQ(large[Check::excess_region].count, 1) << report_text(large);
  EXPECT_NEAR(*large.volume.excess / 8e9, 1, 0.15);
}

TEST(DeepVoxels, TheVolumeIsOffByNoMoreThanStated) {
  // The points that are deeper than d inside a cube form a smaller cube. Its volume is that of the certain
  // voxels, up to the uncertain ones.
  const TriangleSurface cube = box_surface({0.013, -0.021, 0.034}, 2);
  const verify::TriangleSet set{cube.vertices, cube.triangles};
  const verify::TriangleTree tree(set, verify::units_of(std::span(&set, 1)));
  for (const int n : {9, 20, 47})
    for (const double depth : {0.0, 0.05, 0.4, 0.9}) {
      const verify::VoxelLattice lattice = verify::lay_voxels(cube, n);
      const verify::VoxelBits inside = verify::inside_voxels(cube, lattice);
      const verify::DeepVoxels deep = verify::deep_voxels(
          lattice, inside, tree, depth, [&] { return verify::met_voxels(cube, lattice); }, {});
      const double right = std::pow(2 - 2 * depth, 3), each = std::pow(lattice.h, 3);
      ASSERT_EQ(deep.regions.size(), 1u) << n << " " << depth;
      const verify::VoxelRegion& region = deep.regions[0];
      EXPECT_LE(std::abs(static_cast<double>(region.voxels) * each - right),
                static_cast<double>(region.unsure) * each);
      EXPECT_LT(static_cast<double>(region.unsure) * each, 50 * lattice.h) << "a layer or two";
      EXPECT_NEAR(region.depth, 1, 1.5 * lattice.h);
      std::int64_t brute = 0;
      for (int i = 0; i < lattice.size[0]; ++i)
        for (int j = 0; j < lattice.size[1]; ++j)
          for (int k = 0; k < lattice.size[2]; ++k) {
            const Point p(lattice.centre(0, i), lattice.centre(1, j), lattice.centre(2, k));
            const Point low = p - cube.vertices[0], high = cube.vertices[0] + Point(2, 2, 2) - p;
            brute += std::min(low.minCoeff(), high.minCoeff()) > depth;
          }
      EXPECT_EQ(region.voxels, brute) << n << " " << depth;
    }
}

TEST(TetsAt, AreExact) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  const std::vector<Point> points{
      {1, 1, 1}, {0.5, 0.25, 0.125}, {2.5, 1, 1}, {0, 0, 0}, {std::nextafter(0, -1), 0, 0}};
  const auto tets = verify::tets_at(mesh, {}, points);
  EXPECT_EQ(tets[0].size(), 24u) << "Kuhn's lattice around an inner point";
  EXPECT_EQ(tets[1].size(), 1u);
  EXPECT_TRUE(tets[2].empty());
  EXPECT_EQ(tets[3].size(), 6u);
  EXPECT_TRUE(tets[4].empty());
}

}  // namespace
}  // namespace tetproof::test
