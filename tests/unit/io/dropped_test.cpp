// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of mesh formats drop: a small file for each kind of thing, and the whole list that it must
// give.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Case {
  std::string name;
  std::vector<std::pair<std::string, std::string>> files;  // the first one is read
  std::vector<std::string> dropped;                        // "ITEM: COUNT (EXAMPLE)"

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

class Dropped : public testing::TestWithParam<Case> {};

TEST_P(Dropped, IsListed) {
  const test::TestFiles files;
  for (const auto& [name, bytes] : GetParam().files) files.write(name, bytes);
  std::vector<std::string> listed;
  for (const Loss& loss : read_document(files.path(GetParam().files[0].first)).dropped) {
    std::string line = fmt::format("{}: {} ({})", loss.item, loss.count, loss.example);
    const std::string folder = files.path("");
    for (std::size_t at; (at = line.find(folder)) != line.npos;) line.erase(at, folder.size());
    listed.push_back(line);
  }
  EXPECT_EQ(listed, GetParam().dropped);
}

const auto name_of = [](const auto& test) { return test.param.name; };

// VTK's legacy files.

std::string vtk(const std::string& cells, const std::string& data = "") {
  return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
         "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n" +
         cells + data;
}

std::string vtk_polydata(const std::string& cells) {
  std::string text = vtk(cells);
  return text.replace(text.find("UNSTRUCTURED_GRID"), 17, "POLYDATA");
}

const std::string tet = "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n";

const std::vector<Case> of_vtk{
    {"NothingOfAPlainFile",
     {{"a.vtk", vtk(tet,
                    "CELL_DATA 1\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n7\n"
                    "FIELD FieldData 1\na 1 1 double\n0.5\n")}},
     {}},
    {"CellsThatNoDocumentHas",
     {{"a.vtk", vtk("CELLS 5 30\n4 0 1 2 4\n4 0 1 2 4\n4 0 1 2 4\n6 0 1 2 3 4 5\n7 0 1 2 3 4 5 6\n"
                    "CELL_TYPES 5\n10 68 68 41 99\n")}},
     {"cells of type 41 (convex point set): 1 (cell 3, 6 points)",
      "cells of type 68 (Lagrange curve): 2 (cell 1, 4 points)",
      "cells of type 99 (no known type): 1 (cell 4, 7 points)"}},
    {"AnEmptyCell",
     {{"a.vtk", vtk("CELLS 1 1\n0\nCELL_TYPES 1\n0\n")}},
     {"cells of type 0 (empty cell): 1 (cell 0, 0 points)"}},
    {"CellsThatAreCutOrChanged",
     {{"a.vtk", vtk("CELLS 7 34\n2 0 1\n3 0 1 2\n4 0 1 2 3\n2 3 4\n4 0 1 2 3\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\n"
                    "CELL_TYPES 7\n4 4 4 2 8 11 6\n")}},
     {"cells of several vertices, kept as points: 1 (cell 3, 2 points)",
      "polylines, kept as lines: 2 (cell 1, 3 points)",
      "triangle strips, kept as triangles: 1 (cell 6, 4 points)",
      "pixels, kept as quadrangles: 1 (cell 4, 4 points)",
      "voxels, kept as hexahedra: 1 (cell 5, 8 points)"}},
    {"PolygonalData",
     {{"a.vtk", vtk_polydata("LINES 2 8\n2 0 1\n4 0 1 2 3\nPOLYGONS 1 4\n3 0 1 2\n")}},
     {"polylines, kept as lines: 1 (cell 1, 4 points)"}},
    {"RolesAndLookupTables",
     {{"a.vtk", vtk(tet,
                    "CELL_DATA 1\nSCALARS a%20b int\nLOOKUP_TABLE mine\n1\nLOOKUP_TABLE mine 1\n0 0.2 0.5 1\n"
                    "VECTORS v double\n1 2 3\nGLOBAL_IDS g int\n7\nCOLOR_SCALARS c 2\n0.4 0.1\n")}},
     {"lookup tables of values: 1 (\"mine\" of \"a b\")", "attribute roles of values: 4 (\"a b\" as SCALARS)",
      "colours, rounded to bytes: 2 (\"mine\")"}},
    {"NamesOfFieldsAndMetadata",
     {{"a.vtk",
       vtk(tet,
           "POINT_DATA 8\nFIELD material 1\nu 1 8 float\n1 2 3 4 5 6 7 8\nMETADATA\nCOMPONENT_NAMES\n"
           "a%20pressure\nINFORMATION 2\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n"
           "NAME UNITS_LABEL LOCATION vtkDataArray\nDATA Pa\n\n"
           "METADATA\nMOOD 3\n\n")}},
     {"names of fields: 1 (\"material\")", "names of components: 1 (\"a pressure\" of \"u\")",
      "information UNITS_LABEL: 1 (\"u\")", "lines of METADATA: 1 (line 25)"}}};

INSTANTIATE_TEST_SUITE_P(Vtk, Dropped, testing::ValuesIn(of_vtk), name_of);

// VTK's XML files.

std::string vtu(const std::string& pieces, const std::string& of_grid = "",
                const std::string& attributes = "") {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid" + attributes + ">\n" +
         of_grid + pieces + "</UnstructuredGrid>\n</VTKFile>\n";
}

std::string piece(const std::string& more = "", const std::string& of_cells = "", const char* type = "10") {
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points><DataArray type=\"Float64\" "
         "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n<Cells>\n"
         "<DataArray type=\"Int32\" Name=\"connectivity\" RangeMin=\"0\" RangeMax=\"3\">0 1 2 3</DataArray>\n"
         "<DataArray type=\"Int8\" Name=\"types\">" +
         std::string(type) + "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray>\n" +
         of_cells + "</Cells>\n" + more + "</Piece>\n";
}

const std::vector<Case> of_vtu{
    {"NothingOfAPlainFile",
     {{"a.vtu", vtu(piece("<!-- no data --><PointData Scalars=\"\">\n<DataArray type=\"Int32\" Name=\"a\" "
                          "IdType=\"1\" NumberOfTuples=\"4\">1 2 3 4</DataArray></PointData>"))}},
     {}},
    {"SeveralCellDataAreAllKept",
     {{"a.vtu", vtu(piece("<CellData><DataArray type=\"Int32\" Name=\"a\">1</DataArray></CellData>"
                          "<CellData><DataArray type=\"Int32\" Name=\"b\">2</DataArray></CellData>"))}},
     {}},
    {"CellsThatNoDocumentHas",
     {{"a.vtu", vtu(piece() + piece("", "", "74") + piece("", "", "42"))}},
     {"cells of type 74 (Lagrange pyramid): 1 (cell 0 of piece 1, 4 points)",
      "cells of type 42 (polyhedron): 1 (cell 0 of piece 2, 4 points)",
      "division into pieces: 1 (3 pieces)"}},
    {"RolesNamesOfComponentsAndInformation",
     {{"a.vtu", vtu(piece("<PointData Scalars=\"T\" Vectors=\"v\">\n<DataArray type=\"Float64\" Name=\"T\" "
                          "ComponentName0=\"Kelvin\">1 2 3 4<InformationKey name=\"L2_NORM_RANGE\" "
                          "location=\"vtkDataArray\"/><InformationKey name=\"UNITS_LABEL\" "
                          "location=\"vtkDataArray\"/></DataArray></PointData>\n"))}},
     {"attribute roles of values: 2 (\"T\" as Scalars)", "names of components: 1 (\"Kelvin\" of \"T\")",
      "information UNITS_LABEL: 1 (\"T\")"}},
    {"Pieces", {{"a.vtu", vtu(piece() + piece())}}, {"division into pieces: 1 (2 pieces)"}},
    {"APieceWithoutPointsDividesNothing",
     {{"a.vtu",
       vtu(piece() +
           "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"><Points/><Cells><DataArray type=\"Int32\" "
           "Name=\"connectivity\"/><DataArray type=\"Int32\" Name=\"offsets\"/><DataArray type=\"Int8\" "
           "Name=\"types\"/></Cells></Piece>")}},
     {}},
    {"ElementsAndAttributesThatAreNotKnown",
     {{"a.vtu", vtu(piece("<Verts/>\n<FieldData/>\n"), "<FieldData>\n<Mine/></FieldData>\nstray\n",
                    " TimeValues=\"0 1 2\"")}},
     {"attribute TimeValues of <UnstructuredGrid>: 1 (line 2: \"0 1 2\")",
      "element <Mine> in <FieldData>: 1 (line 4)", "text in <UnstructuredGrid>: 1 (line 2)",
      "element <Verts> in <Piece>: 1 (line 13)", "element <FieldData> in <Piece>: 1 (line 14)"}},
    {"FurtherOnesOfAKind",
     {{"a.vtu", vtu(piece("<Points/>\n<Cells/>\n",
                          "<DataArray type=\"Int32\" Name=\"types\">5</DataArray>\n"
                          "<DataArray type=\"Int32\" Name=\"faces\">-1</DataArray>\n"))}},
     {"array \"types\" of <Cells>: 1 (line 9)", "array \"faces\" of <Cells>: 1 (line 10)",
      "a further <Points>: 1 (line 12)", "a further <Cells>: 1 (line 13)"}},
    {"BytesBehindValues",
     {{"a.vtu", vtu(piece("<CellData><DataArray type=\"Int8\" Name=\"a\" "
                          "format=\"binary\">AQAAAAc=AAAA</DataArray></CellData>"))}},
     {"bytes behind the values of arrays: 4 (\"a\")"}},
    {"IntegersBeyond63Bits",
     {{"a.vtu", vtu(piece("<CellData><DataArray type=\"UInt64\" "
                          "Name=\"a&#10;b\">18446744073709551615</DataArray></CellData>"))}},
     {"integers of 2^63 or more, kept as negative ones: 1 (18446744073709551615 of \"a\\x0Ab\")"}}};

INSTANTIATE_TEST_SUITE_P(Vtu, Dropped, testing::ValuesIn(of_vtu), name_of);

// Medit's files.

const std::string mesh =
    "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 "
    "3 4 7\n";

// Vertices, and a keyword with these bytes behind it, of which `next` says that there are so many more.
std::string meshb(int code, const std::vector<std::int32_t>& numbers,
                  const std::string& behind_the_end = "") {
  std::string bytes;
  const auto number = [&](std::int32_t value) { test::append(bytes, value, std::endian::little); };
  for (const std::int32_t value : {1, 2, 3, 20, 3, 4, 20 + 8 + 4 + 28, 1}) number(value);
  for (int k = 0; k < 3; ++k) test::append(bytes, 0.5, std::endian::little);
  number(0);
  number(code);
  number(static_cast<std::int32_t>(bytes.size() + 4 + 4 * numbers.size()));
  for (const std::int32_t value : numbers) number(value);
  number(54);
  number(0);
  return bytes + behind_the_end;
}

const std::vector<Case> of_medit{
    {"NothingOfMarksSectionsAndComments",
     {{"a.mesh",
       mesh + "RequiredVertices 1\n2\nRequiredTriangles 0\nRidges 0\nNormals 1\n0 0 1\nMine 3 # no data\n"
              "End # of it\n# a comment\n\n"}},
     {}},
    {"LinesBehindEnd",
     {{"a.mesh", mesh + "End\n# a comment\nTriangles 1\n1 2 3 0\n"}},
     {"lines behind End: 2 (line 12)"}},
    {"LargeReferencesBesideReals",
     {{"a.mesh",
       "MeshVersionFormatted 2\nDimension 3\nVertices 2\n0 0 0 0.5\n1 0 0 9007199254740993\nEnd\n"}},
     {"references of vertices, rounded to doubles: 1 (9007199254740993 of vertex 2)"}},
    {"BinaryKeywordOfUnknownCode",
     {{"a.meshb", meshb(12, {1, 1})}},
     {"keyword of code 12: 1 (byte 68: 8 bytes)"}},
    {"BinaryKeywordOfAnotherForm",
     {{"a.meshb", meshb(60, {1, 1})}},
     {"keyword Normals: 1 (byte 68: 8 bytes)"}},
    {"BytesBehindNumbers",
     {{"a.meshb", meshb(5, {1, 1, 1, 0, 9, 9})}},
     {"bytes behind the numbers of Edges: 8 (byte 84)"}},
    {"BytesBehindTheEnd", {{"a.meshb", meshb(5, {0}, "xyz")}}, {"bytes behind End: 3 (byte 80)"}},
    {"NothingOfAMark", {{"a.meshb", meshb(15, {1, 1})}}, {}}};

INSTANTIATE_TEST_SUITE_P(Medit, Dropped, testing::ValuesIn(of_medit), name_of);

// Gmsh's files.

const std::string v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
                  nodes22 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";

std::string elements22(const std::string& lines, int count = 1) {
  return fmt::format("$Elements\n{}\n{}$EndElements\n", count, lines);
}

// So many elements that several threads read them.
std::string many_elements22(const char* tags) {
  std::string lines;
  for (int e = 1; e <= 3000; ++e) lines += fmt::format("{} 4 {} 1 2 3 4\n", e, tags);
  return v22 + nodes22 + elements22(lines, 3000);
}

const std::vector<Case> of_msh{
    {"NothingOfOtherSections",
     {{"a.msh", v22 + "$Comments\nby hand\n$EndComments\n" + nodes22 + elements22("1 4 2 7 1 1 2 3 4\n") +
                    "$Mine\n1 2 3\n$EndMine\n"}},
     {}},
    {"NothingOfPartitions", {{"a.msh", v22 + nodes22 + elements22("1 4 5 7 1 2 1 -2 1 2 3 4\n")}}, {}},
    {"TagsWithoutAMeaning",
     {{"a.msh",
       v22 + nodes22 +
           elements22(
               "1 4 2 7 1 1 2 3 4\n2 4 3 7 1 2 1 2 3 4\n3 4 5 7 1 0 8 9 1 2 3 4\n4 4 3 7 1 0 1 2 3 4\n", 4)}},
     {"tags of elements without a meaning: 3 (element 2)"}},
    {"TagsOfManyElements",
     {{"a.msh", many_elements22("4 7 1 0 9")}},
     {"tags of elements without a meaning: 3000 (element 1)"}},
    {"NothingOfManyElements", {{"a.msh", many_elements22("2 7 1")}}, {}},
    {"ThirdTagOfVersion20",
     {{"a.msh", "$MeshFormat\n2 0 8\n$EndMeshFormat\n" + nodes22 +
                    elements22("1 4 3 7 1 2 1 2 3 4\n2 4 4 7 1 2 6 1 2 3 4\n", 2)}},
     {"tags of elements without a meaning: 1 (element 2)"}},
    {"ParentsOfVersion3",
     {{"a.msh",
       "$MeshFormat\n3 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0 0\n2 1 0 0 0\n$EndNodes\n"
       "$Elements\n2\n1 1 1 2 1 2\n2 134 1 3 1 2 1\n$EndElements\n"}},
     {"numbers behind the nodes of elements that are no partitions: 1 (element 2)"}},
    {"BytesBehindTheLastSection",
     {{"a.msh", v22 + nodes22 + elements22("1 4 0 1 2 3 4\n") + "garbage $\n"}},
     {"bytes behind the last section: 10 (byte 125)"}},
    {"TextsBesideNames",
     {{"a.msh",
       v22 +
           "$PhysicalNames of parts\n2\n3 7 \"steel\" # hard\n3 8 \"a \"quoted\" one\"\n$EndPhysicalNames\n" +
           nodes22 + elements22("1 4 0 1 2 3 4\n")}},
     {"texts behind the names of sections: 1 (line 4: $PhysicalNames)",
      "texts beside the names of physical groups: 1 (line 6)"}},
    {"AnOutdatedSupplement",
     {{"a.msh", v22 + nodes22 + elements22("1 4 0 1 2 3 4\n") +
                    "$TetproofSupplement\ntetproof 1 this 12345678\n$EndTetproofSupplement\n"}},
     {"outdated supplements: 1 (a.msh)"}}};

INSTANTIATE_TEST_SUITE_P(Msh, Dropped, testing::ValuesIn(of_msh), name_of);

// TetGen's files.

const std::string node = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", ele = "1 4\n1 1 2 3 4\n";

const std::vector<Case> of_tetgen{
    {"NothingOfComments",
     {{"a.node", "# by hand\n" + node + "# the end\n"}, {"a.ele", ele + "\n\n# no data"}},
     {}},
    {"WordsAndLines",
     {{"a.node", "4 3 0 0 9\n1 0 0 0 5\n2 1 0 0 6 7 # two\n3 0 1 0\n4 0 0 1\n5 1 1 1\n\n6 2 2 2\n"},
      {"a.ele", "1 4\n1 1 2 3 4 8\n"}},
     {"words behind those that are read in a line: 5 (a.node:1)",
      "lines behind those that a file announces: 2 (a.node:6)"}},
    {"NumbersOfFacesAndEdges",
     {{"a.ele", "1 4\n9 1 2 3 4\n"},
      {"a.node", node},
      {"a.face", "2\n1 1 2 3\n5 1 2 4\n"},
      {"a.edge", "1\n7 1 2\n"},
      {"a.neigh", "1 4\n9 -1 -1 -1 -1\n"}},
     {"numbers of faces: 1 (5 in place of 2)", "numbers of edges: 1 (7 in place of 1)",
      "numbers of lines: 1 (9 in place of 1)"}},
    {"FilesWithoutAMeaning",
     {{"a.node", node}, {"a.neigh", "1 4\n1 -1 -1 -1 -1\n"}, {"a.vol", "1\n1 2\n"}},
     {"files of the set that are not read: 2 (a.neigh)"}},
    {"NumbersInAPoly",
     {{"a.poly", node + "1 0\n1\n3 1 2 3\n2\n0 5 5 5\n1 6 6 6\n2\n1 0 0 0 1 2\n4 0 0 0 1 2\n"}},
     {"numbers of regions: 1 (4 in place of 2)"}},
    {"NumbersOfHolesAndBounds",
     {{"a.poly", node + "1 0\n1 1\n3 1 2 3\n7 0 0 0\n1\n3 5 5 5\n0\n"},
      {"a.var", "2\n1 7 0.5\n1 8 0.5\n0\n"}},
     {"numbers of holes: 2 (7 in place of 1)", "numbers of bounds: 1 (1 in place of 2)"}},
    {"VoronoiPoints",
     {{"a.v.cell", "2\n1 2 1 2\n5 2 1 -1\n"},
      {"a.node", node},
      {"a.v.node", "2 3 1 1\n1 0.5 0.5 0.5 8 9\n2 1 1 1 8 9 10\n"},
      {"a.v.edge", "2 0\n1 1 2\n2 2 -1 0 0 -1.5\n"},
      {"a.v.face", "2 0\n1 1 2 2 1 2\n2 3 4 2 2 -1\n"}},
     {"words behind those that are read in a line: 1 (a.v.node:3)",
      "attributes of Voronoi points: 2 (a.v.node)", "markers of Voronoi points: 2 (a.v.node)",
      "numbers of Voronoi cells: 1 (5 in place of 2)"}}};

INSTANTIATE_TEST_SUITE_P(Tetgen, Dropped, testing::ValuesIn(of_tetgen), name_of);

// Pentahedra are another name of prisms, and so nothing is dropped.
TEST(DroppedByMedit, NothingOfPentahedra) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n"
      "0 1 1 0\nPentahedra 1\n1 2 3 4 5 6 9\nEnd\n"));
  ASSERT_EQ(document.blocks.size(), 1u);
  EXPECT_EQ(document.blocks[0].type, 6);
  EXPECT_EQ(document.connectivity, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(document.dropped.empty() && document.sections.empty() && document.warnings.empty());
}

}  // namespace
}  // namespace tetproof
