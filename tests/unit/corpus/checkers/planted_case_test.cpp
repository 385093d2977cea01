// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/checkers/planted_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "corpus/block_mesh.hpp"
#include "corpus/checkers/held_exactly.hpp"
#include "io/error.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

TEST(PlantedCase, EveryKindIsPlantedAndIsWhatTheTruthSays) {
  const std::vector<std::string> kinds = checked_kinds();
  EXPECT_EQ(kinds.size(), plant_kinds().size() + 1);
  for (std::uint64_t index = 0; index < kinds.size(); ++index) {
    const PlantedCase one = planted_case(kinds, 1, index);
    EXPECT_TRUE(one.planted) << one.kind;
    EXPECT_EQ(one.kind, kinds[index]);
    EXPECT_TRUE(truth(one.before).valid()) << one.kind;
    EXPECT_EQ(one.kind == "sound", one.mesh.tets == one.before.tets && one.mesh.points == one.before.points)
        << one.kind;
    // Mutants that are valid by themselves are not called defective, but for slits.
    if (one.kind != "sound" && !plant_kind(one.kind).has("slit") && one.expected == Expected::sound) {
      EXPECT_TRUE(truth(one.mesh).valid()) << one.kind;
    }
  }
}

TEST(PlantedCase, IsAFunctionOfSeedAndIndex) {
  const auto kinds = checked_kinds({"inverted-inside", "sound"});
  std::set<std::string> grounds;
  for (std::uint64_t index = 0; index < 12; ++index) {
    const PlantedCase a = planted_case(kinds, 5, index), b = planted_case(kinds, 5, index);
    EXPECT_EQ(a.mesh.tets, b.mesh.tets);
    EXPECT_EQ(a.mesh.points, b.mesh.points);
    grounds.insert(a.ground);
  }
  EXPECT_GE(grounds.size(), 4u);
  EXPECT_THROW(checked_kinds({"no-such-kind"}), InputError);
}

TEST(PlantedCase, BoundariesAreComparedByCoordinates) {
  const TetMesh mesh = block_mesh({2, 1, 1});
  TetMesh renumbered = mesh, less = mesh;
  std::rotate(renumbered.tets.begin(), renumbered.tets.begin() + 3, renumbered.tets.end());
  less.tets.pop_back();
  EXPECT_TRUE(same_boundary(mesh, renumbered));
  EXPECT_FALSE(same_boundary(mesh, less));
  EXPECT_EQ(boundary_of(mesh).triangles.size(), 20u);  // 2 x (2 + 2 + 1) squares
}

TEST(WriteExactly, SaysWhatAFormatCannotHold) {
  const test::ScratchFolder files;
  TetMesh mesh = block_mesh({1, 1, 1}, 0.1);
  for (const char* format : {"msh22", "msh41", "vtu", "vtk", "medit", "tetgen"})
    EXPECT_EQ(write_exactly(files / ("a." + std::string(format == std::string("tetgen") ? "ele" : "x")),
                            format, mesh),
              "")
        << format;
  mesh.tets[0][1] = 99;  // a number that no point has
  EXPECT_EQ(write_exactly(files / "b.msh", "msh22", mesh), "");
  EXPECT_NE(write_exactly(files / "b.vtu", "vtu", mesh), "");
  EXPECT_NE(write_exactly(files / "b.stl", "stl", mesh), "");
  mesh.tets[0][1] = 1;
  mesh.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(write_exactly(files / "c.msh", "msh22", mesh), "");
}

}  // namespace
}  // namespace tetproof::corpus
