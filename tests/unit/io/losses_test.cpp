// SPDX-License-Identifier: GPL-3.0-or-later
// The losses that are listed for each format, compared with lists written by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/rich_document.hpp"

namespace tetproof {
namespace {

using test::one_tet;
using test::rich_document;

struct LossCase {
  std::string name, file;
  WriteOptions options;
  std::vector<std::string> expected;

  friend void PrintTo(const LossCase& test, std::ostream* out) { *out << test.name; }
};

const std::vector<LossCase> loss_cases{
    {"Msh41", "a.msh", WriteOptions(), {"that values of nodes are integers, not reals: 1 (\"markers\")"}},
    {"Msh41Binary",
     "a.msh",
     {.binary = true},
     {"that values of nodes are integers, not reals: 1 (\"markers\")", "section $Periodic: 1 (2 bytes)"}},
    {"Msh22",
     "a.msh",
     {.format = "msh22"},
     {"entities with their boxes and boundaries: 1 (5 of dimension 3)",
      "that values of nodes are integers, not reals: 1 (\"markers\")", "section $Periodic: 1 (2 bytes)"}},
    {"Tetgen",
     "a.node",
     WriteOptions(),
     {"nodes between the corners of tetrahedra of 10 nodes (type 11): 1 (element 5)",
      "numbers of nodes: 10 (the first is 10)", "numbers of elements: 3 (the first is 5)",
      "entities of elements: 3 (element 5 in entity 5)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 2 (6 of dimension 2)",
      "physical groups beyond an element's first: 1 (element 9 in groups 7 8)",
      "names of physical groups: 1 (skin)", "nodes with parametric coordinates: 3 (node 10)",
      "values \"attributes\" of elements: 3 (2.25)",  // groups stand in the column
      "section $Periodic: 1 (2 bytes)", "section $Mine: 1 (2 bytes)"}},
    {"Vtu",
     "a.vtu",
     WriteOptions(),
     {"elements that name nodes which do not exist: 1 (element 3 names node 999)",
      "numbers of nodes: 10 (the first is 10)", "numbers of elements: 2 (the first is 5)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 1 (5 of dimension 3)",
      "nodes with parametric coordinates: 3 (node 10)", "section $Periodic: 1 (2 bytes)",
      "section $Mine: 1 (2 bytes)"}},
    {"Stl",
     "a.stl",
     WriteOptions(),
     {"tetrahedra of 10 nodes (type 11): 1 (element 5)", "tetrahedra of 4 nodes (type 4): 1 (element 3)",
      "nodes of no element that is written: 7 (node 40)", "numbers of nodes: 3 (the first is 10)",
      "numbers of elements: 1 (the first is 9)",
      "coordinates rounded to 32 bits: 1 (0.1 becomes 0.10000000149011612)",
      "entities of elements: 1 (element 9 in entity 6)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 2 (6 of dimension 2)",
      "physical groups of elements: 1 (element 9 in groups 7 8)", "names of physical groups: 1 (skin)",
      "nodes with parametric coordinates: 3 (node 10)", "values \"markers\" of nodes: 10 (1)",
      "values \"attributes\" of elements: 3 (2.25)", "section $Periodic: 1 (2 bytes)",
      "section $Mine: 1 (2 bytes)"}},
};

// The items that the format does not hold. They are either lost or kept aside.
std::vector<Loss> unheld(const std::string& path, const Document& document, const WriteOptions& options) {
  const std::vector<Loss> lost = losses(path, document, options);
  const std::vector<Loss> kept = kept_aside(path, document, options).items;
  EXPECT_TRUE(lost.empty() || kept.empty());
  return lost.empty() ? kept : lost;
}

class Losses : public testing::TestWithParam<LossCase> {};

TEST_P(Losses, AreListed) {
  std::vector<std::string> listed;
  for (const Loss& loss : unheld(GetParam().file, rich_document(), GetParam().options))
    listed.push_back(fmt::format("{}: {} ({})", loss.item, loss.count, loss.example));
  EXPECT_EQ(listed, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(OfARichDocument, Losses, testing::ValuesIn(loss_cases),
                         [](const auto& test) { return test.param.name; });

TEST(WriteWarning, OfGroupsThatGmshTakesForOthers) {
  const test::TestFiles files;
  Document document = document_of(one_tet);
  document.tag_sets = {{}, {2147483648}};
  document.blocks[0].groups = 1;
  for (const char* format : {"msh22", "msh41"})
    EXPECT_EQ(
        write_warning("a.msh", document, {.format = format}),
        "a.msh: Gmsh takes physical groups beyond 32 bits for others: 1 element, the first in 2147483648")
        << format;
  document.tag_sets[1] = {2147483647};
  EXPECT_EQ(write_warning("a.msh", document), "");
  // Of Medit's references, say. Gmsh's own signs say that elements are turned.
  document.tag_sets[1] = {2147483648, -20};
  EXPECT_EQ(
      write_warning("a.msh", document),
      "a.msh: Gmsh takes physical groups beyond 32 bits for others: 1 element, the first in 2147483648, "
      "and those below 0 for those above 0: 1 element, the first in -20");
  document.tag_sets[1] = {-20};
  EXPECT_EQ(write_warning("a.msh", document),
            "a.msh: Gmsh takes physical groups below 0 for those above 0: 1 element, the first in -20");
  document.format = "msh22";
  EXPECT_EQ(write_warning("a.msh", document), "");
}

// Gmsh's `Physical Surface(5) = {-1, 2}`: the elements of surface 1 are turned, and in group 5.
TEST(Losses, OfGmshsReversedGroupsOnlyTheSign) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.msh",
                  "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 5 \"wall\"\n$EndPhysicalNames\n"
                  "$Entities\n0 0 2 0\n1 0 0 0 1 1 0 1 -5 0\n2 0 0 0 1 1 0 1 5 0\n$EndEntities\n"
                  "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
                  "$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n2 2 2 1\n2 1 3 4\n$EndElements\n"));
  for (const char* to : {"b.mesh", "b.vtu", "b.vtk"}) {
    std::vector<std::string> lost;
    for (const Loss& loss : losses(files.path(to), document))
      if (loss.item == "signs of physical groups")
        lost.push_back(fmt::format("{} {}", loss.count, loss.example));
    EXPECT_EQ(lost, std::vector<std::string>{"1 element 1 in group -5"}) << to;
    write_document(files.path(to), document);
    const Document back = read_document(files.path(to));
    for (const ElementBlock& block : back.blocks)
      EXPECT_EQ(back.tag_sets.at(static_cast<std::size_t>(block.groups)), std::vector<std::int64_t>{5}) << to;
    EXPECT_EQ(back.elements(), 2U) << to;
  }
  // TetGen gets the group, and a comment keeps the sign.
  write_document(files.path("b.face"), document);
  std::string faces = files.read(files.path("b.face"));
  EXPECT_EQ(faces.substr(0, faces.find('#')), "2 1\n1 1 2 3 5\n2 1 3 4 5\n");
  EXPECT_TRUE(losses(files.path("b.face"), document).empty());
  const Document tetgen = read_document(files.path("b.face"));
  EXPECT_EQ(tetgen.tag_sets.at(static_cast<std::size_t>(tetgen.blocks.at(0).groups)),
            std::vector<std::int64_t>{-5});
  for (const char* format : {"msh41", "msh22"}) {
    const WriteOptions options{.format = format};
    EXPECT_TRUE(losses(files.path("c.msh"), document, options).empty()) << format;
    write_document(files.path("c.msh"), document, options);
    const Document back = read_document(files.path("c.msh"));
    EXPECT_EQ(back.tag_sets.at(static_cast<std::size_t>(back.blocks.at(0).groups)),
              std::vector<std::int64_t>{-5});
  }
}

TEST(Losses, NoneForAPlainMesh) {
  for (const char* file : {"a.msh", "a.node", "a.vtu"})
    EXPECT_TRUE(losses(file, document_of(one_tet)).empty()) << file;
  EXPECT_TRUE(losses("a.msh", document_of(one_tet), {.format = "msh22"}).empty());
  const TriangleSurface triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
  for (const char* file : {"a.msh", "a.vtu", "a.stl", "a.off", "a.obj", "a.ply"})
    EXPECT_TRUE(losses(file, document_of(triangle)).empty()) << file;
}

// A view of Gmsh with two time steps, and a view of one element only.
TEST(Losses, OfValuesWhoseNumbersAreThere) {
  const test::TestFiles files;
  const std::string data = "1\n\"heat\"\n1\n", two = "3\n0\n1\n2\n8 0.5\n9 1.5\n$EndNodeData\n";
  const Document document = read_document(
      files.write("a.msh",
                  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n8 0 0 0\n9 1 0 0\n$EndNodes\n"
                  "$Elements\n2\n3 1 2 0 1 8 9\n4 1 2 0 1 9 8\n$EndElements\n"
                  "$NodeData\n" +
                      data + "0\n" + two + "$NodeData\n" + data + "2.5\n" + two +
                      "$ElementData\n1\n\"\"\n1\n0\n3\n7\n1\n1\n3 6\n$EndElementData\n"));
  const auto listed = [&](const std::string& file) {
    std::vector<std::string> items;
    for (const Loss& loss : losses(file, document))
      if (!loss.item.starts_with("numbers"))
        items.push_back(fmt::format("{}: {} ({})", loss.item, loss.count, loss.example));
    return items;
  };
  const std::vector<std::string> expected{
      "names of values of nodes: 1 (\"heat\" becomes \"heat #2\")",
      "times and steps of values of nodes: 1 (\"heat\" of time 2.5, step 0)",
      "names of values of elements: 1 (\"\" becomes \"values\")",
      "gaps in values of elements: 1 (element 4 has no \"\")",
      "times and steps of values of elements: 1 (\"\" of time 0, step 7)"};
  EXPECT_EQ(listed("a.vtu"), expected);
  EXPECT_EQ(listed("a.vtk"), expected);
  write_document(files.path("a.vtu"), document);
  const Document back = read_document(files.path("a.vtu"));
  ASSERT_EQ(back.node_values.size(), 2u);
  EXPECT_EQ(back.node_values[1].name, "heat #2");
  EXPECT_EQ(back.node_values[1].reals, (std::vector{0.5, 1.5}));
  ASSERT_EQ(back.element_values.size(), 1u);
  ASSERT_EQ(back.element_values[0].reals.size(), 2u);
  EXPECT_EQ(back.element_values[0].reals[0], 6);
  EXPECT_TRUE(std::isnan(back.element_values[0].reals[1]));
}

// In 4.1 an element has the groups and partitions of its entity, so an entity with elements of two groups
// becomes two entities.
TEST(Losses, AnEntityInTwoGroups) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n3\n1 4 2 7 5 1 2 3 4\n2 4 2 8 5 1 2 4 3\n3 4 4 7 5 1 2 1 3 2 4\n$EndElements\n"));
  EXPECT_TRUE(losses("b.msh", document).empty());
  const std::vector<Loss> kept = kept_aside("b.msh", document).items;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].item + ": " + kept[0].example,
            "numbers of entities: element 2 in entity 5 comes into entity 6");
  write_document(files.path("b.msh"), document);
  EXPECT_EQ(test::text_of(read_document(files.path("b.msh"))).substr(5), test::text_of(document).substr(5));
  test::TestFiles::leave_out_supplement(files.path("b.msh"));
  EXPECT_EQ(test::text_of(read_document(files.path("b.msh"))),
            "msh41\nE 3/5 0 0 0 1 1 1 g7 b\nE 3/6 0 0 0 1 1 1 g8 b\nE 3/7 0 0 0 1 1 1 g7 b (3/5 p2)\n"
            "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\nN 3/5 4: \n"
            "e 1 4 3/5 g7 p: 1 2 3 4\ne 2 4 3/6 g8 p: 1 2 4 3\ne 3 4 3/7 g7 p2: 1 3 2 4\n");
}

}  // namespace
}  // namespace tetproof
