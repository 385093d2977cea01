// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh and surface in other units and in other places.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using verify::Check;
using verify::Region;
using verify::Report;

Report against(const TetMesh& mesh, const TriangleSurface& surface, double fidelity = 1e-3) {
  return verify::verify(mesh, surface, {.region = Region::inside, .fidelity = fidelity, .voxels = 16});
}

std::string box_finding(const Report& report) {
  const auto& result = report[Check::bounding_box];
  return result.count == 1 ? result.findings[0].what : "none";
}

TriangleSurface scaled(TriangleSurface surface, double factor) {
  for (auto& p : surface.vertices) p *= factor;
  return surface;
}

TEST(BoundingBox, OtherUnits) {
  const TetMesh mesh = lattice_mesh({3, 2, 1});
  const TriangleSurface surface = boundary_surface(mesh);
  const std::vector<std::pair<double, std::string>> cases{
      {1e-3, "the mesh is 1000 times as large as the surface: millimetres and metres?"},
      {1e3, "the surface is 1000 times as large as the mesh: millimetres and metres?"},
      {0.1, "the mesh is 10 times as large as the surface: millimetres and centimetres?"},
      {100, "the surface is 100 times as large as the mesh: centimetres and metres?"},
      {25.4, "the surface is 25.4 times as large as the mesh: millimetres and inches?"},
      {1 / 12.0, "the mesh is 12 times as large as the surface: inches and feet?"},
      {1000 / 304.8, "the surface is 3.28084 times as large as the mesh: feet and metres?"},
      {1 / 39.37, "the mesh is 39.3701 times as large as the surface: inches and metres?"},
      {1e6, "the surface is 1e+06 times as large as the mesh: micrometres and metres?"}};
  for (const auto& [factor, what] : cases) {
    const Report report = against(mesh, scaled(surface, factor));
    EXPECT_EQ(box_finding(report), what) << factor;
    EXPECT_EQ(roots(report), Ids{"bounding-box"}) << factor;
    EXPECT_GT(report[Check::volume_surface].consequences, 0);
    EXPECT_EQ(report.certificate, true);
  }
}

TEST(BoundingBox, OtherFactorsAreNoUnits) {
  const TetMesh mesh = lattice_mesh({3, 2, 1});
  const TriangleSurface surface = boundary_surface(mesh);
  for (const double factor : {1.0, 1.001, 0.5, 2.0, 7.0, 700.0})
    EXPECT_EQ(box_finding(against(mesh, scaled(surface, factor))), "none") << factor;
  // A tenth of a thin rod is no rod in other units.
  TetMesh rod = lattice_mesh({1, 1, 1});
  for (auto& p : rod.points) p.x() *= 100;
  const TriangleSurface whole = boundary_surface(rod);
  for (auto& p : rod.points) p.x() /= 10;
  EXPECT_EQ(box_finding(against(rod, whole)), "none");
  // On all axes: here on one only.
  EXPECT_EQ(box_finding(against(mesh, box_surface({0, 0, 0}, 10))), "none");
}

TEST(BoundingBox, OtherPlaces) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  const auto shifted = [&](double x) { return boundary_surface(lattice_mesh({2, 2, 2}, {}, {x, 0, 0})); };
  EXPECT_EQ(box_finding(against(mesh, shifted(0.5))),
            "the mesh is as large as the surface and lies elsewhere: moved by (-0.5, 0, 0)");
  EXPECT_EQ(
      box_finding(against(mesh, shifted(5))),
      "the mesh is as large as the surface and lies elsewhere: moved by (-5, 0, 0); the boxes do not meet");
  EXPECT_EQ(roots(against(mesh, shifted(5))), Ids{"bounding-box"});
  // Within twice the allowed distance, 1e-3 sqrt(12), nothing is said.
  EXPECT_EQ(box_finding(against(mesh, shifted(0.0069))), "none");
  EXPECT_EQ(box_finding(against(mesh, shifted(0.0070))),
            "the mesh is as large as the surface and lies elsewhere: moved by (-0.007, 0, 0)");
  EXPECT_THAT(
      box_finding(against(mesh, box_surface({7, 0, 0}, 3))),
      HasSubstr("the boxes of mesh and surface do not meet: the mesh reaches from (0, 0, 0) to (2, 2, 2)"));
  // A part of the solid is no mesh in another place.
  EXPECT_EQ(box_finding(against(mesh, box_surface({0, 0, 0}, 3))), "none");
}

}  // namespace
}  // namespace tetproof::test
