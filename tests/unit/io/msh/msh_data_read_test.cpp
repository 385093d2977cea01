// SPDX-License-Identifier: GPL-3.0-or-later
// Reads periodic links, ghosts, data of views, and elements in several groups, in every version of .msh, from
// text written by hand. Errors name the place.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/msh/msh_data_texts.hpp"

namespace tetproof {
namespace {

using test::affine;
using test::data;
using test::mesh22;
using test::mesh40;
using test::mesh41;

const std::string data_text =
    "v nodes heat flow 3 view 0.1 2 0 [] at 20 30: 1 2 -0 4 5e-324 6\n"
    "v nodes T 1 view -1.5 0 2 [scheme] at 40 10 ?99: nan inf -1\n"
    "v elements of no view 1: 0.25 0.75\n"
    "v elements' nodes jump 2 view 0 0 0 [] at 6 ?77 of 3 1: 1 2 3 4 5 6 7 8\n";

struct ReadCase {
  std::string name, file, expected;  // the document's text behind its last element
  std::vector<std::string> warnings = {};

  friend void PrintTo(const ReadCase& test, std::ostream* out) { *out << test.name; }
};

const std::vector<ReadCase> read_cases{
    {"PeriodicOf22",
     mesh22 + "$Periodic\n2\n2 2 1\nAffine " + affine + "\n2\n10 20\n30 98\n1 -3 4\n0\n$EndPeriodic\n",
     "periodic 2/2 1 (" + affine + "): 10-20 30-?98\nperiodic 1/-3 4 ():\n"},
    {"PeriodicOf40",
     mesh40 + "$Periodic\n2\n2 2 1\nAffine\t" + affine + "\n1\n10 20\n0 3 4\n1\n40 10\n$EndPeriodic\n",
     "periodic 2/2 1 (" + affine + "): 10-20\nperiodic 0/3 4 (): 40-10\n"},
    {"PeriodicOf41",
     mesh41 + "$Periodic\n3\n2 2 1\n16 " + affine +
         "\n1\n10 20\n0 3 4\n0\n1\n40 10\n0 3 4\n2 1 2\n0\n$EndPeriodic\n",
     "periodic 2/2 1 (" + affine + "): 10-20\nperiodic 0/3 4 (): 40-10\nperiodic 0/3 4 (1 2):\n",
     {"a.msh: an affine transformation has not 16 numbers (the first: that of entity 3 of dimension 0, which "
      "has 2)"}},
    {"GhostsOf40", mesh40 + "$GhostElements\n2\n6 1 2 3 4\n99 2 0\n$EndGhostElements\n",
     "ghost element 6 1: 3 4\nghost element ?99 2: \n"},
    {"GhostsOf41", mesh41 + "$GhostElements\n1\n5 1 1 2\n$EndGhostElements\n", "ghost element 5 1: 2\n"},
    {"DataOf22", mesh22 + data, data_text},
    {"DataOf40", mesh40 + data, data_text},
    {"DataOf41", mesh41 + data, data_text},
    {"DataInFrontOfTheMesh",
     mesh41.substr(0, 35) + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n2\n10 1\n7 2\n$EndNodeData\n" +
         mesh41.substr(35),
     "v nodes T 1 view 0 0 0 [] at 10 ?7: 1 2\n"},
    {"DataOfNothing", mesh41 + "$NodeData\n1\n\"\"\n1\n0\n3\n0\n1\n0\n$EndNodeData\n",
     "v nodes  1 view 0 0 0 [] at: \n"},
    {"DataOfCopies",  // Gmsh names an element by the last of its numbers
     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n"
     "$Elements\n3\n1 15 2 7 1 1\n2 15 2 8 1 1\n3 15 2 8 2 1\n$EndElements\n"
     "$ElementData\n1\n\"a\"\n1\n0\n3\n0\n1\n2\n2 20\n3 30\n$EndElementData\n",
     "v elements a 1 view 0 0 0 [] at 1 3: 20 30\n",
     {"a.msh: 1 element repeats another one in a further physical group and is merged with it; the first is "
      "element 2, which repeats element 1"}},
    {"UnusualTagsAreKeptAsTheyStand",
     mesh41 +
         "$NodeData\n0\n1\n0\n3\n0\n1\n0\n$EndNodeData\n$NodeData\n1\nT\n1\n0\n3\n0\n1\n0\n$EndNodeData\n"
         "$ElementData\n1\n\"T\"\n2\n0\n1\n3\n0\n1\n0\n$EndElementData\n"
         "$ElementData\n1\n\"T\"\n1\n0\n5\n0\n1\n0\n1\n9\n$EndElementData\n",
     "S NodeData [0\n1\n0\n3\n0\n1\n0\n]\nS NodeData [1\nT\n1\n0\n3\n0\n1\n0\n]\n"
     "S ElementData [1\n\"T\"\n2\n0\n1\n3\n0\n1\n0\n]\nS ElementData [1\n\"T\"\n1\n0\n5\n0\n1\n0\n1\n9\n]\n"},
    {"AMisspeltEnd",
     mesh41 + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n1\n10 1\n$EndNodeDate\n",
     "v nodes T 1 view 0 0 0 [] at 10: 1\n",
     {"a.msh:39: section $NodeData ends with $EndNodeDate"}},
    {"TextOfAnotherSize",
     "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n" + mesh22.substr(35),
     "",
     {"a.msh:2: the size of numbers is 4 and not 8, which means nothing in text"}},
    {"ANodeTwiceInAnElement",
     mesh22.substr(0, mesh22.find("6 2 2 8")) + "6 2 2 8 2 10 10 30\n$EndElements\n",
     "",
     {"a.msh: 1 element names the same node twice; the first is element 6"}},
};

class MeshData : public testing::TestWithParam<ReadCase> {};

TEST_P(MeshData, IsRead) {
  const test::TestFiles files;
  const std::string path = files.write("a.msh", GetParam().file);
  const Document document = read_document(path);
  const std::string text = test::text_of(document);
  const std::size_t last = text.find('\n', text.rfind("\ne ") + 1);
  EXPECT_EQ(text.substr(last + 1), GetParam().expected);
  std::vector<std::string> warnings = document.warnings;
  for (std::string& warning : warnings)
    for (std::size_t at; (at = warning.find(files.path(""))) != warning.npos;)
      warning.erase(at, files.path("").size());
  EXPECT_EQ(warnings, GetParam().warnings);
}

INSTANTIATE_TEST_SUITE_P(ByHand, MeshData, testing::ValuesIn(read_cases),
                         [](const auto& test) { return test.param.name; });

TEST(MeshDataRead, PolygonsHaveTheirNumberOfNodesInFrontOfThem) {  // in 2.2, as in Gmsh
  const test::TestFiles files;
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 2 1 0\n4 1 2 0\n5 0 1 "
      "0\n$EndNodes\n"
      "$Elements\n2\n1 34 2 7 1 5 1 2 3 4 5\n2 34 2 7 1 4 1 2 3 4\n$EndElements\n";
  const Document document = read_document(files.write("a.msh", text));
  ASSERT_EQ(document.blocks.size(), 2u);
  EXPECT_EQ(document.blocks[0].nodes_each, 5);
  EXPECT_EQ(document.connectivity, (std::vector<Index>{0, 1, 2, 3, 4, 0, 1, 2, 3}));
  write_document(files.path("b.msh"), document, {.format = "msh22"});
  EXPECT_EQ(test::TestFiles::read(files.path("b.msh")), text);
}

// meshio writes the references of Medit's elements as data. Other words may be anybody's data.
TEST(MshData, GroupsOfMeshio) {
  const test::TestFiles files;
  const std::string mesh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
      "$Elements\n2\n1 2 2 0 0 1 2 3\n2 2 2 0 0 3 2 1\n$EndElements\n$ElementData\n1\n\"";
  const std::string rest = "\"\n1\n0\n3\n0\n1\n2\n1 3\n2 0\n$EndElementData\n";
  for (const auto& [word, group, values] :
       {std::tuple("medit:ref", true, 0u), {"tetgen:ref", true, 0u}, {"material", false, 1u}}) {
    const Document document = read_document(files.write("a.msh", mesh + word + rest));
    EXPECT_EQ(document.element_values.size(), values) << word;
    const auto& groups = document.tag_sets[static_cast<std::size_t>(document.blocks[0].groups)];
    EXPECT_EQ(groups, group ? std::vector<std::int64_t>{3} : std::vector<std::int64_t>{}) << word;
  }
  // Not where elements have groups, or the numbers are none.
  std::string other = mesh + "medit:ref" + rest;
  other.replace(other.find("\n1 3\n"), 5, "\n1 -3\n");
  const Document document = read_document(files.write("a.msh", other));
  ASSERT_EQ(document.element_values.size(), 1u);
  EXPECT_TRUE(document.element_values[0].of_view);
}

struct ErrorCase {
  std::string name, file, message;

  friend void PrintTo(const ErrorCase& test, std::ostream* out) { *out << test.name; }
};

// mesh41 has 28 lines and mesh22 has 15.
const std::vector<ErrorCase> error_cases{
    {"PeriodicDimension", mesh41 + "$Periodic\n1\n4 1 2\n0\n0\n$EndPeriodic\n",
     "a.msh:31: expected the dimension of a periodic entity, 0 to 3, found 4"},
    {"PeriodicCount", mesh41 + "$Periodic\n99\n2 2 1\n0\n0\n$EndPeriodic\n",
     "a.msh:30: expected the number of periodic entities, found 99, more than the 24 bytes left can hold"},
    {"PeriodicNode", mesh41 + "$Periodic\n1\n2 2 1\n0\n1\n10 x\n$EndPeriodic\n",
     "a.msh:34: expected the tag of the node that it follows, found 'x'"},
    {"PeriodicEnd", mesh41 + "$Periodic\n0 0\n$EndPeriodic\n", "a.msh:30: expected $EndPeriodic, found '0'"},
    {"AffineValue", mesh22 + "$Periodic\n1\n2 2 1\nAffine 1 0 y\n0\n$EndPeriodic\n",
     "a.msh:19: expected a value of an affine transformation, found 'y'"},
    {"GhostCount", mesh41 + "$GhostElements\n1\n5 1 20 1\n$EndGhostElements\n",
     "a.msh:31: expected the number of partitions that see a ghost element, found 20, more than the 21 bytes "
     "left can hold"},
    {"Components", mesh41 + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n0\n1\n10\n$EndNodeData\n",
     "a.msh:37: expected the number of components of the data, found 0"},
    {"Rows", mesh41 + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n123456\n10 1\n$EndNodeData\n",
     "a.msh:38: expected the number of nodes or elements that have data, found 123456, more than the 18 "
     "bytes "
     "left can hold"},
    {"FewerRows", mesh41 + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n2\n10 1\n$EndNodeData\n",
     "a.msh:39: expected the tag of a node, found '$EndNodeData'"},
    {"LongerRows", mesh41 + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n1\n10 1 20\n$EndNodeData\n",
     "a.msh:38: expected $EndNodeData, found '20'"},
    {"NodesOfAnElement",
     mesh41 + "$ElementNodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n1\n5 99 1\n$EndElementNodeData\n",
     "a.msh:38: expected the number of an element's nodes, found 99, more than the 23 bytes left can hold"},
};

class MeshDataErrors : public testing::TestWithParam<ErrorCase> {};

TEST_P(MeshDataErrors, HaveOneLineWithThePlace) {
  const test::TestFiles files;
  files.write("a.msh", GetParam().file);
  EXPECT_EQ(files.message([&] { read_document(files.path("a.msh")); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(ByHand, MeshDataErrors, testing::ValuesIn(error_cases),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof
