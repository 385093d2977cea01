// SPDX-License-Identifier: GPL-3.0-or-later
// Both formats of VTK: structured grids, polylines, polyhedra, cells of higher order, roles, and irregular
// files that VTK reads. For files that VTK itself writes see tests/programs/vtk_kinds.py.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/vtk/legacy_text.hpp"
#include "tests/unit/io/vtk/there_and_back.hpp"
#include "tests/unit/io/vtk/vtu_text.hpp"

namespace tetproof {
namespace {

using test::expect_back;
using test::legacy;
using test::losses_in_words;
using test::piece;
using test::points4;
using test::tet;
using test::vtu;

const std::string four_points = "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\n";

TEST(VtkKinds, TypesAsVtkReadsThem) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vtk", legacy(tet + "CELL_DATA 1\nSCALARS Label int1\nLOOKUP_TABLE default\n7\n"
                            "SCALARS b bit\nLOOKUP_TABLE default\n1\nFIELD f 3\nu 1 1 vtktypeuint8\n200\n"
                            "l 1 1 vtktypeint64\n-9000000000\nd 1 1 double64\n0.5\n")));
  EXPECT_EQ(test::text_of(document, false),
            four_points +
                "e 0 4 3/0 g7 p: 0 1 2 3\nv elements b 1: 1\nv elements u 1: 200\n"
                "v elements l 1: -9000000000\nv elements d 1: 0.5\n");
  ASSERT_EQ(document.warnings.size(), 2U);
  EXPECT_EQ(document.warnings[0].substr(document.warnings[0].rfind('/') + 1),
            "a.vtk:12: the type 'int1' is read as int, as VTK does");
}

TEST(VtkKinds, OddTypesAreSaidOncePerWord) {
  const test::TestFiles files;
  std::string arrays = "CELL_DATA 1\nFIELD FieldData 16\n";
  for (int k = 0; k < 16; ++k) arrays += fmt::format("a{} 1 1 int{}\n5\n", k, k < 4 ? 1 : k);
  const Document document = read_document(files.write("a.vtk", legacy(tet + arrays)));
  EXPECT_EQ(document.element_values.size(), 16U);
  ASSERT_EQ(document.warnings.size(), 11U);
  EXPECT_EQ(document.warnings[0].substr(document.warnings[0].rfind('/') + 1),
            "a.vtk:13: the type 'int1', 4 times, is read as int, as VTK does");
  EXPECT_TRUE(document.warnings[10].ends_with("a.vtk: 3 types by further words of this kind"));
}

TEST(VtkKinds, TypesBeforeCells) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.vtk", legacy(points4 + "CELL_TYPES 1\n10\nCELLS 1 5\n4 0 1 2 3\n")));
  EXPECT_EQ(test::text_of(document, false), four_points + "e 0 4 3/0 g p: 0 1 2 3\n");
}

TEST(VtkKinds, StructuredGrids) {
  const test::TestFiles files;
  const Document points = read_document(
      files.write("a.vtk", legacy("DIMENSIONS 3 2 2\nORIGIN 1 2 3\nSPACING 0.5 1 2\nCELL_DATA 2\n"
                                  "SCALARS a int\nLOOKUP_TABLE default\n7 8\n",
                                  "STRUCTURED_POINTS")));
  EXPECT_EQ(test::text_of(points, false),
            "n 0 1 2 3\nn 1 1.5 2 3\nn 2 2 2 3\nn 3 1 3 3\nn 4 1.5 3 3\nn 5 2 3 3\nn 6 1 2 5\nn 7 1.5 2 5\n"
            "n 8 2 2 5\nn 9 1 3 5\nn 10 1.5 3 5\nn 11 2 3 5\ne 0 5 3/0 g p: 0 1 4 3 6 7 10 9\n"
            "e 1 5 3/0 g p: 1 2 5 4 7 8 11 10\nv elements a 1: 7 8\n");
  ASSERT_EQ(points.warnings.size(), 1U);
  EXPECT_TRUE(points.warnings[0].ends_with("a structured grid of 3 x 2 x 2 points, kept as 2 hexahedra"));
  EXPECT_TRUE(points.dropped.empty());
  // One layer is quadrangles, one row lines.
  EXPECT_EQ(test::text_of(read_document(files.write(
                              "b.vtk", legacy("DIMENSIONS 2 1 2\nX_COORDINATES 2 float\n0 1\n"
                                              "Y_COORDINATES 1 float\n5\nZ_COORDINATES 2 int\n2 3\n",
                                              "RECTILINEAR_GRID"))),
                          false),
            "n 0 0 5 2\nn 1 1 5 2\nn 2 0 5 3\nn 3 1 5 3\ne 0 3 2/0 g p: 0 1 3 2\n");
  EXPECT_EQ(
      test::text_of(
          read_document(files.write(
              "c.vtk", legacy("DIMENSIONS 1 1 3\nPOINTS 3 int\n0 0 0 1 2 3 4 4 4\n", "STRUCTURED_GRID"))),
          false),
      "n 0 0 0 0\nn 1 1 2 3\nn 2 4 4 4\ne 0 1 1/0 g p: 0 1\ne 1 1 1/0 g p: 1 2\n");
}

TEST(VtkKinds, StructuredGridsThatSayThingsTwiceOrHidePoints) {
  const test::TestFiles files;
  const Document twice = read_document(
      files.write("a.vtk", legacy("DIMENSIONS 2 1 1\nX_COORDINATES 2 float\n0 1\nX_COORDINATES 2 float\n5 6\n"
                                  "Y_COORDINATES 1 float\n0\nZ_COORDINATES 1 float\n0\n",
                                  "RECTILINEAR_GRID")));
  EXPECT_EQ(test::text_of(twice, false), "n 0 5 0 0\nn 1 6 0 0\ne 0 1 1/0 g p: 0 1\n");
  EXPECT_TRUE(twice.warnings.at(0).ends_with("a.vtk:8: a second x_coordinates replaces the first"));
  const Document hidden = read_document(files.write(
      "a.vtk", legacy("DIMENSIONS 2 1 1\nBLANKING 2 unsigned_char\n1 0\nPOINTS 2 int\n0 0 0 1 0 0\n",
                      "STRUCTURED_GRID")));
  EXPECT_EQ(hidden.points.size(), 2U);
  ASSERT_EQ(hidden.dropped.size(), 1U);
  EXPECT_EQ(hidden.dropped[0].item, "points that BLANKING hides");
  EXPECT_EQ(hidden.dropped[0].count, 1);
}

TEST(VtkKinds, StructuredGridsInXml) {
  const test::TestFiles files;
  const Document image = read_document(
      files.write("a.vti",
                  "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"1 2 0 0 0 1\" Origin=\"1 0 0\" "
                  "Spacing=\"2 1 1\" Direction=\"0 -1 0 1 0 0 0 0 1\"><Piece Extent=\"1 2 0 0 0 1\"/>"
                  "</ImageData></VTKFile>"));
  EXPECT_EQ(test::text_of(image, false),
            "n 0 1 2 0\nn 1 1 4 0\nn 2 1 2 1\nn 3 1 4 1\ne 0 3 2/0 g p: 0 1 3 2\n");
  EXPECT_TRUE(image.dropped.empty());
}

TEST(VtkKinds, PolylinesStayAndAreCutWhereThereAreNone) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.vtk", legacy(points4 + "LINES 2 8\n4 0 1 2 3\n2 3 0\nCELL_DATA 2\nSCALARS id int 1\n"
                                            "LOOKUP_TABLE default\n5 6\n",
                                  "POLYDATA")));
  EXPECT_EQ(test::text_of(document, false),
            four_points + "e 0 1000 1/0 g p: 0 1 2 3\ne 1 1 1/0 g p: 3 0\nv elements id 1: 5 6\n");
  EXPECT_TRUE(document.dropped.empty());
  expect_back(files, "b.vtk", document);
  expect_back(files, "b.vtu", document);
  const std::string path = files.path("b.msh");
  EXPECT_EQ(losses_in_words(path, document), "polylines, cut into lines: 1 (element 0 of 4 nodes)\n");
  write_document(path, document);
  EXPECT_EQ(test::text_of(read_document(path), false),
            four_points +
                "e 0 1 1/0 g p: 0 1\ne 1 1 1/0 g p: 1 2\ne 2 1 1/0 g p: 2 3\ne 3 1 1/0 g p: 3 0\n"
                "v elements id 1: 5 5 5 6\n");
}

TEST(VtkKinds, PolygonalDataInXml) {
  const test::TestFiles files;
  const auto list = [](const char* element, const char* connectivity, const char* offsets) {
    return fmt::format(
        "<{0}><DataArray type=\"Int64\" Name=\"connectivity\">{1}</DataArray><DataArray "
        "type=\"Int64\" Name=\"offsets\">{2}</DataArray></{0}>",
        element, connectivity, offsets);
  };
  // Cell data are in the order of points, lines, polygons, strips.
  const Document document = read_document(
      files.write("a.vtp",
                  "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"4\" NumberOfVerts=\"1\" "
                  "NumberOfLines=\"1\" "
                  "NumberOfStrips=\"1\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" "
                  "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>" +
                      list("Strips", "0 1 2 3", "4") + list("Verts", "3", "1") + list("Lines", "0 1 2", "3") +
                      list("Polys", "0 1 3", "3") +
                      "<CellData><DataArray type=\"Int8\" Name=\"a\">1 2 3 "
                      "4</DataArray></CellData></Piece></PolyData></VTKFile>"));
  EXPECT_EQ(test::text_of(document, false),
            four_points +
                "e 0 15 0/0 g p: 3\ne 1 1000 1/0 g p: 0 1 2\ne 2 2 2/0 g p: 0 1 3\n"
                "e 3 2 2/0 g p: 0 1 2\ne 4 2 2/0 g p: 2 1 3\nv elements a 1: 1 2 3 4 4\n");
}

TEST(VtkKinds, HigherOrder) {
  const test::TestFiles files;
  std::string points = "POINTS 20 double\n", numbers;
  for (int i = 0; i < 20; ++i) {
    points += fmt::format("{} {} {}\n", i, i * i, 7 * i % 5);
    numbers += fmt::format(" {}", i);
  }
  const Document lagrange = read_document(
      files.write("a.vtk", legacy(points + "CELLS 1 21\n20" + numbers + "\nCELL_TYPES 1\n71\n")));
  ASSERT_EQ(lagrange.blocks.size(), 1U);
  EXPECT_EQ(lagrange.blocks[0].type, 29);
  // Gmsh's edges 30, 32 and 31 go the other way, in this order; and so do its faces 012, 013, 032, 312.
  EXPECT_EQ(lagrange.connectivity,
            (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 10, 15, 14, 13, 12, 19, 16, 18, 17}));
  expect_back(files, "b.vtk", lagrange);
  expect_back(files, "b.vtu", lagrange);
  const Document bezier = read_document(
      files.write("c.vtk", legacy(points + "CELLS 1 21\n20" + numbers + "\nCELL_TYPES 1\n78\n")));
  ASSERT_EQ(bezier.blocks.size(), 1U);
  EXPECT_EQ(bezier.blocks[0].type, io::bezier(29));
  EXPECT_EQ(bezier.connectivity, lagrange.connectivity);
  ASSERT_EQ(bezier.warnings.size(), 1U);
  EXPECT_TRUE(bezier.warnings[0].ends_with(
      "1 cell of Bezier's kind, kept as such: their control points need not lie on them"))
      << bezier.warnings[0];
  expect_back(files, "d.vtk", bezier);
  expect_back(files, "d.vtu", bezier);
  EXPECT_EQ(losses_in_words("d.mesh", bezier),
            "nodes between the corners of Bezier tetrahedra of 20 nodes: 1 (element 0)\n");
  write_document(files.path("d.msh"), bezier);  // Gmsh has none; the file keeps them for us
  EXPECT_EQ(test::text_of(read_document(files.path("d.msh")), false), test::text_of(bezier, false));
  EXPECT_EQ(tet_mesh(bezier).tets.size(), 1U);  // by its corners
  EXPECT_EQ(tet_mesh(bezier).points.size(), 4U);
}

TEST(VtkKinds, RolesStay) {
  const test::TestFiles files;
  const std::string arrays =
      "<PointData Scalars=\"T\" GlobalIds=\"g\"><DataArray type=\"Float64\" Name=\"U\">4 3 2 1</DataArray>"
      "<DataArray type=\"Float64\" Name=\"T\">1 2 3 4</DataArray><DataArray type=\"Int32\" Name=\"g\">4 5 6 7"
      "</DataArray></PointData><CellData Vectors=\"v\"><DataArray type=\"Float64\" Name=\"v\" "
      "NumberOfComponents=\"3\">1 2 3</DataArray></CellData>";
  const Document document = read_document(files.write("a.vtu", vtu(piece(arrays))));
  EXPECT_TRUE(document.dropped.empty());
  ASSERT_EQ(document.node_values.size(), 3U);
  EXPECT_EQ(document.node_values[1].roles, std::vector<std::string>{"Scalars"});
  EXPECT_EQ(document.element_values[0].roles, std::vector<std::string>{"Vectors"});
  expect_back(files, "b.vtu", document);
  // A legacy file lists attributes first, which is another order of arrays, and no other loss.
  write_document(files.path("b.vtk"), document);
  const Document back = read_document(files.path("b.vtk"));
  ASSERT_EQ(back.node_values.size(), 3U);
  EXPECT_EQ(back.node_values[0].name, "T");
  EXPECT_EQ(back.node_values[0].roles, std::vector<std::string>{"Scalars"});
  EXPECT_EQ(back.node_values[1].roles, std::vector<std::string>{"GlobalIds"});
  EXPECT_TRUE(back.node_values[2].roles.empty());
  EXPECT_EQ(back.element_values[0].roles, std::vector<std::string>{"Vectors"});
  // Kept aside where there is no place for it.
  write_document(files.path("b.msh"), document);
  EXPECT_EQ(read_document(files.path("b.msh")).node_values[1].roles, std::vector<std::string>{"Scalars"});
}

TEST(VtkKinds, EntitiesThatAreAllOneStay) {
  const test::TestFiles files;
  Document document = read_document(files.write(
      "a.vtk", legacy(tet + "CELL_DATA 1\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n1\n")));
  EXPECT_EQ(document.blocks[0].entity, 1);
  expect_back(files, "b.vtk", document);
  expect_back(files, "b.vtu", document);
  document.format = "off";  // where entity 1 is only the reader's
  write_document(files.path("c.vtu"), document);
  EXPECT_EQ(read_document(files.path("c.vtu")).blocks[0].entity, 0);
}

// VTK reads such files; the ends are passed over in other texts, too.
TEST(VtkKinds, MarksAtTheEndOfAText) {
  const test::TestFiles files;
  for (const std::string& end : {std::string("\x1A"), std::string("\0\0", 2)}) {
    const Document document = read_document(files.write("a.vtk", legacy(tet) + end));
    EXPECT_EQ(test::text_of(document, false), four_points + "e 0 4 3/0 g p: 0 1 2 3\n");
    EXPECT_EQ(document.warnings.size(), 1U);
  }
}

}  // namespace
}  // namespace tetproof
