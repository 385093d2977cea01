// SPDX-License-Identifier: GPL-3.0-or-later
// Second-order tetrahedra, faces and edges in TetGen's files: the order of their nodes, and that they come
// back.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/tetgen/tetgen.hpp"
#include "tests/support/tetgen_text.hpp"
#include "tests/unit/io/tetgen/tetgen_documents.hpp"

namespace tetproof {
namespace {

using test::integers;

Document second_order(bool first_order_faces) {
  Document document;
  document.points = {{0, 0, 0},    {1, 0, 0},  {0, 1, 0},  {0, 0, 1},   {.5, 0, 0},
                     {.5, .5, .3}, {0, .5, 0}, {0, 0, .5}, {0, .5, .5}, {.5, 0, .5}};
  document.blocks = {{.type = 11, .dim = 3, .nodes_each = 10, .count = 1}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  if (first_order_faces) {
    document.blocks.push_back({.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 1, .nodes = 10});
    document.blocks.push_back({.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 2, .nodes = 13});
    document.connectivity.insert(document.connectivity.end(), {0, 1, 2, 0, 1});
  } else {
    document.blocks.push_back({.type = 9, .dim = 2, .nodes_each = 6, .count = 1, .first = 1, .nodes = 10});
    document.blocks.push_back({.type = 8, .dim = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 16});
    document.connectivity.insert(document.connectivity.end(), {0, 1, 2, 4, 5, 6, 0, 1, 4});
  }
  document.tag_sets = {{}, {3}, {4}};
  document.blocks[1].groups = 1;
  document.blocks[2].groups = 2;
  document.element_values = {integers("neighbours", 2, 1, {1, -1}), integers("neighbours", 1, 2, {1})};
  return document;
}

TEST(TetgenWrite, SecondOrder) {
  const test::TestFiles files;
  const Document document = second_order(false);
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 10 0\n1 1 2 3 4 9 8 5 6 10 7\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "1 1\n1 1 2 3 5 6 7 3 1 -1\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n1 1 2 5 4 1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// If the nodes between corners are in an order that the reader would take for another switch of TetGen, they
// are not written. They come back from the comments.
TEST(TetgenWrite, SecondOrderInAnotherOrder) {
  const test::TestFiles files;
  Document straight = second_order(false);
  straight.points[5] = {.5, .5, 0};
  Document turned = straight, opposite = straight;
  std::swap(turned.connectivity[5], turned.connectivity[6]);
  std::swap(turned.connectivity[7], turned.connectivity[9]);
  std::rotate(opposite.connectivity.begin() + 13, opposite.connectivity.begin() + 14,
              opposite.connectivity.begin() + 16);
  for (const auto& [document, ele, face] : {std::tuple(straight, 10, 6), {turned, 4, 3}, {opposite, 10, 3}}) {
    write_document(files.path("a.ele"), document);
    const Document back = read_document(files.path("a.ele"));
    EXPECT_EQ(back.connectivity, document.connectivity);
    EXPECT_EQ(test::tetgen_text(back), test::tetgen_text(document));
    const auto words = [&](const char* file) {  // number of words in the second line
      std::istringstream text(test::TestFiles::read(files.path(file)));
      std::string line;
      std::getline(text, line), std::getline(text, line);
      std::istringstream of_line(line);
      return std::distance(std::istream_iterator<std::string>(of_line), {});
    };
    EXPECT_EQ(words("a.ele"), 1 + ele);
    EXPECT_EQ(words("a.face"), 1 + face + 1 + (face == 6 || ele == 4 ? 2 : 0));
    std::vector<std::string> aside;
    for (const Loss& loss : kept_aside(files.path("a.ele"), document).items)
      if (loss.item.starts_with("nodes between")) aside.push_back(loss.item);
    EXPECT_EQ(aside.size(), ele == 10 ? face == 6 ? 0 : 1 : 3);
  }
}

// Behind the corners alone, neighbouring tetrahedra would be taken for the nodes between them.
TEST(TetgenWrite, FirstOrderBesideSecondOrder) {
  const test::TestFiles files;
  const Document document = second_order(true);
  const io::Holds holds = io::plan_tetgen(document, false)->holds();
  for (const ElementBlock& block : document.blocks) EXPECT_TRUE(holds.groups_of(block));
  for (const Values& neighbours : document.element_values)
    EXPECT_FALSE(holds.values(neighbours, io::Of::element));
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "1 1\n1 1 2 3 3\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n1 1 2 4\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

}  // namespace
}  // namespace tetproof
