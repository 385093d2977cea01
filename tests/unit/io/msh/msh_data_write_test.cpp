// SPDX-License-Identifier: GPL-3.0-or-later
// Writes periodic links, ghosts, data of views, and elements in several groups, in every version of .msh: the
// text is the one that was read.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/msh/msh_data_texts.hpp"

namespace tetproof {
namespace {

using test::affine;
using test::behind;
using test::data;
using test::mesh22;
using test::mesh40;
using test::mesh41;

// A mesh with everything is written as the same text that was read, which is written by hand.
TEST(MeshDataWrite, TheTextThatWasRead) {
  const test::TestFiles files;
  for (const auto& [format, text] :
       {std::pair{"msh22", mesh22 + "$Periodic\n2\n2 2 1\nAffine " + affine +
                               "\n2\n10 20\n30 98\n1 -3 4\n0\n"
                               "$EndPeriodic\n" +
                               data},
        {"msh40", mesh40 +
                      "$Periodic\n1\n0 3 4\n1\n40 10\n$EndPeriodic\n"
                      "$GhostElements\n2\n6 1 2 3 4\n5 2 0\n$EndGhostElements\n" +
                      data},
        {"msh41", mesh41 + "$Periodic\n2\n2 2 1\n16 " + affine +
                      "\n1\n10 20\n0 3 4\n0\n1\n40 10\n$EndPeriodic\n"
                      "$GhostElements\n1\n5 1 1 2\n$EndGhostElements\n" +
                      data}}) {
    const Document document = read_document(files.write("a.msh", text));
    write_document(files.path("b.msh"), document, {.format = format});
    EXPECT_EQ(test::TestFiles::read(files.path("b.msh")), text) << format;
  }
}

// In 2.2 an element is listed once for each of its groups, with new numbers after the first time. Reading
// makes it one element again.
TEST(MeshDataWrite, OncePerGroupIn22) {
  const test::TestFiles files;
  const std::string head =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n2 0 0 0\n1 0 0 0 2 7 -8\n2 0 0 0 1 9\n"
      "$EndEntities\n$Nodes\n1 1 1 1\n0 1 0 1\n1\n0 0 0\n$EndNodes\n";
  const Document document = read_document(
      files.write("a.msh", head + "$Elements\n2 3 5 9\n0 1 15 2\n5 1\n9 1\n0 2 15 1\n6 1\n$EndElements\n"));
  for (bool binary : {false, true}) {
    write_document(files.path("b.msh"), document, {.format = "msh22", .binary = binary});
    test::TestFiles::leave_out_supplement(files.path("b.msh"));
    const std::string text = test::TestFiles::read(files.path("b.msh"));
    if (!binary) {
      EXPECT_EQ(behind(text, "$Elements\n"),
                "5\n5 15 2 7 1 1\n10 15 2 -8 1 1\n9 15 2 7 1 1\n11 15 2 -8 1 1\n"
                "6 15 2 9 2 1\n$EndElements\n");
    }
    EXPECT_EQ(behind(test::text_of(read_document(files.path("b.msh"))), "n 1 0 0 0\n"),
              "e 5 15 0/1 g7,-8 p: 1\ne 9 15 0/1 g7,-8 p: 1\ne 6 15 0/2 g9 p: 1\n");
  }
}

// Two elements with the same nodes and different groups stay two elements.
TEST(MeshDataWrite, TwoElementsThatLookLikeOneInTwoGroups) {
  const test::TestFiles files;
  Document document;
  document.points = {{0, 0, 0}};
  document.tag_sets = {{}, {7}, {8}, {9}};
  for (std::int32_t set = 1; set <= 3; ++set) {
    document.blocks.push_back({.type = 15,
                               .dim = 0,
                               .entity = 1,
                               .groups = set,
                               .nodes_each = 1,
                               .count = 1,
                               .first = document.connectivity.size(),
                               .nodes = document.connectivity.size()});
    document.connectivity.push_back(0);
  }
  for (bool binary : {false, true}) {
    write_document(files.path("a.msh"), document, {.format = "msh22", .binary = binary});
    EXPECT_EQ(behind(test::text_of(read_document(files.path("a.msh"))), "n 1 0 0 0\n"),
              "e 1 15 0/1 g7 p: 1\ne 2 15 0/1 g8 p: 1\ne 3 15 0/1 g9 p: 1\n");
  }
  write_document(files.path("a.msh"), document, {.format = "msh22"});
  EXPECT_EQ(behind(test::TestFiles::read(files.path("a.msh")), "$Elements\n"),
            "3\n1 15 2 7 1 1\n2 15 3 8 1 0 1\n3 15 2 9 1 1\n$EndElements\n");
}

}  // namespace
}  // namespace tetproof
