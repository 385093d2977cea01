// SPDX-License-Identifier: GPL-3.0-or-later
// Values of faces, where a surface format leaves other elements out or has its elements in another order.
#include <gtest/gtest.h>

#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof {
namespace {

using test::told;

// A line, a triangle, a tetrahedron, a triangle, a triangle that names an unknown node, and a point. Values
// of all elements, of the triangles, and of the corners of two triangles.
Document mixed() {
  Document document;
  document.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  document.unknown = {99};
  document.tag_sets = {{}, {4}, {5}};
  document.group_names = {{2, 4, "base"}};
  document.blocks = {{.type = 1, .dim = 1, .nodes_each = 2, .count = 1},
                     {.type = 2, .dim = 2, .groups = 1, .nodes_each = 3, .count = 1, .first = 1, .nodes = 2},
                     {.type = 4, .dim = 3, .nodes_each = 4, .count = 1, .first = 2, .nodes = 5},
                     {.type = 2, .dim = 2, .groups = 2, .nodes_each = 3, .count = 2, .first = 3, .nodes = 9},
                     {.type = 15, .dim = 0, .nodes_each = 1, .count = 1, .first = 5, .nodes = 15}};
  document.connectivity = {0, 1, 0, 2, 1, 0, 1, 2, 3, 0, 1, 3, 0, 1, -1, 2};
  document.element_values.push_back({.name = "color",
                                     .components = 3,
                                     .integers = {9, 9, 9, 255, 0, 0, 8, 8, 8, 0, 255, 0, 7, 7, 7, 6, 6, 6}});
  document.element_values.push_back({.name = "attribute", .integers = {11, 12, 13}, .at = {1, 3, 4}});
  document.element_values.push_back({.name = "material",
                                     .integers = {2, 1, 3, 0, 0, 2},
                                     .labels = {"red", "blue", "of lines", "of tetrahedra"}});
  document.element_node_values.push_back({.name = "texture",
                                          .components = 2,
                                          .reals = {0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0, 0, 0.5},
                                          .at = {1, 3},
                                          .nodes = {3, 3}});
  return document;
}

std::string lost(const std::string& path, const Document& document, const WriteOptions& options = {}) {
  std::string text;
  for (const Loss& loss : losses(path, document, options)) text += loss.item + "\n";
  return text;
}

TEST(LeftOutElements, TakeTheirValuesAloneFromPly) {
  const test::TestFiles files;
  const Document document = mixed();
  const std::string losses = lost(files.path("a.ply"), document);
  for (const char* name : {"color", "attribute"}) EXPECT_EQ(losses.find(name), losses.npos) << losses;
  for (const bool binary : {false, true}) {
    write_document(files.path("a.ply"), document, {.binary = binary});
    EXPECT_EQ(told(read_document(files.path("a.ply"))),
              "e2: 0 2 1\ne2: 0 1 3\ne1: 0 1\nelement color x3 i: 255 0 0 0 255 0 9 9 9\n"
              "element attribute x1 i: 11 12\ncorner texture x2: 0 0 1 0 0 1 1 1 0.5 0 0 0.5 nodes 3 3\n");
  }
}

TEST(LeftOutElements, TakeTheirValuesAloneFromOff) {
  const test::TestFiles files;
  const Document document = mixed();
  EXPECT_EQ(lost(files.path("a.off"), document).find("color"), std::string::npos);
  write_document(files.path("a.off"), document);
  EXPECT_EQ(told(read_document(files.path("a.off"))),
            "e2: 0 2 1\ne2: 0 1 3\nelement color x3 i: 255 0 0 0 255 0\n");
}

TEST(LeftOutElements, TakeTheirValuesAloneFromObj) {
  const test::TestFiles files;
  const Document document = mixed();
  const std::string losses = lost(files.path("a.obj"), document);
  for (const char* name : {"material", "texture"}) EXPECT_EQ(losses.find(name), losses.npos) << losses;
  write_document(files.path("a.obj"), document);
  EXPECT_EQ(told(read_document(files.path("a.obj"))),
            "group 2 4 base\ne1: 1 2\ne2 g4: 1 3 2\ne2 g5: 1 2 4\ne15: 3\n"
            "element material x1 i: 0 1 2 0 labels [of lines|blue|red]\n"
            "corner texture x2: 0 0 1 0 0 1 1 1 0.5 0 0 0.5 at 1 2 nodes 3 3\n");
}

TEST(LeftOutElements, TakeTheirValuesAloneFromStl) {
  const test::TestFiles files;
  const Document document = mixed();
  EXPECT_EQ(lost(files.path("a.stl"), document, {.binary = true}).find("attribute"), std::string::npos);
  write_document(files.path("a.stl"), document, {.binary = true});
  EXPECT_EQ(told(read_document(files.path("a.stl"))),
            "e2: 1 2 3\ne2: 1 3 4\nelement attribute x1 i: 11 12\n");
  write_document(files.path("a.stl"), document, {.binary = false});
  EXPECT_EQ(told(read_document(files.path("a.stl"))), "group 2 4 base\ne2 g4: 1 2 3\ne2 g5: 1 3 4\n");
}

// Of values of a number that no element has, something is lost: the list says so.
TEST(LeftOutElements, ValuesOfNoElementAreSaid) {
  Document document = mixed();
  document.element_values = {{.name = "attribute", .integers = {11, 12, 13}, .at = {1, 3, -1}}};
  for (const char* name : {"a.ply", "a.stl"})
    EXPECT_NE(lost(name, document).find("values \"attribute\" of elements\n"), std::string::npos) << name;
}

// Triangles of second order are written by their corners, with their values.
TEST(LeftOutElements, NodesBetweenCornersTakeNoValuesAlong) {
  const test::TestFiles files;
  Document document;
  document.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  document.blocks = {{.type = 9, .dim = 2, .nodes_each = 6, .count = 1}};
  document.connectivity = {0, 1, 2, 3, 4, 5};
  document.element_values.push_back({.name = "color", .components = 3, .integers = {1, 2, 3}});
  document.element_values.push_back({.name = "attribute", .integers = {7}});
  for (const char* name : {"a.ply", "a.off"}) {
    EXPECT_EQ(lost(files.path(name), document).find("color"), std::string::npos) << name;
    write_document(files.path(name), document);
    EXPECT_NE(told(read_document(files.path(name))).find("element color x3 i: 1 2 3\n"), std::string::npos)
        << name;
  }
  write_document(files.path("a.stl"), document);
  EXPECT_EQ(told(read_document(files.path("a.stl"))), "e2: 1 2 3\nelement attribute x1 i: 7\n");
}

// A PLY with its edges in front: the same file again, and OFF without the edges.
TEST(LeftOutElements, OfPlyComeToOff) {
  const test::TestFiles files;
  const std::string ply = test::ply_start + "element vertex 3\n" + test::ply_xyz +
                          "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty uchar flag\n"
                          "element face 2\n" +
                          test::ply_list +
                          "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n0 1 77\n3 0 1 2 1 2 3\n3 0 2 1 4 5 6\n";
  const Document document = read_document(files.write("a.ply", ply));
  EXPECT_EQ(lost(files.path("b.ply"), document), "");
  write_document(files.path("b.ply"), document);
  const Document again = read_document(files.path("b.ply"));
  for (const Document* one : {&document, &again})
    EXPECT_EQ(told(*one),
              "e2: 0 1 2\ne2: 0 2 1\ne1: 0 1\nelement color x3 i: 1 2 3 4 5 6\n"
              "element flag x1 i: 77 from 2\n");
  for (const Document* one : {&document, &again}) {
    EXPECT_EQ(lost(files.path("a.off"), *one), "lines of 2 nodes (type 1)\nvalues \"flag\" of elements\n");
    write_document(files.path("a.off"), *one);
    EXPECT_EQ(told(read_document(files.path("a.off"))),
              "e2: 0 1 2\ne2: 0 2 1\nelement color x3 i: 1 2 3 4 5 6\n");
  }
}

}  // namespace
}  // namespace tetproof
