// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance that is wider than a solid is thick is said, and does not let the solid be lost.
#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using verify::Check;
using verify::Region;
using verify::Report;
using verify::Verdict;

Report against(const TetMesh& mesh, const TriangleSurface& surface, double fidelity) {
  return verify::verify(mesh, surface, {.region = Region::inside, .fidelity = fidelity, .voxels = 16});
}

// A plate of 10 x 10 x 0.1 units.
struct Plate {
  TetMesh mesh = lattice_mesh({10, 10, 1});
  TriangleSurface surface;
  Plate() {
    for (auto& p : mesh.points) p.z() *= 0.1;
    surface = boundary_surface(mesh);
  }
  // Without one of its ends: so many rows of cells.
  TetMesh without(int rows) const {
    TetMesh less = lattice_mesh({10, 10, 1}, [=](Cell c) { return c[0] >= rows; });
    for (auto& p : less.points) p.z() *= 0.1;
    return less;
  }
};

TEST(ThinSolid, ItsVolumeIsHeldToAShareOfIt) {
  const Plate plate;
  // The diagonal is 14.14: half of it as the allowed distance would allow a volume of 1400, and the plate
  // has 10.
  const Report lost = against(plate.without(4), plate.surface, 0.5);
  EXPECT_EQ(lost[Check::volume_surface].verdict, Verdict::fail) << report_text(lost);
  EXPECT_EQ(lost[Check::volume_surface].allowed, 2.5);
  EXPECT_NEAR(*lost[Check::volume_surface].measured, 4, 1e-12);
  EXPECT_EQ(against(plate.without(2), plate.surface, 0.5)[Check::volume_surface].verdict, Verdict::pass);
  EXPECT_EQ(against(plate.without(3), plate.surface, 0.5)[Check::volume_surface].verdict, Verdict::fail);
  // Where the layer is thin, the layer is what is allowed: 1e-4 x 14.1425 x 204.
  EXPECT_NEAR(*against(plate.mesh, plate.surface, 1e-4)[Check::volume_surface].allowed, 0.288507, 1e-6);
}

TEST(ThinSolid, AWideToleranceIsSaid) {
  const Plate plate;
  // 2 V / A = 20 / 204.
  const auto notes = [&](double fidelity) { return against(plate.mesh, plate.surface, fidelity).notes; };
  EXPECT_THAT(notes(0.01),
              testing::Contains(HasSubstr("is wider than the solid is thick (2 V / A = 0.0980392)")));
  EXPECT_THAT(notes(0.0069), Not(testing::Contains(HasSubstr("is wider than the solid is thick"))));
  EXPECT_THAT(notes(0.0070), testing::Contains(HasSubstr("is wider than the solid is thick")));
}

// A grid of a lattice loses walls that are thinner than a cell: its maker allows the whole layer.
TEST(ThinSolid, ACoarseGridMayLoseTheLayer) {
  const Plate plate;
  const Report report =
      verify::verify(plate.without(4), plate.surface,
                     {.region = Region::inside, .fidelity = 0.5, .voxels = 16, .coarse = true});
  EXPECT_FALSE(defective(report)) << report_text(report);
}

}  // namespace
}  // namespace tetproof::test
