// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign against a C++ function, as a test suite asserts it.
#include "corpus/check_mesher.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>

#include "io/error.hpp"
#include "io/surface_files.hpp"
#include "tests/fuzz/star_mesh.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Meshes star-shaped solids rightly, and refuses the others.
TetMesh right(const TriangleSurface& surface) {
  return tetproof::test::star_mesh(surface);
}

TetMesh doubles_one_of_many(const TriangleSurface& surface) {
  TetMesh mesh = right(surface);
  if (mesh.tets.size() > 11) mesh.tets.push_back(mesh.tets[3]);
  return mesh;
}

class CheckMesher : public ::testing::Test {
 protected:
  CheckOptions options(std::uint64_t cases) const {
    return {.cases = cases,
            .surfaces = {.kinds = {"cylinder", "bipyramid"}, .modifiers = {"none"}},
            .shrink_s = 4,
            .folder = files / "out"};
  }
  // The surfaces among the files of a campaign, at any depth.
  std::vector<std::filesystem::path> surfaces(const char* name) const {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(files / "out"))
      if (entry.path().filename().string().starts_with(name)) found.push_back(entry.path());
    return found;
  }
  tetproof::test::ScratchFolder files;
};

TEST_F(CheckMesher, ARightFunctionIsGood) {
  const MesherCheck check = check_mesher(right, options(20));
  EXPECT_TRUE(check.good) << check.message;
  EXPECT_THAT(check.message, StartsWith("seed 1: 1 mesher on 20 surfaces: "));
  EXPECT_TRUE(surfaces("running-").empty());
}

TEST_F(CheckMesher, AFailureHasTheSmallestSurfaceAndTheFindings) {
  const MesherCheck check = check_mesher(doubles_one_of_many, options(20));
  EXPECT_FALSE(check.good);
  EXPECT_THAT(check.message,
              AllOf(HasSubstr("1. mesher:wrong-answer:duplicate-tet: "), HasSubstr("FAIL duplicate-tet: 1"),
                    HasSubstr("12 triangles: " + (files / "out/findings/"))));
  const auto found = surfaces("surface.off");
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(check.message, HasSubstr(found[0].string()));
  EXPECT_EQ(read_surface(found[0].string()).triangles.size(), 12u);
}

// The function may have been mended since.
TEST_F(CheckMesher, EarlierResultsAreNotUsedAgain) {
  EXPECT_FALSE(check_mesher(doubles_one_of_many, options(20)).good);
  const MesherCheck check = check_mesher(right, options(20));
  EXPECT_TRUE(check.good) << check.message;
  EXPECT_TRUE(surfaces("surface.off").empty());
}

TEST_F(CheckMesher, SlicesAreTheWholeCampaign) {
  std::set<std::size_t> whole, cut;
  std::mutex mutex;
  std::size_t calls = 0;
  const auto into = [&](std::set<std::size_t>& sizes) {
    return [&](const TriangleSurface& surface) {
      const std::lock_guard lock(mutex);
      sizes.insert(surface.triangles.size());
      ++calls;
      return right(surface);
    };
  };
  check_mesher(into(whole), options(20));
  EXPECT_EQ(calls, 20u);
  for (int slice = 0; slice < 3; ++slice) {
    CheckOptions part = options(20);
    part.slice = slice;
    part.slices = 3;
    check_mesher(into(cut), part);
  }
  EXPECT_EQ(calls, 40u);
  EXPECT_EQ(cut, whole);
  CheckOptions none = options(20);
  none.slice = none.slices = 3;
  EXPECT_THROW(check_mesher(right, none), InputError);
}

TEST_F(CheckMesher, AFunctionThatRefusesEverythingIsNotGood) {
  const MeshFunction refuses = [](const TriangleSurface&) -> TetMesh {
    throw std::runtime_error("no licence");
  };
  const MesherCheck check = check_mesher(refuses, options(5));
  EXPECT_FALSE(check.good);
  EXPECT_THAT(check.message, AllOf(HasSubstr("5 refused"), HasSubstr("not one mesh is sound"),
                                   HasSubstr("refused: no licence, first on fuzz:")));
}

TEST_F(CheckMesher, WhatIsNotSeenAgainIsSaid) {
  std::atomic<int> calls{0};
  const MeshFunction once = [&](const TriangleSurface& surface) {
    TetMesh mesh = right(surface);
    if (calls++ == 3) mesh.tets.pop_back();
    return mesh;
  };
  CheckOptions how = options(5);
  how.threads = 1;
  const MesherCheck check = check_mesher(once, how);
  EXPECT_FALSE(check.good);
  EXPECT_THAT(check.message, HasSubstr("not seen again"));
}

// The program starts itself for this: its child crashes.
constexpr const char* folder_variable = "TETPROOF_TEST_CRASHING_FUNCTION";

TEST(CrashingFunction, Crashes) {
  const char* folder = std::getenv(folder_variable);
  if (!folder) GTEST_SKIP() << "the child of CheckMesher.ACrashLeavesItsSurface";
  const MeshFunction crashes = [](const TriangleSurface& surface) {
    if (surface.triangles.size() > 20) ::raise(SIGKILL);
    return right(surface);
  };
  check_mesher(crashes, {.cases = 40, .surfaces = {.kinds = {"bipyramid"}}, .threads = 1, .folder = folder});
}

TEST_F(CheckMesher, ACrashLeavesItsSurface) {
  const auto child =
      tetproof::test::run_program({"/proc/self/exe", "--gtest_filter=CrashingFunction.*"},
                                  {.environment = {folder_variable + ("=" + (files / "out"))}});
  EXPECT_EQ(child.signal, SIGKILL) << child;
  const auto found = surfaces("running-");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(read_surface(found[0].string()).triangles.size(), 20u);
  check_mesher(right, options(3));
  EXPECT_TRUE(surfaces("running-").empty());
}

TEST_F(CheckMesher, OneSurface) {
  const TriangleSurface small = build(parse_recipe("bipyramid(n=3)")).surface,
                        large = build(parse_recipe("bipyramid(n=9)")).surface;
  const std::string file = files / "smallest.off";
  EXPECT_TRUE(check_mesher_on(small, doubles_one_of_many, file).good);
  EXPECT_FALSE(std::filesystem::exists(file));
  const MesherCheck check = check_mesher_on(large, doubles_one_of_many, file);
  EXPECT_FALSE(check.good);
  EXPECT_THAT(check.message, AllOf(StartsWith("18 triangles: " + file + "\nwrong-answer: "),
                                   HasSubstr("FAIL duplicate-tet: 1")));
  EXPECT_EQ(read_surface(file).triangles, large.triangles);
}

}  // namespace
}  // namespace tetproof::corpus
