// SPDX-License-Identifier: GPL-3.0-or-later
// What the surface formats write, and what they cannot hold and list as lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof {
namespace {

using test::obj_square;
using test::ply_start;
using test::ply_xyz;
using test::square;
using test::told;

// The bytes are compared with text written by hand.
TEST(SurfaceDocuments, AreWrittenAsTheFormatsSay) {
  const test::TestFiles files;
  Document document = read_document(files.write(
      "a.obj",
      obj_square + "vt 0 0\nvt 1 0\nvn 0 0 1\no part\ng wing\nusemtl red\nf 1/1/1 2/2/1 3/1/1\nf 1 3 4\n"));
  document.tag_sets[1] = {5};
  document.group_names[0].group = 5;
  write_document(files.path("b.obj"), document);
  EXPECT_EQ(files.read(files.path("b.obj")),
            obj_square +
                "vt 0 0\nvt 1 0\nvn 0 0 1\n# group 5 wing\no part\ng wing\nusemtl red\n"
                "f 1/1/1 2/2/1 3/1/1\nf 1 3 4\n");
  write_document(files.path("b.stl"), document, {.binary = false});
  EXPECT_EQ(files.read(files.path("b.stl")).substr(0, 32), "solid wing #5\nfacet normal 0 0 1");
}

TEST(SurfaceDocuments, StlHasANodeAtNanForEachCorner) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Document document =
      document_of(TriangleSurface{{{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {2, 1, 3}}});
  const test::TestFiles files;
  for (const bool binary : {false, true}) {
    const std::string path = files.path("a.stl");
    const std::vector<Loss> lost = losses(path, document, {.binary = binary});
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost[0].item, "nodes at NaN, which become one for each corner");
    EXPECT_EQ(lost[0].count, 1U);
    EXPECT_EQ(lost[0].example, "node 3");
    write_document(path, document, {.binary = binary});
    EXPECT_EQ(read_document(path).points.size(), 5U);
  }
}

// Where every element is cut, none is left out: also where the elements have numbers of their own.
TEST(SurfaceDocuments, StlCutsAllNumberedElements) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
      "$EndNodes\n$Elements\n4\n7 3 0 1 2 3 4\n5 3 0 1 2 3 4\n6 3 0 1 2 3 4\n8 3 0 1 2 3 4\n$EndElements\n"));
  const std::vector<Loss> lost = losses("a.stl", document, {.binary = true});
  EXPECT_TRUE(std::none_of(lost.begin(), lost.end(), [](const Loss& loss) { return loss.elements; }));
  ASSERT_GE(lost.size(), 1u);
  EXPECT_EQ(lost[0].item, "quadrangles of 4 nodes (type 3) cut into triangles");
  EXPECT_EQ(lost[0].count, 4);
  EXPECT_EQ(lost[0].example, "element 7");
}

// A square becomes two triangles, and so does a bent one. A polygon that crosses itself is left out and
// listed.
TEST(SurfaceDocuments, StlCutsPolygons) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.off", "OFF 5 4 0\n" + square + "0 0 1\n4 0 1 2 3\n4 0 1 2 4\n4 0 2 1 3\n3 0 1 4\n"));
  write_document(files.path("a.stl"), document, {.binary = false});
  const Document back = read_document(files.path("a.stl"));
  EXPECT_EQ(told(back), "e2: 1 2 3\ne2: 1 3 4\ne2: 1 2 3\ne2: 1 3 5\ne2: 1 2 5\n");
  const std::vector<Loss> lost = losses("a.stl", document, {.binary = false});
  ASSERT_GE(lost.size(), 2u);
  EXPECT_EQ(lost[0].item, "quadrangles of 4 nodes (type 3) cut into triangles");
  EXPECT_EQ(lost[0].count, 2);
  EXPECT_EQ(lost[0].example, "element 1");
  EXPECT_EQ(lost[1].item, "quadrangles of 4 nodes (type 3)");
  EXPECT_EQ(lost[1].count, 1);
  EXPECT_EQ(lost[1].example, "element 3");
  EXPECT_EQ(
      write_warning("a.stl", document),
      "a.stl: 1 quadrangle is not planar: cut along the shorter diagonal; the largest bend is 90 degrees");
}

// A facet with a hole, and polygons that are not convex.
TEST(SurfaceDocuments, StlOfConcavePolygonsAndFacets) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.poly",
                  "8 3 0 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 1 1 0\n6 3 1 0\n7 3 3 0\n8 1 3 0\n"
                  "2 0\n2 1\n4 1 2 3 4\n4 5 6 7 8\n1 2 2 0\n1 0\n5 1 2 3 4 5\n0\n0\n"));
  write_document(files.path("a.stl"), document, {.binary = true});
  EXPECT_EQ(read_surface(files.path("a.stl")).triangles.size(), 8u + 3u);
}

// If PLY has no place for one table, the other tables are written all the same.
TEST(SurfaceDocuments, PlyLosesTablesOneByOne) {
  const test::TestFiles files;
  Document document = read_document(
      files.write("a.ply", ply_start + "element vertex 1\n" + ply_xyz +
                               "element camera 1\nproperty float f\nend_header\n" + "0 0 0\n0.25\n"));
  document.tables.push_back(
      {.name = "notes", .rows = 1, .columns = {{.name = "t", .type = "String", .texts = {"x"}}}});
  const std::vector<Loss> lost = losses("b.ply", document);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].item, "table \"notes\"");
  write_document(files.path("b.ply"), document);
  EXPECT_EQ(told(read_document(files.path("b.ply"))), "table camera 1\n  f (float) 0.25 []\n");
}

TEST(SurfaceDocuments, ZerosAndNansSurvive) {
  const test::TestFiles files;
  for (const char* name : {"a.off", "a.obj", "a.ply"}) {
    const Document document =
        read_document(files.write("b.off",
                                  "NOFF 3 1 0\n-0 4.9e-324 0.1 nan inf -0\n1e308 0 0.30000000000000004 0 0 "
                                  "1\n0 -inf nan 1 1 1\n3 0 1 2\n"));
    write_document(files.path(name), document, {});
    const Document back = read_document(files.path(name));
    ASSERT_EQ(back.points.size(), 3u);
    EXPECT_TRUE(std::signbit(back.points[0][0])) << name;
    EXPECT_EQ(back.points[0][1], 4.9e-324) << name;
    EXPECT_EQ(back.points[1][2], 0.30000000000000004) << name;
    EXPECT_TRUE(std::isnan(back.points[2][2]) && back.points[2][1] == -HUGE_VAL) << name;
  }
}

}  // namespace
}  // namespace tetproof
