// SPDX-License-Identifier: GPL-3.0-or-later
// Documents that are joined.
#include "edited.hpp"

namespace tetproof::test {
namespace {

Document part(const std::string& name, const std::string& group, int number) {
  return document_of_text(
      name, msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", fmt::format("1 4 2 {} 1 1 2 3 4\n", number),
                  fmt::format("$PhysicalNames\n1\n3 {} \"{}\"\n$EndPhysicalNames\n", number, group)) +
                "$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n1\n1 7\n$EndElementData\n");
}

TEST(Join, NumbersMoveUpAndValuesBecomeOne) {
  Document document = part("a.msh", "steel", 1);
  EXPECT_EQ(
      said(io::join(document, part("b.msh", "air", 2))),
      "4 nodes and 1 element of b.msh joined; its node numbers moved up; its element numbers moved up; its "
      "entities' tags moved up by 1");
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 3 2 air\ne4 g1: 1 2 3 4\ne4 g2: 5 6 7 8\nelement q x1: 7 7\n");
  EXPECT_EQ(document.blocks[1].entity, 2);
}

TEST(Join, NumbersThatDifferStay) {
  Document document = part("a.msh", "steel", 1), other = part("b.msh", "steel", 1);
  other.first_node = 100;
  other.element_tags = {50};
  io::join(document, std::move(other));
  EXPECT_EQ(document.node_tags, (std::vector<std::int64_t>{1, 2, 3, 4, 100, 101, 102, 103}));
  EXPECT_EQ(document.element_tag(1), 50);
}

TEST(Join, GroupsByName) {
  Document document = part("a.msh", "steel", 1);
  io::join(document, part("b.msh", "steel", 5));  // the same group with another number
  EXPECT_NE(said(io::join(document, part("c.msh", "air", 1))).find("1 group of it got another number"),
            std::string::npos);  // the same number, but another group
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 3 2 air\ne4 g1: 1 2 3 4\ne4 g1: 5 6 7 8\ne4 g2: 9 10 11 12\n"
            "element q x1: 7 7 7\n");
}

TEST(Join, ValuesOfOneDocumentAlone) {
  Document document = two_tets(),
           other = document_of_text("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  io::join(document, std::move(other));
  io::join(document, two_tets());
  const std::string text = left_of(document);
  EXPECT_NE(text.find("node t x1: 1 2 3 4 5 6 1 2 3 4 5 6 at 0 1 2 3 4 5 9 10 11 12 13 14\n"), text.npos)
      << text;
  EXPECT_NE(text.find("element q x1: 70 80 90 70 80 90 at 1 2 3 6 7 8\n"), text.npos) << text;
}

// TetGen says markers, Medit says references.
TEST(Join, TagsOfNodesBecomeOneFromWhateverTool) {
  const std::string
      nodes = "2 3 0 1\n1 0 0 0 5\n2 1 0 0 6\n",
      mesh = "MeshVersionFormatted 2\nDimension 3\nVertices 2\n2 0 0 7\n3 0 0 8\nEdges 1\n1 2 0\nEnd\n";
  Document document = document_of_text("a.node", nodes);
  io::join(document, document_of_text("b.mesh", mesh));
  EXPECT_NE(left_of(document).find("node markers x1 i: 5 6 7 8\n"), std::string::npos) << left_of(document);
  Document other = document_of_text("b.mesh", mesh);
  io::join(other, document_of_text("a.node", nodes));
  EXPECT_NE(left_of(other).find("node references x1 i: 7 8 5 6\n"), std::string::npos) << left_of(other);
  // Where a file has both words, they are two things.
  Document both = document_of_text("b.mesh", mesh);
  both.node_values.push_back(both.node_values.at(0));
  both.node_values.back().name = "markers";
  io::join(document, std::move(both));
  EXPECT_NE(left_of(document).find("node references x1 i: 7 8 from 4\n"), std::string::npos)
      << left_of(document);
}

TEST(Join, UnknownNodesSectionsAndTitles) {
  Document document = part("a.msh", "steel", 1), other = part("b.msh", "steel", 1);
  document.unknown = {77}, document.connectivity[3] = -1;
  other.unknown = {88}, other.connectivity[3] = -1;
  document.title = "one", other.title = "two";
  document.sections = {{.name = "Mine", .body = "x\n", .format = "msh22"}};
  other.sections = {{.name = "Mine", .body = "y\n", .format = "msh22"}};
  const io::Edit edit = io::join(document, std::move(other));
  EXPECT_NE(said(edit).find(" | title 1 (two) | sections 1 ($Mine of b.msh)"), std::string::npos)
      << said(edit);
  EXPECT_EQ(left_of(document),
            "title one\ngroup 3 1 steel\ne4 g1: 1 2 3 77\ne4 g1: 5 6 7 88\nelement q x1: 7 7\n");
}

// Node 4 of the first and node 10 of the second do not exist, and are not to be made by the other one.
TEST(Join, WhatNamesNothingGoesOnNamingNothing) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n", "1 4 2 0 1 1 2 3 4\n2 4 2 0 1 1 2 3 20\n"));
  const io::Edit edit =
      io::join(document, document_of_text("b.msh", msh22("4 5 5 5\n5 6 5 5\n", "7 2 2 0 1 4 5 10\n")));
  EXPECT_NE(said(edit).find("; 1 number that names nothing moved behind all others"), std::string::npos)
      << said(edit);
  EXPECT_EQ(left_of(document), "e4: 1 2 3 21\ne4: 1 2 3 20\ne2: 4 5 10\n");
}

// Numbers that are a file's stay, in either order, and those that a reader counted come behind them; so that
// the numbers of a file are still those of a file after more edits.
TEST(Join, CountedNumbersComeBehind) {
  const char* const off = "OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n8 8 8\n3 0 1 2\n";
  const std::string msh =
      msh22("1 9 9 9\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n", "1 4 2 0 1 2 3 4 5\n") + "$Mine\n2\n$EndMine\n";
  Document document = document_of_text("a.msh", msh);
  EXPECT_EQ(said(io::join(document, document_of_text("b.off", off))),
            "4 nodes and 1 element of b.off joined");
  EXPECT_EQ(left_of(document), "e4: 2 3 4 5\ne2: 6 7 8\n");
  EXPECT_EQ(said(io::prune(document)), "2 unused points left out");
  EXPECT_EQ(left_of(document), "e4: 2 3 4 5\ne2: 6 7 8\n");
  EXPECT_EQ(document.sections.size(), 1u);
  document = document_of_text("b.off", off);
  EXPECT_EQ(said(io::join(document, document_of_text("a.msh", msh))),
            "5 nodes and 1 element of a.msh joined");
  EXPECT_EQ(left_of(document), "e2: 6 7 8\ne4: 2 3 4 5\n");
  EXPECT_EQ(document.element_tags, (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(document.sections.size(), 1u);
  document = document_of_text("b.off", off);  // two that were counted count on
  io::join(document, document_of_text("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(left_of(document), "e2: 0 1 2\ne2: 4 5 6\n");
}

// Two groups of one file stay two, whatever the other file calls its own.
TEST(Join, GroupsOfOneFileStayApart) {
  const std::string nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  const auto file = [&](const std::string& name, int first, int second) {
    return document_of_text(
        name, msh22(nodes, fmt::format("1 4 2 {} 1 1 2 3 4\n2 4 2 {} 2 1 2 3 4\n", first, second),
                    fmt::format("$PhysicalNames\n1\n3 {} \"steel\"\n$EndPhysicalNames\n", first)));
  };
  Document document = file("a.msh", 1, 9);
  EXPECT_NE(said(io::join(document, file("b.msh", 5, 1))).find("2 groups of it got another number"),
            std::string::npos);
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ne4 g1: 1 2 3 4\ne4 g9: 1 2 3 4\ne4 g1: 5 6 7 8\ne4 g10: 5 6 7 8\n");
}

TEST(Join, AllNamesOfAGroupStay) {
  Document document = part("a.msh", "one", 1), other = part("b.msh", "uno", 4), third = part("c.msh", "x", 1);
  document.group_names.push_back({3, 1, "uno"});
  other.group_names.push_back({3, 4, "eins"});
  io::join(document, std::move(other));
  EXPECT_EQ(left_of(document),
            "group 3 1 one\ngroup 3 1 uno\ngroup 3 1 eins\ne4 g1: 1 2 3 4\ne4 g1: 5 6 7 8\n"
            "element q x1: 7 7\n");
  third.group_names.push_back({3, 1, "eins"});
  io::join(document, std::move(third));
  EXPECT_EQ(document.group_names.size(), 4u);
  EXPECT_EQ(document.group_names.back().group, 1);
}

TEST(Join, ValuesThatExistTwice) {
  const auto file = [](const std::string& name, double a, double b) {
    Document document = part(name, "steel", 1);
    document.element_values = {document.element_values[0], document.element_values[0]};
    document.element_values[0].reals = {a};
    document.element_values[1].reals = {b};
    return document;
  };
  Document document = file("a.msh", 1, 2);
  io::join(document, file("b.msh", 3, 4));
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ne4 g1: 1 2 3 4\ne4 g1: 5 6 7 8\nelement q x1: 1 3\nelement q x1: 2 4\n");
  io::join(document, part("c.msh", "steel", 1));  // has it once
  document = part("c.msh", "steel", 1);           // the first has it once
  io::join(document, file("a.msh", 1, 2));
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ne4 g1: 1 2 3 4\ne4 g1: 5 6 7 8\nelement q x1: 7 1\nelement q x1: 2 from 1\n");
}

// Tags near the end of the range are not added up.
TEST(Join, HugeTagsOfEntities) {
  Document document = part("a.msh", "steel", 1), other = part("b.msh", "steel", 1);
  document.blocks[0].entity = other.blocks[0].entity = 9223372036854775807;
  EXPECT_NE(said(io::join(document, std::move(other))).find("; 1 entity of it got another tag"),
            std::string::npos);
  EXPECT_EQ(document.blocks[1].entity, 1);
}

TEST(Join, WithMergedPointsIsConforming) {
  Document document = part("a.msh", "steel", 1), other = part("b.msh", "air", 2);
  io::translate(other, {1, 0, 0});
  io::join(document, std::move(other));
  EXPECT_EQ(said(io::merge_points(document)), "1 point merged into others at the same place");
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 3 2 air\ne4 g1: 1 2 3 4\ne4 g2: 2 6 7 8\nelement q x1: 7 7\n");
}

}  // namespace
}  // namespace tetproof::test
