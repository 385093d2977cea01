// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh against its surface, both multiplied by a power of two: the verdict is the same, and lengths and
// volumes are multiplied. Where doubles cannot hold what a check needs, it says that it could not run.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/meshes.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Options;
using verify::Region;
using verify::Report;
using verify::Verdict;

struct Case {
  std::string name;
  TetMesh mesh;
  TriangleSurface surface;
  double fidelity = 1e-3;
};

std::vector<Case> cases() {
  const TetMesh block = lattice_mesh({3, 3, 3});
  const TriangleSurface surface = boundary_surface(block);
  std::vector<Case> all{{"exact", block, surface, 0}, {"right", block, surface}};
  TetMesh hole = block;
  hole.tets.erase(hole.tets.begin() + 80);
  all.push_back({"a tetrahedron is missing", hole, surface, 1e-5});
  all.push_back({"a third is missing", lattice_mesh({3, 3, 2}), surface});
  all.push_back({"a third is too much", block, boundary_surface(lattice_mesh({3, 3, 2}))});
  TetMesh moved = block;
  for (Eigen::Vector3d& p : moved.points)
    if (p == Eigen::Vector3d(3, 1, 1)) p.x() += 0.125;
  all.push_back({"a vertex is off", moved, surface});
  return all;
}

template <class Points>
void scale(Points& points, int power) {
  for (Eigen::Vector3d& p : points)
    for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], power);
}

Report judged(Case c, int power) {
  scale(c.mesh.points, power);
  scale(c.surface.vertices, power);
  return verify::verify(c.mesh, c.surface, {.region = Region::inside, .fidelity = c.fidelity, .voxels = 24});
}

class SurfaceScales : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Powers, SurfaceScales, testing::Values(-300, -171, -40, 33, 150, 260));

TEST_P(SurfaceScales, GiveTheSameVerdict) {
  const int power = GetParam();
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Report before = judged(c, 0), after = judged(c, power);
    EXPECT_EQ(sound(before), sound(after)) << report_text(after);
    EXPECT_EQ(before.certificate, after.certificate);
    for (std::size_t i = 0; i < before.checks.size(); ++i) {
      SCOPED_TRACE(info(before.checks[i].check).id);
      EXPECT_EQ(before.checks[i].verdict, after.checks[i].verdict) << report_text(after);
      EXPECT_EQ(before.checks[i].count, after.checks[i].count);
      EXPECT_EQ(before.checks[i].consequences, after.checks[i].consequences);
    }
    for (const Check check : {Check::volume_surface, Check::volume_voxel})
      EXPECT_DOUBLE_EQ(std::ldexp(*before[check].measured, 3 * power), *after[check].measured);
    for (const Check check : {Check::mesh_to_surface, Check::surface_to_mesh}) {
      EXPECT_DOUBLE_EQ(std::ldexp(*before[check].measured, power), *after[check].measured);
      EXPECT_DOUBLE_EQ(std::ldexp(*before[check].allowed, power), *after[check].allowed);
    }
    EXPECT_DOUBLE_EQ(*before.volume.relative_difference, *after.volume.relative_difference);
  }
}

// Volumes of such sizes are no doubles, so there are no voxels. The rest is judged as always.
TEST(SurfaceScales, BeyondVolumesTheRestIsJudgedAndSaidToBe) {
  for (const int power : {-900, -400, 400, 900})
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name + " times 2^" + std::to_string(power));
      const Report before = judged(c, 0), after = judged(c, power);
      EXPECT_FALSE(sound(after));
      EXPECT_EQ(defective(before), defective(after)) << report_text(after);
      EXPECT_EQ(before.certificate, after.certificate);
      std::vector<std::string> not_run;
      for (std::size_t i = 0; i < before.checks.size(); ++i) {
        if (after.checks[i].verdict == Verdict::skipped)
          not_run.emplace_back(info(after.checks[i].check).id);
        else
          EXPECT_EQ(before.checks[i].verdict, after.checks[i].verdict) << info(before.checks[i].check).id;
      }
      EXPECT_THAT(not_run, testing::UnorderedElementsAre("missing-region", "excess-region", "volume-voxel"));
      EXPECT_FALSE(after.not_judged.empty());
    }
}

}  // namespace
}  // namespace tetproof::test
