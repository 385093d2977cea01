// SPDX-License-Identifier: GPL-3.0-or-later
// The options of tetproof-convert that edit: what they say, their order, and what --strict and --json make of
// them.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

// Two tetrahedra and a triangle at the bottom of the first; node 60 is of no element.
const char* const mixed =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"steel\"\n2 9 "
    "\"bottom\"\n$EndPhysicalNames\n"
    "$Nodes\n6\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 1 1 1\n60 9 9 9\n$EndNodes\n"
    "$Elements\n3\n7 2 2 9 6 10 20 30\n8 4 2 1 3 10 20 30 40\n9 4 2 2 3 20 30 40 50\n$EndElements\n";
// The tetrahedron beyond one side of them.
const char* const neighbour =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 4 \"steel\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 0 1\n4 0 -1 0\n$EndNodes\n"
    "$Elements\n1\n1 4 2 4 1 1 3 2 4\n$EndElements\n";

class ConvertEdits : public testing::Test {
 protected:
  ConvertEdits() {
    folder.write("a.msh", mixed);
    folder.write("b.msh", neighbour);
  }
  Outcome convert(std::vector<std::string> words) {
    words.insert(words.begin(), program("tetproof-convert"));
    return run_program(words, {.directory = folder / ""});
  }
  std::string section(const std::string& file, const std::string& name) {
    const std::string text = folder.read(file);
    const std::size_t from = text.find("$" + name + "\n"), end = text.find("$End" + name);
    return from == text.npos ? "" : text.substr(from + name.size() + 2, end - from - name.size() - 2);
  }

  const ScratchFolder folder;
};

TEST_F(ConvertEdits, OnlyPruneAndRenumber) {
  const Outcome run = convert(
      {"a.msh", "c.msh", "--to", "msh22", "--renumber", "--prune", "--only", "tetrahedra", "--strict"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err,
            "--only tetrahedra: 2 of 3 elements kept; left out: 1 triangle\n"
            "--prune: 1 unused point left out\n"
            "--renumber: 5 nodes and 2 elements numbered anew, from 1 on\n");
  EXPECT_EQ(section("c.msh", "Elements"), "2\n1 4 2 1 3 1 2 3 4\n2 4 2 2 3 2 3 4 5\n");
}

TEST_F(ConvertEdits, BoundaryIsTheSurfaceOfTheSolids) {
  const Outcome run =
      convert({"a.msh", "c.msh", "--to", "msh22", "--boundary", "--scale", "2", "--translate", "-1,0,0"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(
      run.err,
      "--scale 2: 6 points scaled by 2\n--translate -1,0,0: 6 points moved by (-1, 0, 0)\n"
      "--boundary: 6 boundary faces of 2 solids in place of 3 elements; 1 of them was an element before\n");
  EXPECT_EQ(section("c.msh", "PhysicalNames"), "3\n3 1 \"steel\"\n2 9 \"bottom\"\n2 1 \"steel\"\n");
  EXPECT_EQ(section("c.msh", "Nodes").substr(0, 32), "6\n10 -1 0 0\n20 1 0 0\n30 -1 2 0\n4");
}

TEST_F(ConvertEdits, JoinsInputs) {
  const Outcome run = convert({"a.msh", "b.msh", "c.msh", "--to", "msh22", "--merge-points", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["inputs"].size(), 2u);
  EXPECT_EQ(json["input"]["elements"]["count"], 4);
  ASSERT_EQ(json["edits"].size(), 2u);
  EXPECT_EQ(json["edits"][0]["option"], "IN b.msh");
  EXPECT_EQ(json["edits"][1]["option"], "--merge-points");
  EXPECT_EQ(json["edits"][1]["did"], "3 points merged into others at the same place");
  EXPECT_EQ(section("c.msh", "PhysicalNames"),
            "2\n3 1 \"steel\"\n2 9 \"bottom\"\n");  // one group of two files
  // Numbers 1 to 4 are those of no node in a.msh: they stay.
  EXPECT_EQ(section("c.msh", "Elements"),
            "4\n7 2 2 9 6 10 20 30\n8 4 2 1 3 10 20 30 40\n9 4 2 2 3 20 30 40 50\n1 4 2 1 1 10 40 20 4\n");
}

TEST_F(ConvertEdits, MergePointsTakesItsToleranceInTwoWays) {
  folder.write("c.off", "OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 1 .001\n4 0 1 2 3\n");
  const std::string expected =
      "--merge-points=0.01: 1 point merged into others within 0.01; 1 element has a node twice now\n";
  EXPECT_EQ(convert({"c.off", "d.off", "--merge-points", "0.01"}).err, expected);
  EXPECT_EQ(convert({"--merge-points=0.01", "c.off", "d.off"}).err, expected);
  EXPECT_EQ(folder.read("d.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 2\n");
  EXPECT_EQ(convert({"--merge-points", "c.off", "d.off"}).err,
            "--merge-points: 0 points merged into others at the same place\n");
}

TEST_F(ConvertEdits, SplitsByGroup) {
  const Outcome run = convert({"a.msh", "c.1.node", "--split-by-group", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run;
  for (const char* file : {"c_steel.1.ele", "c_2.1.ele", "c_bottom.1.face"})
    EXPECT_NE(folder.read(file), "") << file;
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["outputs"].size(), 3u);
  EXPECT_EQ(json["outputs"][0]["file"], "c_steel.1.node");
  EXPECT_EQ(json["outputs"][0]["written"], true);
  EXPECT_NE(run.err.find("--split-by-group: 3 files\nc_steel.1.node: 4 nodes and 1 element\n"),
            std::string::npos)
      << run;
}

// With --strict, a loss in one of several files means that none is written.
TEST_F(ConvertEdits, StrictWritesAllFilesOrNone) {
  const Outcome run = convert({"a.msh", "c.stl", "--split-by-group", "--strict"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.msh", "b.msh"}));
  EXPECT_NE(run.err.find("c.stl: not written, since several things of a.msh would be lost (--strict)\n"),
            std::string::npos)
      << run;
}

// What an edit leaves out because it was asked for is no loss; what goes with it is one.
TEST_F(ConvertEdits, StrictAndWhatEditsLose) {
  folder.write("p.msh", std::string(mixed) + "$Mine\n10\n$EndMine\n");
  EXPECT_EQ(convert({"p.msh", "c.msh", "--only", "tetrahedra", "--strict"}).exit_code, 0);
  const Outcome run = convert({"p.msh", "d.msh", "--renumber", "--strict", "--losses", "-"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_EQ(nlohmann::json::parse(run.out)["losses"][0]["item"], "sections");
}

TEST_F(ConvertEdits, TriangulatesEveryFormatAlike) {
  folder.write("c.off", "OFF 5 1 0\n0 0 0\n2 0 0\n2 2 0\n1 .5 0\n0 2 0\n5 0 1 2 3 4\n");
  for (const char* through : {"d.obj", "d.ply", "d.vtk", "d.vtu", "d.off", "d.poly", "d.smesh", "d.msh"}) {
    ASSERT_EQ(convert({"c.off", through, "--quiet"}).exit_code, 0) << through;
    const Outcome run = convert({through, "e.off", "--triangulate"});
    EXPECT_EQ(run.exit_code, 0) << through << run;
    EXPECT_NE(run.err.find("--triangulate: 1 polygon cut into 3 triangles\n"), std::string::npos)
        << through << run;
    EXPECT_EQ(folder.read("e.off"),
              "OFF\n5 3 0\n0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n3 0 1 3\n3 0 3 4\n3 1 2 3\n")
        << through;
  }
}

TEST_F(ConvertEdits, InfoShowsWhatEditsMake) {
  const Outcome run = convert({"--info", "a.msh", "--boundary", "--prune"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_NE(run.out.find("         6 of them triangle of 3 nodes"), std::string::npos) << run;
}

// What --info finds is judged and listed as that of a conversion.
TEST_F(ConvertEdits, InfoTellsTheSizesOfPolygonsAndPolylines) {
  folder.write(
      "c.vtk",
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 7 double\n0 0 0 1 0 0 2 1 0 1 2 0 0 2 0 "
      "-1 1 0 5 5 5\nLINES 2 9\n3 0 1 6\n4 0 1 2 6\nPOLYGONS 3 19\n5 0 1 2 3 4\n6 0 1 2 3 4 5\n5 0 1 2 3 "
      "5\n");
  const Outcome run = convert({"--info", "c.vtk"});
  EXPECT_NE(run.out.find("         3 of them polygon of 5 to 6 nodes"), std::string::npos) << run;
  EXPECT_NE(run.out.find("         2 of them polyline of 3 to 4 nodes"), std::string::npos) << run;
}

TEST_F(ConvertEdits, InfoListsLosses) {
  folder.write("p.msh", std::string(mixed) + "$Mine\n10\n$EndMine\n");
  const Outcome run = convert({"--info", "p.msh", "--renumber", "--strict", "--losses", "l.json"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_NE(run.out.find("2 of them tetrahedron of 4 nodes"), std::string::npos) << run;
  EXPECT_NE(run.err.find("p.msh: something would be lost (--strict)\n"), std::string::npos) << run;
  const auto json = nlohmann::json::parse(folder.read("l.json"));
  EXPECT_EQ(json["losses"][0]["item"], "sections");
  EXPECT_EQ(json["dropped"].size(), 0u);
  EXPECT_EQ(convert({"--info", "p.msh", "--strict", "--losses", "m.json"}).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(folder.read("m.json"))["losses"].size(), 0u);
}

// Each group has a file of its own, though three names are nearly the same.
TEST_F(ConvertEdits, SplitsIntoDifferentFiles) {
  folder.write("c.msh",
               "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n3 1 \"a\"\n3 2 \"A\"\n3 3 "
               "\"a_solids_1\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
               "$Elements\n3\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 1 2 3 4\n3 4 2 3 3 1 2 3 4\n$EndElements\n");
  EXPECT_EQ(convert({"c.msh", "d.msh", "--to", "msh22", "--split-by-group"}).exit_code, 0);
  EXPECT_EQ(section("d_a_solids_1_.msh", "Elements"), "1\n1 4 2 1 1 1 2 3 4\n");
  EXPECT_EQ(section("d_A_solids_2.msh", "Elements"), "1\n2 4 2 2 2 1 2 3 4\n");
  EXPECT_EQ(section("d_a_solids_1.msh", "Elements"), "1\n3 4 2 3 3 1 2 3 4\n");
  folder.write("e_A_solids_2.msh", "");
  std::filesystem::create_symlink("e_A_solids_2.msh", folder / "e_a_solids_1.msh");
  const Outcome run = convert({"c.msh", "e.msh", "--split-by-group"});
  EXPECT_EQ(run.exit_code, 2) << run;
  EXPECT_NE(run.err.find("each output needs a file of its own"), std::string::npos) << run;
}

TEST_F(ConvertEdits, Usage) {
  const auto said = [&](const std::vector<std::string>& words) {
    const Outcome run = convert(words);
    EXPECT_EQ(run.exit_code, 2) << run;
    EXPECT_EQ(lines(run.err), 1u) << run;
    return run.err;
  };
  EXPECT_EQ(said({"a.msh", "c.msh", "--translate", "1,2"}),
            "tetproof-convert: --translate: expected three numbers X,Y,Z, found '1,2'\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--scale", "0"}),
            "tetproof-convert: --scale: expected a factor above 0, found 0\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--merge-points=-1"}),
            "tetproof-convert: --merge-points: expected a distance of at least 0, found -1\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--merge-points="}),
            "tetproof-convert: --merge-points: expected a number, found ''\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--translate", "1,inf,0"}),
            "tetproof-convert: --translate: expected three finite numbers X,Y,Z, found '1,inf,0'\n");
  for (const char* option : {"--only", "--translate", "--scale", "--losses", "--to", "--from"})
    EXPECT_EQ(said({"a.msh", "c.msh", option, ""}),
              std::string("tetproof-convert: ") + option +
                  ": expected a value, found '' (see tetproof-convert --help)\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--merge-points=x"}),
            "tetproof-convert: --merge-points: expected a number, found 'x'\n");
  EXPECT_EQ(said({"a.msh", "c.msh", "--only", "prisms"}),
            "tetproof-convert: a.msh: none of the 3 elements is of type prisms\n");
  EXPECT_EQ(said({"--info", "a.msh", "--split-by-group"}),
            "tetproof-convert: --info writes no file: leave out --split-by-group\n");
  EXPECT_EQ(said({"-", "-", "c.msh"}),
            "tetproof-convert: IN - and IN 2 -: only one of them can be standard input\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.msh", "b.msh"}));
}

}  // namespace
}  // namespace tetproof::test
