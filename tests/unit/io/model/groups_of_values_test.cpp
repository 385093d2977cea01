// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/groups_of_values.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace tetproof {
namespace {

using Reals = std::vector<double>;
using Integers = std::vector<std::int64_t>;

// Two triangles and four tetrahedra; the numbers belong to the tetrahedra.
Document with(Reals reals, Integers integers) {
  Document document;
  document.points.assign(4, {0, 0, 0});
  document.blocks = {{.type = 2, .dim = 2, .nodes_each = 3, .count = 2},
                     {.type = 4, .dim = 3, .nodes_each = 4, .count = 4, .first = 2, .nodes = 6}};
  document.connectivity.assign(22, 0);
  document.element_values = {
      {.name = "tags", .reals = std::move(reals), .integers = std::move(integers), .labels = {}, .first = 2}};
  return document;
}

// The first group of each element; 0: none.
Integers groups(const Document& document) {
  Integers groups;
  std::size_t nodes = 0;
  for (const ElementBlock& block : document.blocks) {
    EXPECT_EQ(block.first, groups.size());
    EXPECT_EQ(block.nodes, nodes);
    nodes += block.count * static_cast<std::size_t>(block.nodes_each);
    const auto& set = document.tag_sets.at(static_cast<std::size_t>(block.groups));
    groups.insert(groups.end(), block.count, set.empty() ? 0 : set[0]);
  }
  return groups;
}

Document made(Reals reals, Integers integers) {
  Document document = with(std::move(reals), std::move(integers));
  io::make_groups_of_values(document, "tags");
  return document;
}

TEST(GroupsOfValues, OfWholeNumbers) {
  for (const Document& document : {made({7, 7, 0, 9}, {}), made({}, {7, 7, 0, 9})}) {
    EXPECT_EQ(groups(document), (Integers{0, 0, 7, 7, 0, 9}));
    EXPECT_EQ(document.blocks.size(), 4u);  // one for each run
    EXPECT_TRUE(document.element_values.empty());
  }
}

TEST(GroupsOfValues, NegativeIntegersStay) {
  const Document document = made({}, {-1, 7, -3, 0});
  EXPECT_EQ(groups(document), (Integers{0, 0, 0, 7, 0, 0}));
  ASSERT_EQ(document.element_values.size(), 1u);
  EXPECT_EQ(document.element_values[0].name, "tags");
  EXPECT_EQ(document.element_values[0].at, (std::vector<Index>{2, 4}));
  EXPECT_EQ(document.element_values[0].integers, (Integers{-1, -3}));
}

TEST(GroupsOfValues, NotOfWhatIsNoTag) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::vector<Document> all{
      made({7, 2.5, 0, 9}, {}),        made({7, -1, 0, 9}, {}),           made({7, -0.0, 0, 9}, {}),
      made({7, infinite, 0, 9}, {}),   made({7, 2147483648.0, 0, 9}, {}), made({0, 0, 0, 0}, {}),
      made({}, {7, 2147483648, 0, 9}), made({}, {0, -1, 0, 0}),           made({7, 1, 2, 3, 4, 5, 6, 8}, {})};
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(groups(all[k]), Integers(6, 0)) << k;
    EXPECT_EQ(all[k].element_values.size(), 1u) << k;
  }
}

TEST(GroupsOfValues, NotWhereElementsHaveGroupsOrTheNameIsAnother) {
  Document document = with({}, {1, 2, 3, 4});
  io::make_groups_of_values(document, "other");
  EXPECT_EQ(groups(document), Integers(6, 0));
  document.tag_sets.push_back({5});
  document.blocks[1].groups = 1;
  io::make_groups_of_values(document, "tags");
  EXPECT_EQ(groups(document), (Integers{0, 0, 5, 5, 5, 5}));
  EXPECT_EQ(document.element_values.size(), 1u);
}

}  // namespace
}  // namespace tetproof
