// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of documents that are cut into triangles.
#include "edited.hpp"

namespace tetproof::test {
namespace {

TEST(Triangulate, KeepsGroupsValuesAndNumbers) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n",
                     "1 1 2 5 1 1 2\n2 3 2 9 6 1 2 3 4\n3 2 2 9 6 2 5 6\n") +
                   "$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n2\n2 20\n3 30\n$EndElementData\n"
                   "$ElementNodeData\n1\n\"c\"\n1\n0\n3\n0\n1\n1\n2 4 1 2 3 4\n$EndElementNodeData\n");
  EXPECT_EQ(said(io::triangulate(document)), "1 polygon cut into 2 triangles");
  EXPECT_EQ(left_of(document),
            "e1 g5: 1 2\ne2 g9: 1 2 3\ne2 g9: 1 3 4\ne2 g9: 2 5 6\nelement q x1: 20 20 30 from 1\n"
            "corner c x1: 1 2 3 1 3 4 from 1 nodes 3 3\n");
  EXPECT_EQ(document.element_tags, (std::vector<std::int64_t>{1, 2, 4, 3}));
}

TEST(Triangulate, SaysWhatIsNotPlanar) {
  Document document = document_of_text(
      "a.off", "OFF 8 2 0\n0 0 0\n1 0 0\n1 1 .1\n0 1 0\n5 0 0\n6 0 0\n6 1 0\n5 1 .2\n4 0 1 2 3\n4 4 5 6 7\n");
  EXPECT_EQ(said(io::triangulate(document)),
            "2 polygons cut into 4 triangles; 2 quadrangles are not planar: cut along the shorter diagonal; "
            "the largest "
            "bend is 15.8 degrees");  // atan(0.2 sqrt 2), of the second
  EXPECT_EQ(left_of(document), "e2: 1 2 3\ne2: 1 3 0\ne2: 4 5 6\ne2: 4 6 7\n");
}

TEST(Triangulate, SecondOrderByCorners) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 .5 0 0\n6 1 .5 0\n7 .5 1 0\n8 0 .5 0\n",
                     "1 16 2 0 1 1 2 3 4 5 6 7 8\n"));
  EXPECT_EQ(said(io::triangulate(document)),
            "1 polygon cut into 2 triangles | nodes between the corners of quadrangles 4 (the quadrangles "
            "are cut by "
            "their corners)");
  EXPECT_EQ(left_of(document), "e2: 1 2 3\ne2: 1 3 4\n");
}

// A square with a square hole, an edge and a point in TetGen's words; a facet of one polygon behind it.
TEST(Triangulate, FacetsOfSeveralPolygons) {
  Document document = document_of_text(
      "a.poly",
      "9 3 0 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 1 1 0\n6 3 1 0\n7 3 3 0\n8 1 3 0\n9 0 0 1\n"
      "2 1\n2 1 7\n4 1 2 3 4\n4 5 6 7 8\n1 2 2 0\n1 0 8\n3 1 2 9\n0\n0\n");
  EXPECT_EQ(said(io::triangulate(document)), "2 polygons cut into 8 triangles");
  EXPECT_TRUE(document.facets.empty());
  EXPECT_EQ(document.elements(), 9u);
  const std::string text = left_of(document);
  EXPECT_NE(text.find("e2 g7: 3 8 7\ne2 g8: 1 2 9\n"), text.npos) << text;
}

// Lines through four points are no polygons, planar or not.
TEST(Triangulate, LeavesPolylinesAlone) {
  Document document = document_of_text(
      "a.vtk",
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
      "0 0 0 1 0 0 1 1 7 0 1 0 5 5 5\nLINES 2 9\n4 0 1 2 3\n3 0 2 4\nPOLYGONS 1 5\n4 0 1 3 4\n");
  document.title.clear();
  document.points[4] = {-1, 0, 0};  // 0 1 3 4 is a square that was turned, in the plane z = 0
  EXPECT_EQ(said(io::triangulate(document)), "1 polygon cut into 2 triangles");
  EXPECT_EQ(left_of(document), "e1000: 0 1 2 3\ne1000: 0 2 4\ne2: 0 1 3\ne2: 0 3 4\n");
}

// Three corners on a line and an edge on it: there is nothing to cut, and the facet's marker goes with it.
// A facet of two edges has no polygon: they stay.
TEST(Triangulate, ListsFacetsWithoutArea) {
  Document document = document_of_text(
      "a.poly",
      "6 3 0 0\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 0 1\n5 1 0 1\n6 0 1 0\n3 1\n2 0 5\n3 1 2 3\n2 1 2\n"
      "2 0 6\n2 1 4\n2 4 5\n1 0 7\n3 1 2 6\n0\n0\n");
  EXPECT_EQ(
      said(io::triangulate(document)),
      "0 polygons cut into 0 triangles | polygons, edges and points of facets without area 2 (element 1)");
  EXPECT_TRUE(document.facets.empty());
  EXPECT_EQ(left_of(document), "e1 g6: 1 4\ne1 g6: 4 5\ne2 g7: 1 2 6\n");
}

TEST(Triangulate, RefusesByNumber) {
  const TestFiles files;
  Document document = document_of_text("a.off", "OFF 4 1 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n");
  EXPECT_EQ(files.message([&] { io::triangulate(document); }),
            "a.off: element 1 with 4 corners crosses itself");
}

}  // namespace
}  // namespace tetproof::test
