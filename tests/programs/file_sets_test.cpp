// SPDX-License-Identifier: GPL-3.0-or-later
// Files of single programs: TetGen's sets as inputs and outputs, targets that cannot hold a grid, and lists
// of checks beside a mesh.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/programs/common_jobs.hpp"

namespace tetproof::test {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class OneProgram : public ::testing::Test {
 protected:
  Outcome run(std::vector<std::string> words) const {
    words[0] = program(words[0]);
    return run_program(words, {.directory = folder.path()});
  }
  void refused(const std::vector<std::string>& words, const std::string& message) const {
    const std::vector<std::string> there = folder.names();
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(folder.names(), there);
  }
  ScratchFolder folder;
};

using ConvertFiles = OneProgram;

// A set of TetGen is one input. Its other files count if they are read.
TEST_F(ConvertFiles, EveryFileOfASetThatIsReadIsAnInput) {
  folder.write("a.node", octahedron_node);
  folder.write("a.ele", octahedron_ele);
  folder.write("a.edge", "1 0\n1 1 2\n");
  for (const char* out : {"a.node", "a.ele", "a.face", "./a.edge"})
    refused({"tetproof-convert", "a.ele", out}, " is the same file as a.");
  for (const char* out : {"a.msh", "b.node", "a.1.node"})
    EXPECT_EQ(run({"tetproof-convert", "a.ele", out}).exit_code, 0) << out;
  // A .poly has its own points, but its edges would be written to the .edge that was read.
  refused({"tetproof-convert", "a.ele", "a.poly"}, "a.edge (OUT) is the same file as a.edge (IN)");
  fs::remove(folder / "a.edge");
  EXPECT_EQ(run({"tetproof-convert", "a.ele", "a.poly"}).exit_code, 0);
  EXPECT_EQ(folder.read("a.node"), octahedron_node);
}

TEST_F(ConvertFiles, TheNodesOfAPolygonsFileAreReadIfItHasNone) {
  const std::string facets = "1 0\n1\n3 1 2 3\n0\n0\n", nodes = "3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";
  folder.write("own.poly", nodes + facets);
  folder.write("own.node", "older");
  EXPECT_EQ(run({"tetproof-convert", "own.poly", "own.node"}).exit_code, 0);
  folder.write("other.poly", "0 3\n" + facets);
  folder.write("other.node", nodes);
  refused({"tetproof-convert", "other.poly", "other.node"},
          "other.node (OUT) is the same file as other.node (IN)");
  EXPECT_EQ(folder.read("other.node"), nodes);
}

// Only after reading is it known whether a .edge is written.
TEST_F(ConvertFiles, AllFilesOfASetThatIsWrittenAreOutputs) {
  folder.write("a.node", octahedron_node);
  folder.write("a.ele", octahedron_ele);
  refused({"tetproof-convert", "a.ele", "b.node", "--json", "b.ele"}, "b.ele (--json)");
  EXPECT_EQ(run({"tetproof-convert", "a.ele", "b.node", "--json", "b.edge"}).exit_code, 0);
  folder.write("a.edge", "1 0\n1 1 2\n");
  refused({"tetproof-convert", "a.ele", "c.node", "--losses", "c.edge"}, "c.edge (--losses)");
}

TEST_F(ConvertFiles, AFileIsNotConvertedIntoItself) {
  folder.write("a.msh", octahedron_msh);
  fs::create_symlink("a.msh", folder / "b.msh");
  refused({"tetproof-convert", "a.msh", "a.msh", "--binary"},
          "a.msh (OUT) is the same file as a.msh (IN): an output may not take the place of an input");
  refused({"tetproof-convert", "b.msh", "a.msh"}, "a.msh (OUT) is the same file as b.msh (IN)");
  EXPECT_EQ(folder.read("a.msh"), octahedron_msh);
}

using MeshFiles = OneProgram;

// The refusal comes before the surface is read. The surface does not even exist.
TEST_F(MeshFiles, ATargetWithoutTetrahedraIsRefusedBeforeTheWork) {
  for (const char* out :
       {"grid.stl", "grid.off", "grid.obj", "grid.ply", "grid.poly", "grid.smesh", "grid.vol", "grid.neigh"})
    refused({"tetproof-mesh", "missing.off", "-o", out}, std::string(out) + ": ");
  refused({"tetproof-mesh", "missing.off", "-o", "grid.stl"},
          "grid.stl: STL holds no tetrahedra; expected one of .msh .node .ele");
  refused({"tetproof-verify", "missing.msh", "--defects", "grid.STL"}, "grid.STL: STL holds no tetrahedra");
  refused({"tetproof-mesh", "missing.off", "-o", "grid.node", "--binary"}, "never binary");
  for (const char* out : {"grid.msh", "grid.node", "grid.ele", "grid.face", "grid.vtu", "grid.vtk",
                          "grid.mesh", "grid.meshb", "grid.MSH"})
    EXPECT_EQ(run({"tetproof-mesh", "box", "--cells", "2", "--points", "0", "-o", out}).exit_code, 0) << out;
}

TEST_F(MeshFiles, TheTraceToFollowIsAnInput) {
  ASSERT_EQ(run({"tetproof-mesh", "box", "--cells", "3", "--trace", "a.jsonl"}).exit_code, 0);
  refused({"tetproof-mesh", "box", "--cells", "3", "--follow", "a.jsonl", "--trace", "a.jsonl"},
          "a.jsonl (--trace) is the same file as a.jsonl (--follow)");
  // A generated surface is not a file.
  EXPECT_EQ(run({"tetproof-mesh", "box", "--cells", "3", "--trace", "box"}).exit_code, 0);
}

TEST_F(MeshFiles, WhatTheFormatCannotHoldIsListed) {
  for (const char* out : {"a.msh", "a.node", "a.vtu"}) {
    const Outcome outcome = run({"tetproof-mesh", "box", "--cells", "2", "-o", out, "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const nlohmann::json json = nlohmann::json::parse(outcome.out);
    for (const char* key : {"losses", "kept_aside", "dropped"})
      EXPECT_EQ(json.at(key), nlohmann::json::array()) << out << " " << key;
  }
}

using VerifyFiles = OneProgram;

TEST_F(VerifyFiles, AListOfChecksIsOneWord) {
  folder.write("a.node", octahedron_node);
  folder.write("a.ele", octahedron_ele);
  const auto judged = [&](const std::vector<std::string>& words, const std::string& id, const char* verdict) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    for (const auto& check : report["checks"])
      if (check["id"] == id) {
        EXPECT_EQ(check["verdict"], verdict) << id;
      }
  };
  judged({"tetproof-verify", "--check", "flat,inverted", "a.node", "--json", "-"}, "flat", "pass");
  judged({"tetproof-verify", "--check", "flat,inverted", "a.node", "--json", "-"}, "overlap", "skipped");
  judged({"tetproof-verify", "--skip", "flat,inverted", "a.node", "--json", "-"}, "inverted", "skipped");
  judged({"tetproof-verify", "--skip", "flat", "--skip", "inverted", "a.node", "--json", "-"}, "flat",
         "skipped");
  judged({"tetproof-verify", "--skip", "flat", "--skip", "inverted", "a.node", "--json", "-"}, "inverted",
         "skipped");
  refused({"tetproof-verify", "--check", "flat", "no-such-check", "a.node"}, "");
}

}  // namespace
}  // namespace tetproof::test
