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
