// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-verify --defects, read by VTK: the elements that the findings of the JSON name are there and are
// marked, with one ring of neighbours, and nothing else is.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

constexpr const char* python = "/usr/bin/python3";  // the one that Debian's packages belong to

TEST(VerifyDefects, HoldWhatTheReportNamesAndOneRing) {
  if (run_program({python, "-c", "import vtk"}).exit_code != 0)
    GTEST_SKIP() << "VTK's Python module is not installed";
  const std::string meshes = TETPROOF_SOURCE_DIR "/corpus/bad-meshes/";
  // Meshes, and the surfaces that they should fill.
  const std::vector<std::array<std::string, 2>> cases{
      {"sound-block", ""},
      {"index-negative", ""},
      {"index-and-flat", ""},
      {"nan-on-boundary", ""},
      {"infinity", ""},
      {"repeated-vertex", ""},
      {"copy-in-place", ""},
      {"unused-duplicate-point", ""},
      {"duplicate-tet-mirrored", ""},
      {"inverted-half", ""},
      {"flat-on-edge", ""},
      {"face-shared-thrice", ""},
      {"two-on-one-side", ""},
      {"hanging-and-hanging", ""},
      {"crossed-diagonals", ""},
      {"crack-through-mesh", ""},
      {"blocks-side-by-side", ""},
      {"copy-in-place", ""},
      {"numbers-shifted", ""},
      {"near-contact", ""},
      {"missing-ball", ""},
      {"pinched-chain", ""},
      {"foreign-tet", ""},
      {"inside-another", ""},
      {"sound-block", "box:x1=2,y1=2,z1=2.5"},
      {"sound-block", "box:x1=2,y1=2,z1=1.5"},
  };
  const ScratchFolder folder;
  std::vector<std::string> check{python, TETPROOF_SOURCE_DIR "/tests/programs/defects.py"};
  std::set<std::string> ids;
  for (const auto& [mesh, surface] : cases) {
    const std::string stem = folder / std::to_string(check.size());
    std::vector<std::string> command{program("tetproof-verify"),
                                     meshes + mesh + ".ele",
                                     "--json",
                                     stem + ".json",
                                     "--defects",
                                     stem + ".vtu"};
    if (!surface.empty()) command.insert(command.begin() + 2, surface);
    const Outcome judged = run_program(command);
    ASSERT_LE(judged.exit_code, 1) << judged;
    check.insert(check.end(), {command[1], stem + ".json", stem + ".vtu"});
    const nlohmann::json report = nlohmann::json::parse(std::ifstream(stem + ".json"));
    for (const auto& result : report["checks"])
      if (!result["findings"].empty()) ids.insert(result["id"]);
  }
  const Outcome checked = run_program(check);
  EXPECT_EQ(checked.exit_code, 0) << checked;
  EXPECT_EQ(checked.out, "");
  EXPECT_EQ(checked.err, "");  // VTK's warnings
  EXPECT_GT(ids.size(), 18u) << testing::PrintToString(ids);
}

TEST(VerifyDefects, InOtherMeshFormatsToo) {
  const ScratchFolder folder;
  const std::string mesh = TETPROOF_SOURCE_DIR "/corpus/bad-meshes/foreign-tet.msh";
  const Outcome judged = run_program({program("tetproof-verify"), mesh, "--defects", folder / "defects.msh"});
  EXPECT_EQ(judged.exit_code, 1) << judged;
  const Outcome info = run_program({program("tetproof-convert"), "--info", folder / "defects.msh"});
  EXPECT_EQ(info.exit_code, 0) << info;
  EXPECT_THAT(info.out, testing::HasSubstr("tetrahedron of 4 nodes"));
}

}  // namespace
}  // namespace tetproof::test
