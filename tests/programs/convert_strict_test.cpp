// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-convert: what --strict and --strict-native refuse, sets of files, and messages of one line.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/programs/two_groups.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

// A hexahedron fits no file of TetGen's, only a comment that our reader takes back.
TEST(ConvertStrict, StrictRefusesElementsThatOnlyACommentHolds) {
  const ScratchFolder folder;
  folder.write(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n"
      "6 1 0 1\n7 1 1 1\n8 0 1 1\n9 .5 .5 2\n$EndNodes\n$Elements\n2\n1 5 2 0 1 1 2 3 4 5 6 7 8\n"
      "2 4 2 0 1 5 6 7 9\n$EndElements\n");
  const auto convert = [&](const std::string& option) {
    std::vector<std::string> words{program("tetproof-convert"), "a.msh", "b.node"};
    if (!option.empty()) words.push_back(option);
    return run_program(words, {.directory = folder / ""});
  };
  const Outcome strict = convert("--strict");
  EXPECT_EQ(strict.exit_code, 1) << strict;
  EXPECT_NE(strict.err.find("kept in comments: hexahedra of 8 nodes (type 5): 1 (element 1)\n"),
            std::string::npos)
      << strict;
  EXPECT_NE(
      strict.err.find("b.node: not written, since something of a.msh would stand in comments only, which "
                      "other programs do not read (--strict)\n"),
      std::string::npos)
      << strict;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.msh"});
  EXPECT_EQ(convert("").exit_code, 0);
}

// Gmsh and Medit refuse a file with an element whose node is missing; our reader takes it back.
TEST(ConvertStrict, StrictNativeRefusesElementsWithoutTheirNodes) {
  const ScratchFolder folder;
  folder.write(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n2\n1 4 2 0 1 1 2 3 4\n2 4 2 0 1 1 2 3 9\n$EndElements\n");
  for (const char* to : {"b.msh", "b.mesh", "b.node"}) {
    const auto convert = [&](const char* option) {
      return run_program({program("tetproof-convert"), "a.msh", to, option}, {.directory = folder / ""});
    };
    const Outcome native = convert("--strict-native");
    EXPECT_EQ(native.exit_code, 1) << to << native;
    EXPECT_NE(
        native.err.find("elements that name nodes which do not exist: 1 (element 2 names node 9): other "
                        "programs may refuse the file\n"),
        std::string::npos)
        << to << native;
    EXPECT_NE(native.err.find("of a.msh would name nodes that do not exist (--strict-native)\n"),
              std::string::npos)
        << to << native;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.msh"});
  }
  EXPECT_EQ(
      run_program({program("tetproof-convert"), "a.msh", "b.msh", "--strict"}, {.directory = folder / ""})
          .exit_code,
      0);
}

TEST(ConvertStrict, StrictNativeKeepsNothingAside) {
  const ScratchFolder folder;
  folder.write("a.msh", two_groups);
  const auto convert = [&](std::vector<std::string> words) {
    words.insert(words.begin(), program("tetproof-convert"));
    return run_program(words, {.directory = folder / ""});
  };
  const Outcome tetgen = convert({"a.msh", "b.ele", "--strict-native"});
  EXPECT_EQ(tetgen.exit_code, 1) << tetgen;
  EXPECT_NE(tetgen.err.find("kept in comments: names of physical groups: 1 (steel)\n"), std::string::npos)
      << tetgen;
  EXPECT_NE(
      tetgen.err.find("b.ele: not written, since several things of a.msh would stand in comments only, which "
                      "other programs do not read (--strict-native)\n"),
      std::string::npos)
      << tetgen;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.msh"});
  EXPECT_EQ(convert({"a.msh", "b.vtu", "--strict-native"}).exit_code, 1);  // a loss
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.msh"});
  EXPECT_EQ(convert({"a.msh", "b.msh", "--strict-native"}).exit_code, 0);
  EXPECT_EQ(folder.read("b.msh"), two_groups);
}

// A solution is read with its mesh, so neither may be written over.
TEST(ConvertStrict, SolutionsAreFilesInUse) {
  const ScratchFolder folder;
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  folder.write("a.mesh", head + "Vertices 1\n0 0 0 0\nEnd\n");
  folder.write("a.sol", head + "SolAtVertices 1\n1 1\n0.5\nEnd\n");
  const auto convert = [&](const std::string& in, const std::string& out) {
    return run_program({program("tetproof-convert"), in, out}, {.directory = folder / ""});
  };
  EXPECT_EQ(convert("a.sol", "a.mesh").exit_code, 2);
  EXPECT_EQ(convert("a.mesh", "a.sol").exit_code, 2);
  const Outcome run = convert("a.sol", "b.mesh");
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err,
            "warning: b.sol: is written too, with the values \"solution\"; MMG takes one field for the "
            "sizes it shall make\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.mesh", "a.sol", "b.mesh", "b.sol"}));
}

// Names, titles and words of files, with characters that a terminal obeys: messages, --info and JSON have
// none of them, and each message is one line.
TEST(ConvertStrict, SaysEverythingInOneLine) {
  const std::string bad = "red\x1b[31m\x7f\xC2\x9B\xE2\x80\xA8\x07";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::vector<std::pair<std::string, std::string>> texts{
      {"a.ply", "ply\nformat ascii 1.0\ncomment " + bad + "\nelement vertex 3\n" + xyz + "property float " +
                    bad + "\nelement face 1\nproperty list uchar int vertex_indices\nelement " + bad +
                    " 1\nproperty int " + bad + "\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n7\n"},
      {"b.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + bad + "\n"},
      {"a.obj", "# " + bad + "\nmtllib " + bad + "\n" + bad + " 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng " + bad +
                    "\nusemtl " + bad + "\ns " + bad + "\nf 1 2 3\n"},
      {"b.obj", "v 0 0 0\nv 1 0 " + bad + "\n"},
      {"a.stl", "solid " + bad +
                    "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                    "endloop\nendfacet\nendsolid\n" +
                    bad},
      {"b.stl", "solid\n" + bad},
      {"a.off", "OFF # " + bad + "\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"b.off", "OFF\n" + bad},
      {"a.msh",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"" + bad +
           "\"\n$EndPhysicalNames\n"
           "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n1 4 2 7 1 1 2 3 4\n"
           "$EndElements\n$NodeData\n1\n\"" +
           bad + "\"\n0\n3\n0\n1\n1\n1 5\n$EndNodeData\n" + bad},
      {"b.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + bad + "\n"},
      {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 0 0\nMine\n" + bad + "\nEnd\n" + bad},
      {"b.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 " + bad + "\n"},
      {"a.node", "1 3 0 0\n1 0 0 0 " + bad + "\n" + bad},
      {"b.node", "1 3 0 0\n1 0 0 " + bad},
      {"a.poly", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n1\n3 1 2 3 " + bad + "\n0\n"},
      {"a.vtk",
       "# vtk DataFile Version 3.0\n" + bad +
           "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 double\n0 0 0\nCELLS 1 2\n1 0\nCELL_TYPES 1\n1\n"
           "POINT_DATA 1\nSCALARS " +
           bad + " double 1\nLOOKUP_TABLE default\n1\n" + bad + "\n"},
      {"a.vtu",
       "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
       "byte_order=\"LittleEndian\"><UnstructuredGrid><Piece "
       "NumberOfPoints=\"1\" NumberOfCells=\"0\"><Points><DataArray type=\"Float64\" "
       "NumberOfComponents=\"3\" "
       "format=\"ascii\">0 0 0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
       "format=\"ascii\"/><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\"/><DataArray "
       "type=\"UInt8\" "
       "Name=\"types\" format=\"ascii\"/></Cells><PointData Mood=\"a&#27;&#10;b\"><DataArray "
       "type=\"Float64\" "
       "Name=\"red&#27;[31m&#10;\" "
       "format=\"ascii\">5</DataArray></PointData></Piece></UnstructuredGrid></VTKFile>"},
      {"c.xyz", bad},
  };
  const auto is_plain = [](const std::string& text) {
    for (const char* control : {"\x1b", "\x7f", "\xC2\x9B", "\xE2\x80\xA8", "\x07"})
      if (text.find(control) != text.npos) return false;
    return true;
  };
  for (const auto& [name, text] : texts) {
    const ScratchFolder folder;
    folder.write(name, text);
    const auto run = [&](std::vector<std::string> words) {
      words.insert(words.begin(), {program("tetproof-convert"), name});
      const Outcome outcome = run_program(words, {.directory = folder / ""});
      EXPECT_TRUE(is_plain(outcome.out)) << name << ": " << outcome;
      EXPECT_TRUE(is_plain(outcome.err)) << name << ": " << outcome;
      std::istringstream lines(outcome.err);
      for (std::string line; std::getline(lines, line);)
        EXPECT_TRUE(line.starts_with("lost: ") || line.starts_with("kept in ") ||
                    line.starts_with("warning: ") || line.starts_with("not read: ") ||
                    line.starts_with("tetproof-convert: "))
            << name << ": " << line;
      return outcome;
    };
    if (run({"--info", "--json", "i.json"}).exit_code == 2) continue;
    EXPECT_EQ(name[0], 'a') << name;
    EXPECT_TRUE(is_plain(folder.read("i.json"))) << name;
    for (const char* out :
         {"o.msh", "o.node", "o.poly", "o.vtu", "o.vtk", "o.mesh", "o.stl", "o.off", "o.obj", "o.ply"}) {
      const Outcome outcome = run({out, "--losses", "l.json", "--json", "-"});
      EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 2) << name << " " << out << ": " << outcome;
      if (outcome.exit_code == 0) {
        EXPECT_TRUE(is_plain(folder.read("l.json"))) << name << " " << out;
      }
    }
  }
}

}  // namespace
}  // namespace tetproof::test
