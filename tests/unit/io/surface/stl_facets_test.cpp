// SPDX-License-Identifier: GPL-3.0-or-later
// STL of TetGen's facets, and what is said to be lost of them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof {
namespace {

using test::told;

double area(const TriangleSurface& surface) {
  double twice = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Eigen::Vector3d& p = surface.vertices[static_cast<std::size_t>(a)];
    twice += (surface.vertices[static_cast<std::size_t>(b)] - p)
                 .cross(surface.vertices[static_cast<std::size_t>(c)] - p)
                 .norm();
  }
  return twice / 2;
}

// "ITEM COUNT (EXAMPLE)" of each loss.
std::string lost(const std::string& path, const Document& document, const WriteOptions& options = {}) {
  std::string text;
  for (const Loss& loss : losses(path, document, options))
    text += fmt::format("{} {} ({})\n", loss.item, loss.count, loss.example);
  return text;
}

// Elements 1 and 2 are a facet: an edge in a triangle. Elements 3 and 4 are triangles.
const char* const edge_in_triangle =
    "6 3 0 0\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 1 1 0\n5 2 1 0\n6 0 0 4\n"
    "3 0\n2\n2 4 5\n3 1 2 3\n1\n3 1 2 6\n1\n3 2 3 6\n0\n0\n";

// The edge is left out, and that must not move the facet to other elements. By hand: five points of which
// three are on the hull make five triangles; sides of 4 make areas of 8, and sqrt(3) / 4 times (4 sqrt(2))^2.
TEST(StlOfFacets, StaysWithItsElementsBesideValues) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.poly", edge_in_triangle));
  for (const bool with_values : {false, true}) {
    if (with_values) document.element_values.push_back({.name = "q", .integers = {7, 8, 9}, .at = {1, 2, 3}});
    for (const bool binary : {false, true}) {
      write_document(files.path("a.stl"), document, {.binary = binary});
      const TriangleSurface surface = read_surface(files.path("a.stl"));
      EXPECT_EQ(surface.triangles.size(), 5u + 2u);
      EXPECT_NEAR(area(surface), 8 + 8 + 8 * std::sqrt(3), 1e-6);
      const std::string text = lost("a.stl", document, {.binary = binary});
      EXPECT_EQ(text.find("values \"q\" of elements") != text.npos, with_values) << text;
    }
  }
}

// Triangles that are written as they are were not cut, though a facet is in their block.
TEST(StlOfFacets, TrianglesBesideAFacetAreNotLost) {
  const test::TestFiles files;
  const Document document = read_document(files.write("a.poly", edge_in_triangle));
  const std::string of_facets =
      "that faces are TetGen's facets, which have no direction and may lie inside of the body 3 (element 2)\n"
      "facets of several polygons or with holes 1 (element 1)\n";
  const std::string cut =
      "lines of 2 nodes (type 1) 1 (element 1)\n"
      "triangles of 3 nodes (type 2) cut into triangles 1 (element 2)\n";
  const std::string text = lost("a.stl", document, {.binary = false});
  EXPECT_EQ(text.substr(0, cut.size()), cut);
  EXPECT_NE(text.find(of_facets), text.npos) << text;
  // The triangles are facets 6 and 7 of the file, and were elements 3 and 4.
  EXPECT_NE(text.find("numbers of elements 2 (the first is 3)\n"), text.npos) << text;
}

// A facet that several blocks share, with one solid for each group: it comes once, with its first face.
TEST(StlOfFacets, ComeOnceWhereSolidsChange) {
  const test::TestFiles files;
  Document document;
  document.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {2, 3, 0}, {0, 0, 9}};
  document.tag_sets = {{}, {1}, {2}};
  document.blocks = {{.type = 3, .dim = 2, .groups = 1, .nodes_each = 4, .count = 1, .of_boundary = true},
                     {.type = 2,
                      .dim = 2,
                      .groups = 2,
                      .nodes_each = 3,
                      .count = 1,
                      .first = 1,
                      .nodes = 4,
                      .of_boundary = true},
                     {.type = 2,
                      .dim = 2,
                      .groups = 1,
                      .nodes_each = 3,
                      .count = 1,
                      .first = 2,
                      .nodes = 7,
                      .of_boundary = true}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 0, 1, 7};
  document.facets = {{.first = 0, .polygons = 2, .holes = {{2, 2, 0}}}};
  write_document(files.path("a.stl"), document, {.binary = false});
  const TriangleSurface surface = read_surface(files.path("a.stl"));
  EXPECT_EQ(surface.triangles.size(), 7u + 1u);  // a ring between four and three corners, and the last one
  EXPECT_DOUBLE_EQ(area(surface), 16 - 2 + 18);
  EXPECT_NE(lost("a.stl", document, {.binary = false})
                .find("physical groups of elements 1 (element 2 in groups 2)\n"),
            std::string::npos)
      << lost("a.stl", document, {.binary = false});
  // Again, and as the list of losses asks: the plan is not used up.
  write_document(files.path("b.stl"), document, {.binary = false});
  EXPECT_EQ(files.read(files.path("a.stl")), files.read(files.path("b.stl")));
}

// A value that is said to be lost is not in the file either.
TEST(StlAttributes, AreNotWrittenIfTheyAreLost) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.ply", test::ply_start + "element vertex 5\n" + test::ply_xyz + "element face 2\n" + test::ply_list +
                   "property int attribute\nend_header\n"
                   "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3 7\n3 1 4 2 9\n"));
  ASSERT_NE(told(document).find("element attribute x1 i: 7 9"), std::string::npos);
  EXPECT_NE(lost("a.stl", document).find("values \"attribute\" of elements 2 (7)\n"), std::string::npos);
  write_document(files.path("a.stl"), document);
  EXPECT_EQ(told(read_document(files.path("a.stl"))), "e2: 1 2 3\ne2: 1 3 4\ne2: 2 5 3\n");
}

TEST(StlSolids, SayWhichFormKeepsThem) {
  const test::TestFiles files;
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\n";
  const Document named = read_document(files.write(
      "a.stl", "solid wing\n" + facet + "endsolid wing\nsolid tail\n" + facet + "endsolid tail\n"));
  EXPECT_EQ(write_warning("b.stl", named),
            "b.stl: only the text form has solids: --ascii keeps the groups and their names");
  EXPECT_EQ(write_warning("b.stl", named, {.binary = false}), "");
  const Document plain = read_document(files.write("a.stl", "solid\n" + facet + "endsolid\n"));
  EXPECT_EQ(write_warning("b.stl", plain), "");
}

// A tetrahedron; the last facet is wound outwards, or inwards.
std::string tetrahedron(bool outwards) {
  return std::string(
             "4 3 0 0\n1 0 0 0\n2 0 1 0\n3 1 0 0\n4 0 0 1\n4 0\n1\n3 1 2 3\n1\n3 1 3 4\n1\n3 1 4 2\n1\n") +
         (outwards ? "3 3 2 4\n" : "3 2 3 4\n");
}

// Facets whose direction is already that of the surface say nothing that faces do not say.
TEST(TetgensFacets, AreLostOnlyIfFacesAreAnotherBody) {
  const test::TestFiles files;
  const std::string role =
      "that faces are TetGen's facets, which have no direction and may lie inside of the body 4 (element "
      "1)\n";
  for (const char* target : {"a.stl", "a.vtu", "a.off", "a.ply", "a.obj", "a.mesh"}) {
    EXPECT_EQ(lost(target, read_document(files.write("a.poly", tetrahedron(true) + "0\n0\n"))), "") << target;
    EXPECT_EQ(lost(target, read_document(files.write("a.poly", tetrahedron(false) + "0\n0\n"))), role)
        << target;
  }
  // A point in the solid makes it empty: the facets bound nothing.
  EXPECT_EQ(lost("a.stl", read_document(files.write("a.poly", tetrahedron(true) + "1\n1 0.1 0.2 0.3\n0\n"))),
            role + "holes 1 ((0.1, 0.2, 0.3))\n");
  // Of a mesh with cells, the faces are other than those of a mesh.
  Document document = read_document(files.write("a.poly", tetrahedron(true) + "0\n0\n"));
  document.blocks.push_back({.count = 1, .first = 4, .nodes = 12});
  document.connectivity.insert(document.connectivity.end(), {0, 1, 2, 3});
  EXPECT_EQ(lost("a.vtu", document), role);
  // An edge is always a part of what to mesh.
  const Document edge = read_document(
      files.write("a.poly", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 0\n1\n2 1 4\n0\n0\n"));
  EXPECT_EQ(lost("a.vtu", edge), "that lines and points belong to TetGen's facets 1 (element 1)\n");
}

// A tetrahedron around a smaller one, whose facets are wound into it or out of it.
std::string tetrahedron_with_cavity(const std::string& end, bool wound) {
  const std::string cavity = wound ? "3 5 6 7\n1\n3 5 8 6\n1\n3 5 7 8\n1\n3 6 8 7\n"
                                   : "3 5 7 6\n1\n3 5 6 8\n1\n3 5 8 7\n1\n3 6 7 8\n";
  return "8 3 0 0\n1 0 0 0\n2 0 9 0\n3 9 0 0\n4 0 0 9\n5 1 1 1\n6 2 1 1\n7 1 2 1\n8 1 1 2\n8 0\n1\n3 1 2 "
         "3\n1\n"
         "3 1 3 4\n1\n3 1 4 2\n1\n3 3 2 4\n1\n" +
         cavity + end;
}

// The walls of a cavity say what the point in its hole says, if they are there and wound so.
TEST(TetgensFacets, HolesAreLostOnlyWithoutTheirWalls) {
  const test::TestFiles files;
  const std::string hole = "1\n1 1.1 1.2 1.3\n0\n";
  const Document wound = read_document(files.write("a.poly", tetrahedron_with_cavity(hole, true)));
  for (const char* target : {"a.stl", "a.vtu", "a.off", "a.ply", "a.obj", "a.mesh"})
    EXPECT_EQ(lost(target, wound), "") << target;
  EXPECT_NE(
      lost("a.stl", read_document(files.write("a.poly", tetrahedron_with_cavity(hole, false)))).find("holes"),
      std::string::npos);
  // The cavity's facets alone, around the point: the tetrahedron outside is left out of the STL.
  Document second = wound;
  second.connectivity[12] = -1, second.unknown = {77};
  EXPECT_NE(lost("a.stl", second).find("holes 1 "), std::string::npos);
  // A .msh keeps the point aside, for TetGen.
  EXPECT_EQ(kept_aside("a.msh", wound).items.back().item, "holes");
}

// The faces of a closed surface are a body to mesh as they are.
TEST(TetgensFacets, FacesBecomeThemWithoutALossOnlyIfTheyAreTheSameBody) {
  const test::TestFiles files;
  const auto aside = [&](const std::string& faces) {
    std::string text;
    const Document document =
        read_document(files.write("a.off", "OFF\n4 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 1\n" + faces));
    for (const Loss& loss : kept_aside("a.poly", document).items)
      text += fmt::format("{} {}\n", loss.item, loss.count);
    return text;
  };
  const std::string three = "3 0 1 2\n3 0 2 3\n3 0 3 1\n";
  EXPECT_EQ(aside(three + "3 2 1 3\n"), "");
  EXPECT_EQ(aside(three + "3 1 2 3\n"), "that faces are of a mesh, not facets of a body to mesh 4\n");
}

}  // namespace
}  // namespace tetproof
