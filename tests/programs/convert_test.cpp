// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-convert as a script uses it: exit codes, losses, --strict, --info.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/programs/two_groups.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

TEST(Convert, SaysWhatIsLostAndConverts) {
  const ScratchFolder folder;
  const std::string in = folder.write("a.msh", two_groups);
  const Outcome run = run_program(
      {program("tetproof-convert"), in, folder / "b.vtu", "--losses", folder / "lost.json", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err, "lost: numbers of nodes: 4 (the first is 10)\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.msh", "b.vtu", "lost.json"}));
  const auto lost = nlohmann::json::parse(folder.read("lost.json")), all = nlohmann::json::parse(run.out);
  ASSERT_EQ(lost["losses"].size(), 1u);
  EXPECT_EQ(lost["losses"][0],
            (nlohmann::json{{"item", "numbers of nodes"}, {"count", 4}, {"example", "the first is 10"}}));
  EXPECT_EQ(all["losses"], lost["losses"]);
  EXPECT_EQ(all["kept_aside"].size(), 0u);
  EXPECT_EQ(all["output"]["format"], "vtu");
  EXPECT_EQ(all["input"]["nodes"]["largest"], 40);
}

TEST(Convert, SaysWhatIsKeptAsideAndTakesItBack) {
  const ScratchFolder folder;
  const std::string in = folder.write("a.msh", two_groups);
  const Outcome run = run_program(
      {program("tetproof-convert"), in, folder / "b.ele", "--losses", folder / "lost.json", "--strict"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.err,
            "kept in comments: numbers of nodes: 4 (the first is 10)\n"
            "kept in comments: physical groups beyond an element's first: 1 (element 1 in groups 7 8)\n"
            "kept in comments: names of physical groups: 1 (steel)\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.msh", "b.ele", "b.node", "lost.json"}));
  EXPECT_EQ(folder.read("b.ele"), "1 4 1\n1 1 2 3 4 7\n");
  const auto lost = nlohmann::json::parse(folder.read("lost.json"));
  EXPECT_EQ(lost["losses"].size(), 0u);
  EXPECT_EQ(lost["kept_aside"].size(), 3u);
  ASSERT_EQ(run_program({program("tetproof-convert"), folder / "b.node", folder / "c.msh"}).exit_code, 0);
  EXPECT_EQ(folder.read("c.msh"), two_groups);
}

TEST(Convert, StrictWithALossWritesNothing) {
  const ScratchFolder folder;
  const std::string in = folder.write("a.msh", two_groups);
  const Outcome run = run_program({program("tetproof-convert"), in, folder / "b.mesh", "--strict"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_GE(lines(run.err), 2u) << run;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.msh"});
}

TEST(Convert, StrictWithoutALossConverts) {
  const ScratchFolder folder;
  const std::string in = folder.write("a.msh", two_groups);
  EXPECT_EQ(
      run_program({program("tetproof-convert"), in, folder / "b.msh", "--binary", "--strict"}).exit_code, 0);
  EXPECT_EQ(
      run_program({program("tetproof-convert"), folder / "b.msh", folder / "c.msh", "--strict"}).exit_code,
      0);
  const std::string again = folder.read("c.msh");
  EXPECT_EQ(again.substr(again.find("$Nodes")),
            std::string(two_groups).substr(std::string(two_groups).find("$Nodes")));
}

TEST(Convert, UsageAndInput) {
  const ScratchFolder folder;
  const std::string in = folder.write("a.msh", two_groups),
                    bad = folder.write("bad.msh", "$MeshFormat\n4.1 0\n");
  const auto said = [&](std::vector<std::string> words) {
    words.insert(words.begin(), program("tetproof-convert"));
    const Outcome run = run_program(words, {.directory = folder / ""});
    EXPECT_EQ(run.exit_code, 2) << run;
    EXPECT_EQ(lines(run.err), 1u) << run;
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_EQ(said({"a.msh"}), "tetproof-convert: OUT is missing (or ask for --info)\n");
  EXPECT_EQ(said({"a.msh", "b.msh", "--info"}), "tetproof-convert: --info writes no file: leave out OUT\n");
  EXPECT_EQ(said({"a.msh", "b.xyz"}),
            "tetproof-convert: b.xyz: unknown ending, expected one of .msh .node .ele .face .edge .neigh "
            ".vol .mtr .var .t2f .t2e .f2e .cell .poly .smesh .vtu .vtk .mesh .meshb .stl .off .obj .ply\n");
  EXPECT_EQ(said({"a.msh", "b.node", "--binary"}),
            "tetproof-convert: b.node: TetGen .node and .ele is never binary\n");
  EXPECT_EQ(said({"a.msh", "b.msh", "--to", "nas"}),
            "tetproof-convert: unknown format 'nas', expected one of msh41 msh40 msh22 tetgen poly smesh vtu "
            "vtk medit stl off obj ply\n");
  EXPECT_EQ(
      said({"bad.msh", "b.msh"}),
      "tetproof-convert: bad.msh:3: expected the size of a number in bytes, found the end of the file\n");
  folder.write("lie.mesh", "$MeshFormat\n4.1 0\n");
  EXPECT_EQ(said({"lie.mesh", "b.msh"}),
            "tetproof-convert: lie.mesh:3: expected the size of a number in bytes, found the end of the file "
            "(read as a Gmsh .msh 4.1 file because of its content, though its name ends in .mesh)\n");
  EXPECT_EQ(said({"none.msh", "b.msh"}),
            "tetproof-convert: none.msh: cannot open: No such file or directory\n");
  folder.write("c.xyz", "hello\n");
  const std::string unknown = said({"c.xyz", "b.msh"});
  EXPECT_EQ(
      unknown.substr(0, unknown.find("; through Gmsh .")),
      "tetproof-convert: c.xyz: unknown ending, and the content tells no format; expected one of .msh .node "
      ".ele .face .edge .neigh .vol .mtr .var .t2f .t2e .f2e .cell .poly .smesh .vtu .vtk .mesh .meshb .stl "
      ".off .obj .ply");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.msh", "bad.msh", "c.xyz", "lie.mesh"}));
}

TEST(Convert, HelpNamesEveryEndingThatIsRead) {
  const Outcome run = run_program({program("tetproof-convert"), "--help"});
  EXPECT_EQ(run.exit_code, 0) << run;
  for (const char* ending : {".msh ", ".node ", ".edge ", ".cell ", ".vtu ", ".vtk ", ".meshb ", ".ply ",
                             ".vtp ", ".vti ", ".vtr ", ".vts; ", ".sol ", ".step"})
    EXPECT_NE(run.out.find(ending), std::string::npos) << ending << run;
}

// Nodes without a value are written as nan, which VTK's own reader of text does not accept.
TEST(Convert, WarnsOfTextThatVtkMisreads) {
  const ScratchFolder folder;
  const std::string in = folder.write(
      "a.msh", std::string(two_groups) + "$NodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n1\n20 7\n$EndNodeData\n");
  const auto said = [&](const char* name, const char* form) {
    return run_program({program("tetproof-convert"), in, name, form}, {.directory = folder / ""}).err;
  };
  EXPECT_NE(
      said("b.vtk", "--ascii")
          .find(
              "warning: b.vtk: point data \"u\" has nan or inf, which VTK itself reads in binary, but not in "
              "text, where it misreads all that follows\n"),
      std::string::npos);
  EXPECT_EQ(said("b.vtk", "--binary").find("warning"), std::string::npos);
  EXPECT_EQ(said("b.vtu", "--ascii").find("warning"), std::string::npos);
}

TEST(Convert, Info) {
  const ScratchFolder folder;
  const Outcome run = run_program({program("tetproof-convert"), "--info", folder.write("a.msh", two_groups)},
                                  {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_NE(run.out.find("a.msh: msh41\n"
                         "         4 nodes, numbered 10 to 40\n"
                         "           in (0, 0, 0) to (1, 1, 1)\n"
                         "         1 element, numbered 1 to 1\n"
                         "         1 of them tetrahedron of 4 nodes (Gmsh's type 4)\n"
                         "         1 entity of dimension 3\n"
                         "         1 element in group 7 of dimension 3 \"steel\"\n"
                         "         1 element in group 8 of dimension 3\n"),
            std::string::npos)
      << run;
}

TEST(Convert, TheSameBytesForAnyNumberOfThreads) {
  const ScratchFolder folder;
  std::string nodes = "60000 3\n", elements = "60000 4\n";
  for (int i = 0; i < 60000; ++i) {
    nodes += std::to_string(i) + " " + std::to_string(i % 7) + ".1 0." + std::to_string(i) + " 3e-5\n";
    elements += std::to_string(i) + " " + std::to_string(i) + " 1 2 3\n";
  }
  folder.write("in.node", nodes);
  folder.write("in.ele", elements);
  for (const std::vector<std::string>& target : std::vector<std::vector<std::string>>{
           {"out.msh"}, {"out.msh", "--binary"}, {"out.msh", "--to", "msh22"}, {"out.vtu"}, {"out.ele"}}) {
    std::vector<std::string> bytes;
    for (const char* threads : {"1", "2", "7"}) {
      std::vector<std::string> command{program("tetproof-convert"), "in.node", "--threads", threads};
      command.insert(command.end(), target.begin(), target.end());
      ASSERT_EQ(run_program(command, {.directory = folder / ""}).exit_code, 0);
      bytes.push_back(folder.read(target[0]));
    }
    EXPECT_GT(bytes[0].size(), std::size_t{1} << 20) << target.back();  // enough for several threads
    EXPECT_TRUE(bytes[0] == bytes[1] && bytes[0] == bytes[2]) << target.back();
  }
}

}  // namespace
}  // namespace tetproof::test
