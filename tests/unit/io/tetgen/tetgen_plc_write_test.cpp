// SPDX-License-Identifier: GPL-3.0-or-later
// The writers of TetGen's .poly and .smesh: where each part is written, and that it comes back.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen.hpp"
#include "tests/support/tetgen_text.hpp"
#include "tests/unit/io/tetgen/tetgen_documents.hpp"

namespace tetproof {
namespace {

using test::integers;
using test::tetgen_document;

// A square with a hole and an edge in it, a triangle, a hexagon.
Document boundary() {
  Document document;
  document.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  document.blocks = {
      {.type = 2, .dim = 2, .groups = 1, .nodes_each = 3, .count = 1, .of_boundary = true},
      {.type = 3, .dim = 2, .nodes_each = 4, .count = 1, .first = 1, .nodes = 3, .of_boundary = true},
      {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 2, .nodes = 7, .of_boundary = true},
      {.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 3, .nodes = 10, .of_boundary = true},
      {.type = 34,
       .dim = 2,
       .groups = 2,
       .nodes_each = 6,
       .count = 1,
       .first = 4,
       .nodes = 12,
       .of_boundary = true}};
  document.tag_sets = {{}, {1}, {3}};
  document.connectivity = {0, 1, 2, 0, 1, 2, 3, 4, 5, 6, 0, 4, 0, 1, 2, 3, 4, 5};
  document.element_values = {integers("markers", 1, 0, {-2, -2, -2})};
  document.element_values[0].at = {1, 2, 3};
  document.facets = {{.first = 1, .polygons = 3, .holes = {{1.25, 1.25, 0}}}};
  document.holes = {{1, 2, 3}};
  document.regions = {{{1, 1, 1}, 2.25, -1}};
  return document;
}

TEST(TetgenWrite, Poly) {
  const test::TestFiles files;
  const Document document = boundary();
  write_document(files.path("a.poly"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.poly")),
            "7 3 0 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 1 1 0\n6 2 1 0\n7 1 2 0\n"
            "3 1\n1 0 1\n3 1 2 3\n3 1 -2\n4 1 2 3 4\n3 5 6 7\n2 1 5\n1 1.25 1.25 0\n1 0 3\n6 1 2 3 4 5 6\n"
            "1\n1 1 2 3\n1\n1 1 1 1 2.25 -1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.poly"))), test::tetgen_text(document));
  const io::Holds holds = io::plan_poly(document, false)->holds();
  EXPECT_TRUE(holds.facets && holds.holes && holds.regions && holds.element_tags);
  EXPECT_TRUE(holds.values(document.element_values[0], io::Of::element));
  for (const ElementBlock& block : document.blocks) {
    EXPECT_EQ(holds.nodes_each(block), block.nodes_each);
    EXPECT_TRUE(holds.groups_of(block));
  }
}

TEST(TetgenWrite, Smesh) {
  const test::TestFiles files;
  Document document = boundary();
  EXPECT_EQ(files.message([&] { write_document(files.path("a.smesh"), document); }),
            "a.smesh: cannot write it: a facet of 3 polygons and 1 hole (element 2) has no place in a "
            ".smesh; write a .poly");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
  document.facets.clear();
  write_document(files.path("a.smesh"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.smesh")).substr(64),
            "5 1\n3 1 2 3 1\n4 1 2 3 4 -2\n3 5 6 7 -2\n2 1 5 -2\n6 1 2 3 4 5 6 3\n1\n1 1 2 3\n1\n1 1 1 1 "
            "2.25 -1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.smesh"))), test::tetgen_text(document));
}

TEST(TetgenWrite, AFacetHasOneMarker) {
  Document document = boundary();
  document.element_values[0].integers[2] = -8;
  const io::Holds holds = io::plan_poly(document, false)->holds();
  EXPECT_TRUE(holds.facets);
  EXPECT_FALSE(holds.values(document.element_values[0], io::Of::element));
  document.facets[0].polygons = 9;  // more than the document has
  EXPECT_FALSE(io::plan_poly(document, false)->holds().facets);
}

// TetGen reads at most 2047 bytes of a line.
TEST(TetgenWrite, LongPolygonsOverLines) {
  const test::TestFiles files;
  Document document;
  document.points.assign(1000, {1, 2, 3});
  document.blocks = {{.type = io::polygon, .dim = 2, .nodes_each = 1000, .count = 2, .of_boundary = true}};
  for (Index i = 0; i < 2000; ++i) document.connectivity.push_back(i % 1000);
  document.element_values = {integers("markers", 1, 0, {4, 5})};
  for (const char* name : {"a.poly", "a.smesh"}) {
    write_document(files.path(name), document);
    std::istringstream lines(test::TestFiles::read(files.path(name)));
    for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 2000u);
    EXPECT_EQ(test::tetgen_text(read_document(files.path(name))), test::tetgen_text(document));
  }
}

// If a mesh has no facets, all its faces are the boundary to be meshed.
TEST(TetgenWrite, FacesOfAMeshAsFacets) {
  const test::TestFiles files;
  Document document = tetgen_document();
  document.node_values.clear(), document.area_bounds.clear(), document.length_bounds.clear();
  write_document(files.path("a.smesh"), document);
  const std::string expected =
      "4 3 0 0\n0 0 0 0\n1 0.1 0 0\n2 -0 1 0\n3 0 0 5e-324\n2 1\n3 0 1 2 -7\n3 0 1 3 7\n0\n0\n";
  EXPECT_EQ(test::TestFiles::read(files.path("a.smesh")).substr(0, expected.size()), expected);
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n0 2 3 5 0\n");
}

}  // namespace
}  // namespace tetproof
