// SPDX-License-Identifier: GPL-3.0-or-later
// .msh files that Gmsh reads although something is missing or wrong in them, and ghosts of 2.2, which 4.1 has
// in a section of its own.
#include <gtest/gtest.h>

#include <ctime>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const std::string v20 = "$MeshFormat\n2 0 8\n$EndMeshFormat\n",
                  v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
                  v40 = "$MeshFormat\n4 0 8\n$EndMeshFormat\n",
                  v41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
                  nodes22 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string four_points = "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\n";

struct Read {
  Document document;
  std::vector<std::string> warnings;
};
Read read(const std::string& bytes) {
  const test::TestFiles files;
  Read read{read_document(files.write("a.msh", bytes)), {}};
  for (const std::string& warning : read.document.warnings)
    read.warnings.push_back(warning.substr(files.path("").size()));
  return read;
}
using Lines = std::vector<std::string>;

TEST(MshIrregular, NamesWithoutDimensions) {
  const Read got = read(v20 +
                        "$PhysicalNames\n4\n1 \"steel\"\n2 \"air gap\"\n2 3 \"with one\"\n9 \"empty\"\n"
                        "$EndPhysicalNames\n" +
                        nodes22 +
                        "$Elements\n3\n1 4 3 1 1 0 1 2 3 4\n2 2 3 2 2 0 1 2 3\n3 1 3 1 2 0 1 2\n"
                        "$EndElements\n");
  std::string names;
  for (const GroupName& name : got.document.group_names)
    names += fmt::format("{} {} {}\n", name.dim, name.group, name.name);
  // Group 1 has elements of two dimensions; group 9 has none.
  EXPECT_EQ(names, "1 1 steel\n3 1 steel\n2 2 air gap\n2 3 with one\n3 9 empty\n");
  EXPECT_EQ(
      got.warnings,
      (Lines{"a.msh:6: 3 names of physical groups have no dimension, as in version 2.0; it is that of the "
             "elements in the group"}));
}

TEST(MshIrregular, NoNodesOrElements) {
  const Read none = read(v41 + "$Entities\n1 0 0 0\n1 0 0 0 0\n$EndEntities\n");
  EXPECT_EQ(none.document.entities.size(), 1u);
  EXPECT_EQ(none.document.points.size(), 0u);
  EXPECT_EQ(none.warnings,
            (Lines{"a.msh: there is no section $Nodes", "a.msh: there is no section $Elements"}));
  const Read nodes = read(v22 + nodes22);
  EXPECT_EQ(test::text_of(nodes.document, false), four_points);
  EXPECT_EQ(nodes.warnings, (Lines{"a.msh: there is no section $Elements"}));
  EXPECT_EQ(read(v22).warnings.size(), 2u);
}

std::string dropped_in(const Document& document) {
  std::string text;
  for (const Loss& loss : document.dropped)
    text +=
        fmt::format("{} {} ({}){}\n", loss.count, loss.item, loss.example, loss.elements ? " elements" : "");
  return text;
}
std::string refused(const std::string& bytes) {
  const test::TestFiles files;
  return files.message([&] { read_document(files.write("a.msh", bytes)); });
}

// The blocks have counts of their own, by which Gmsh goes, and by their number.
const std::string node_blocks = "0 1 0 2\n1\n2\n0 0 0\n1 0 0\n0 2 0 2\n3\n4\n0 1 0\n0 0 1\n$EndNodes\n",
                  element_blocks = "3 1 4 1\n1 1 2 3 4\n1 1 1 2\n2 1 2\n3 2 3\n$EndElements\n";
std::string blocks41(const std::string& nodes, const std::string& elements) {
  return v41 + "$Nodes\n" + nodes + "\n" + node_blocks + "$Elements\n" + elements + "\n" + element_blocks;
}
const std::string all_blocks =
    four_points + "N 0/1 2: \nN 0/2 2: \ne 1 4 3/1 g p: 1 2 3 4\ne 2 1 1/1 g p: 1 2\ne 3 1 1/1 g p: 2 3\n";

TEST(MshIrregular, WrongTotals) {
  for (const auto& [nodes, elements, warnings] :
       {std::tuple("2 4 1 4", "2 3 1 3", Lines{}),
        {"2 12 1 4", "2 18 1 18",
         Lines{"a.msh:5: 12 nodes are announced, and 4 nodes are in the 2 blocks",
               "a.msh:18: 18 elements are announced, and 3 elements are in the 2 blocks"}},
        {"2 9000000000000000000 1 4", "2 0 1 3",
         Lines{"a.msh:5: 9000000000000000000 nodes are announced, and 4 nodes are in the 2 blocks",
               "a.msh:18: 0 elements are announced, and 3 elements are in the 2 blocks"}}}) {
    const Read got = read(blocks41(nodes, elements));
    EXPECT_EQ(got.warnings, warnings) << nodes;
    EXPECT_EQ(dropped_in(got.document), "") << nodes;
    EXPECT_EQ(test::text_of(got.document, false), all_blocks) << nodes;
  }
  // 4.0 has its numbers in another order.
  const Read old = read(v40 +
                        "$Nodes\n1 9\n1 0 0 2\n1 0 0 0\n2 1 0 0\n$EndNodes\n$Elements\n1 9\n1 1 1 1\n1 1 2\n"
                        "$EndElements\n");
  EXPECT_EQ(old.warnings.size(), 2u);
  EXPECT_EQ(test::text_of(old.document, false), "n 1 0 0 0\nn 2 1 0 0\nN 0/1 2: \ne 1 1 1/1 g p: 1 2\n");
}

// Gmsh refuses them too: "Could not read elements".
TEST(MshIrregular, FewerBlocksThanAnnouncedAreRefused) {
  EXPECT_EQ(refused(blocks41("2 4 1 4", "3 3 1 3")),
            "a.msh:24: expected 3 blocks of elements, found 2 and the end of the section");
  EXPECT_EQ(refused(blocks41("7 4 1 4", "2 3 1 3")),
            "a.msh:16: expected 7 blocks of nodes, found 2 and the end of the section");
  EXPECT_EQ(refused(v40 + "$Nodes\n1 1\n1 0 0 1\n1 0 0 0\n$EndNodes\n$Elements\n1 1\n$EndElements\n"),
            "a.msh:11: expected 1 block of elements, found 0 and the end of the section");
}

// Gmsh passes over them. They may be elements, so the mesh is not whole.
TEST(MshIrregular, LinesBehindTheBlocksAreDropped) {
  const Read less = read(blocks41("2 4 1 4", "1 1 1 1"));
  EXPECT_EQ(less.warnings, Lines{});
  EXPECT_EQ(dropped_in(less.document),
            "3 lines of $Elements behind those that it announces (line 21) elements\n");
  EXPECT_EQ(test::text_of(less.document, false), all_blocks.substr(0, all_blocks.find("e 2 ")));

  const Read nodes = read(blocks41("1 2 1 2", "2 3 1 3"));
  EXPECT_EQ(dropped_in(nodes.document), "5 lines of $Nodes behind those that it announces (line 11)\n");
  EXPECT_EQ(test::text_of(nodes.document, false),
            "n 1 0 0 0\nn 2 1 0 0\nN 0/1 2: \ne 1 4 3/1 g p: 1 2 ?3 ?4\ne 2 1 1/1 g p: 1 2\ne 3 1 1/1 g p: 2 "
            "?3\n");

  // A block with fewer rows than there are: the others are no blocks.
  const Read rows = read(v41 + "$Nodes\n2 4 1 4\n" + node_blocks +
                         "$Elements\n1 3 1 3\n3 1 4 1\n1 1 2 3 4\n2 2 2 1\n3 1 2 3\n$EndElements\n");
  EXPECT_EQ(rows.document.elements(), 1u);
  EXPECT_EQ(dropped_in(rows.document),
            "2 lines of $Elements behind those that it announces (line 21) elements\n");
}

// Of the older versions too, and in every section.
TEST(MshIrregular, LinesBehindACountAreDropped) {
  const std::string text =
      v22 + nodes22 + "$Elements\n1\n1 4 2 0 1 1 2 3 4\n2 4 2 0 1 2 1 3 4\n$EndElements\n";
  const Read less =
      read(text + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n1\n1 5\n2 6\n\nand more\n$EndNodeData\n");
  EXPECT_EQ(dropped_in(less.document),
            "1 lines of $Elements behind those that it announces (line 14) elements\n"
            "2 lines of $NodeData behind those that it announces (line 26)\n");
  EXPECT_EQ(test::text_of(less.document, false).substr(four_points.size()),
            "e 1 4 3/1 g p: 1 2 3 4\nv nodes T 1 view 0 0 0 [] at 1: 5\n");
  EXPECT_EQ(refused(v22 + nodes22 + "$Elements\n2\n1 4 2 0 1 1 2 3 4\n$EndElements\n"),
            "a.msh:14: expected the tag of an element, found '$EndElements'");
  // A row that is longer than its type was not understood.
  EXPECT_EQ(refused(v22 + nodes22 + "$Elements\n1\n1 4 2 0 1 1 2 3 4 5\n$EndElements\n"),
            "a.msh:13: expected $EndElements, found '5'");
}

// Each section looked at all bytes behind the last one.
TEST(MshIrregular, ManySectionsInFrontOfManyLineEnds) {
  std::string text = v22 + nodes22;
  for (int k = 0; k < 20000; ++k) text += "$A\n$EndA\n";
  const std::clock_t start = std::clock();
  EXPECT_EQ(read(text + std::string(2000000, '\n')).document.sections.size(), 20000u);
  EXPECT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC);  // 20 seconds if quadratic
}

TEST(MshIrregular, ATextThatEndsInABlockIsRefused) {
  EXPECT_EQ(refused(v41 + "$Nodes\n1 2 1 2\n0 1 0 2\n1\n2\n0 0 0\n"),
            "a.msh:10: expected a coordinate, found the end of the file");
  EXPECT_EQ(refused(v41 + "$Nodes\n2 2 1 2\n0 1 0 1\n1\n0 0 0\n"),
            "a.msh:9: expected 2 blocks of nodes, found 1 and the end of the file");
  EXPECT_EQ(refused(v41 + "$Nodes\n1 1 1 1\n0 1 0 1\n1\n0 0 0\n7 7\n"),
            "a.msh:10: expected $EndNodes, found the end of the file");
}

// Any order of the ghosts is the same.
TEST(MshIrregular, GhostsInAnyOrderGoTo22) {
  const test::TestFiles files;
  Document document = read_document(files.write(
      "a.msh",
      v22 + nodes22 + "$Elements\n2\n1 4 5 7 1 2 1 -2 1 2 3 4\n2 4 5 7 1 2 1 -3 2 3 1 4\n$EndElements\n"));
  ASSERT_EQ(document.ghost_elements.size(), 2u);
  std::swap(document.ghost_elements[0], document.ghost_elements[1]);
  EXPECT_TRUE(kept_aside(files.path("b.msh"), document, {.format = "msh22"}).items.empty());
  // Binary files of 2.2 have no polygons, and so not their ghosts.
  document.blocks = {{.type = 34, .dim = 2, .nodes_each = 4, .count = 2, .faces = {}}};
  document.blocks[0].partitions = static_cast<std::int32_t>(document.tag_sets.size());
  document.tag_sets.push_back({1});
  std::string aside;
  for (const Loss& loss :
       kept_aside(files.path("b.msh"), document, {.format = "msh22", .binary = true}).items)
    aside += loss.item + "; ";
  EXPECT_NE(aside.find("ghost elements"), std::string::npos) << aside;
}

// Element 1 belongs to partition 1 and is a ghost of 2 and 3, element 2 of the same entity is one of 2,
// element 3 is none; element 4 belongs to two partitions.
const std::string ghosts = v22 + nodes22 +
                           "$Elements\n4\n1 4 6 7 1 3 1 -2 -3 1 2 3 4\n2 4 5 7 1 2 1 -2 2 3 1 4\n"
                           "3 4 4 7 1 1 1 3 1 2 4\n4 4 6 7 1 3 2 3 -1 1 2 3 4\n$EndElements\n";

TEST(MshIrregular, GhostsOf22ComeTo41AndBack) {
  const test::TestFiles files;
  const Document document = read_document(files.write("a.msh", ghosts));
  EXPECT_TRUE(document.dropped.empty());
  EXPECT_EQ(document.blocks.size(), 2u);
  const std::string elements =
      "e 1 4 3/1 g7 p1: 1 2 3 4\ne 2 4 3/1 g7 p1: 2 3 1 4\ne 3 4 3/1 g7 p1: 3 1 2 4\ne 4 4 3/1 g7 p2,3: 1 2 "
      "3 4\n";
  const std::string of_ghosts = "ghost element 1 1: 2 3\nghost element 2 1: 2\nghost element 4 2: 1\n";
  EXPECT_EQ(test::text_of(document, false), four_points + elements + of_ghosts);
  for (const bool binary : {false, true}) {
    const std::string old = files.path("b.msh"), now = files.path("c.msh");
    const WriteOptions to22{.format = "msh22", .binary = binary}, to41{.format = "msh41", .binary = binary};
    EXPECT_TRUE(losses(old, document, to22).empty());
    for (const Loss& loss : kept_aside(old, document, to22).items) ADD_FAILURE() << loss.item;
    write_document(old, document, to22);
    files.leave_out_supplement(old);
    EXPECT_EQ(test::text_of(read_document(old), false), test::text_of(document, false)) << files.read(old);

    for (const Loss& loss : kept_aside(now, document, to41).items)
      EXPECT_EQ(loss.item.find("artition"), loss.item.npos) << loss.item;  // of elements, of ghosts
    write_document(now, document, to41);
    files.leave_out_supplement(now);
    const Document back = read_document(now);
    std::string partitions;
    for (const ElementBlock& block : back.blocks)
      partitions += fmt::format("{} in {}; ", block.count,
                                fmt::join(back.tag_sets[static_cast<std::size_t>(block.partitions)], ","));
    EXPECT_EQ(partitions, "3 in 1; 1 in 2,3; ");
    EXPECT_NE(test::text_of(back, false).find(of_ghosts), std::string::npos) << test::text_of(back, false);
  }
}

// Two elements of the same nodes in different groups are no element in two groups: 2.2 tells them apart by a
// tag more, which is the writer's and no loss.
TEST(MshIrregular, ElementsOnTheSameNodesStayTwo) {
  const test::TestFiles files;
  for (const char* partitions : {"2 7 1", "4 7 1 1 5"}) {
    std::string second = partitions;
    second[2] = '8';
    const Document document = read_document(
        files.write("a.msh", v22 + nodes22 + "$Elements\n3\n1 4 " + partitions +
                                 " 1 2 3 4\n2 15 2 7 1 1\n3 4 " + second + " 1 2 3 4\n$EndElements\n"));
    Document two = document;
    two.blocks = {document.blocks.at(0), document.blocks.at(2)};  // now next to each other
    two.blocks[1].first = 1, two.blocks[1].nodes = 4;
    two.connectivity.erase(two.connectivity.begin() + 4);
    two.element_tags = {1, 3};
    for (const bool binary : {false, true}) {
      write_document(files.path("b.msh"), two, {.format = "msh22", .binary = binary});
      const Document back = read_document(files.path("b.msh"));
      EXPECT_EQ(back.elements(), 2u) << partitions;
      EXPECT_EQ(dropped_in(back), "") << partitions;
      EXPECT_EQ(test::text_of(back, false), test::text_of(two, false));
    }
  }
}

// Nothing tells the owner of an element whose partitions are all negative.
TEST(MshIrregular, GhostsWithoutAnOwnerStayPartitions) {
  const Read got = read(v22 + nodes22 + "$Elements\n1\n1 4 4 7 1 1 -2 1 2 3 4\n$EndElements\n");
  EXPECT_EQ(test::text_of(got.document, false), four_points + "e 1 4 3/1 g7 p-2: 1 2 3 4\n");
}

}  // namespace
}  // namespace tetproof
