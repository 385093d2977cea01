// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of VTK's files drop, kind by kind.
#include "tests/support/dropped_files.hpp"

namespace tetproof {
namespace {

using Case = test::DroppedFiles;
class DroppedByVtk : public testing::TestWithParam<Case> {};

TEST_P(DroppedByVtk, IsListed) {
  test::expect_dropped(GetParam());
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
    {"PointsBehindThoseOfTheType",
     {{"a.vtk", vtk("CELLS 3 16\n4 0 1 2 4\n6 0 1 2 4 5 6\n3 0 1 7\nCELL_TYPES 3\n10\n10\n3\n")}},
     {"points of cells behind those that their type has: 3 (cell 1: 6 points of type 10)"}},
    {"ArraysWithoutValues",
     {{"a.vtk", vtk(tet, "CELL_DATA 1\nFIELD FieldData 2\nnone 0 0 float\na 1 1 double\n0.5\n")}},
     {"arrays without values: 1 (\"none\")"}},
    {"CellsThatNoDocumentHas",
     {{"a.vtk", vtk("CELLS 5 30\n4 0 1 2 4\n4 0 1 2 4\n4 0 1 2 4\n6 0 1 2 3 4 5\n7 0 1 2 3 4 5 6\n"
                    "CELL_TYPES 5\n10 79 79 41 99\n")}},
     {"cells of type 41 (convex point set): 1 (cell 3, 6 points)",
      "cells of type 79 (Bezier hexahedron): 2 (cell 1, 4 points)",
      "cells of type 99 (no known type): 1 (cell 4, 7 points)"}},
    {"AnEmptyCell",
     {{"a.vtk", vtk("CELLS 1 1\n0\nCELL_TYPES 1\n0\n")}},
     {"cells of type 0 (empty cell): 1 (cell 0, 0 points)"}},
    {"DegenerateCells",
     {{"a.vtk", vtk_polydata("VERTICES 1 1\n0\nLINES 2 6\n1 0\n3 0 1 2\nPOLYGONS 2 3\n0\n1 0\n"
                             "TRIANGLE_STRIPS 1 3\n2 0 1\n")}},
     {"cells of too few points: 4 (cell 0: 0 points of type 2)"}},
    {"CellsThatAreCutOrChanged",
     {{"a.vtk", vtk("CELLS 7 34\n2 0 1\n3 0 1 2\n4 0 1 2 3\n2 3 4\n4 0 1 2 3\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\n"
                    "CELL_TYPES 7\n4 4 4 2 8 11 6\n")}},
     {"cells of several vertices, kept as points: 1 (cell 3, 2 points)",
      "triangle strips, kept as triangles: 1 (cell 6, 4 points)",
      "pixels, kept as quadrangles: 1 (cell 4, 4 points)",
      "voxels, kept as hexahedra: 1 (cell 5, 8 points)"}},
    {"PolygonalData", {{"a.vtk", vtk_polydata("LINES 2 8\n2 0 1\n4 0 1 2 3\nPOLYGONS 1 4\n3 0 1 2\n")}}, {}},
    {"RolesAndLookupTables",
     {{"a.vtk", vtk(tet,
                    "CELL_DATA 1\nSCALARS a%20b int\nLOOKUP_TABLE mine\n1\nLOOKUP_TABLE mine 1\n0 0.2 0.5 1\n"
                    "VECTORS v double\n1 2 3\nGLOBAL_IDS g int\n7\nCOLOR_SCALARS c 2\n0.4 0.1\n")}},
     {"lookup tables of values: 1 (\"mine\" of \"a b\")", "colours, rounded to bytes: 2 (\"mine\")",
      "attribute roles of values: 1 (\"c\" as COLOR_SCALARS)"}},
    {"NoRolesWithoutAField",
     {{"a.vtk", vtk(tet,
                    "POINT_DATA 8\nSCALARS a int\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\nSCALARS b int\n"
                    "LOOKUP_TABLE default\n1 2 3 4 5 6 7 8\nCELL_DATA 1\nVECTORS v double\n1 2 3\nTENSORS t "
                    "float\n1 2 3 4 5 6 7 8 9\n")}},
     {}},
    {"RolesBesideAField",
     {{"a.vtk", vtk(tet,
                    "POINT_DATA 8\nSCALARS a int\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\nSCALARS b int\n"
                    "LOOKUP_TABLE default\n1 2 3 4 5 6 7 8\nCELL_DATA 1\nFIELD FieldData 1\nu 1 1 int\n1\n"
                    "SCALARS entity int\nLOOKUP_TABLE default\n7\nScalars c int\nLOOKUP_TABLE default\n1\n"
                    "SCALARS d int\nLOOKUP_TABLE default\n1\n")}},
     {}},
    {"NamesOfFieldsAndMetadata",
     {{"a.vtk",
       vtk(tet,
           "POINT_DATA 8\nFIELD material 1\nu 1 8 float\n1 2 3 4 5 6 7 8\nMETADATA\nCOMPONENT_NAMES\n"
           "a%20pressure\nINFORMATION 2\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n"
           "NAME UNITS_LABEL LOCATION vtkDataArray\nDATA Pa\n\n"
           "METADATA\nMOOD 3\n\n")}},
     {"names of fields: 1 (\"material\")", "names of components: 1 (\"a pressure\" of \"u\")",
      "information UNITS_LABEL: 1 (\"u\")", "lines of METADATA: 1 (line 25)"}}};

INSTANTIATE_TEST_SUITE_P(Legacy, DroppedByVtk, testing::ValuesIn(of_vtk), name_of);

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
     {"attribute roles of values: 1 (\"v\" as Vectors)", "names of components: 1 (\"Kelvin\" of \"T\")",
      "information UNITS_LABEL: 1 (\"T\")"}},
    {"NoRolesOfEntitiesAndGroups",
     {{"a.vtu", vtu(piece("<CellData Scalars=\"entity\" GlobalIds=\"none\"><DataArray type=\"Int32\" "
                          "Name=\"entity\">7</DataArray></CellData>"))}},
     {"attribute roles of values: 1 (\"none\" as GlobalIds)"}},
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
    {"AnArrayByAnotherName",
     {{"a.vtu", vtu(piece("<CellData><array type=\"Int32\" Name=\"a\" format=\"appended\"/></CellData>"))}},
     {"element <array> in <CellData>: 1 (line 10)"}},
    {"FurtherOnesOfAKind",
     {{"a.vtu", vtu(piece("<Points/>\n<Cells/>\n",
                          "<DataArray type=\"Int32\" Name=\"types\">5</DataArray>\n"
                          "<DataArray type=\"Int32\" Name=\"faces\">-1</DataArray>\n"))}},
     {"faces of cells without \"faceoffsets\": 1 (line 5)", "array \"types\" of <Cells>: 1 (line 9)",
      "a further <Points>: 1 (line 12)", "a further <Cells>: 1 (line 13)"}},
    {"FacesBehindTheLastPolyhedron",
     {{"a.vtu", vtu(piece("",
                          "<DataArray type=\"Int32\" Name=\"faces\">1 3 0 1 2 7 8</DataArray>"
                          "<DataArray type=\"Int32\" Name=\"faceoffsets\">5</DataArray>",
                          "42"))}},
     {"numbers of faces behind those of the last polyhedron: 2 (7)"}},
    {"PolygonsThatAreNotCountedAndNumbersBehindThem",
     {{"a.vtp",
       "<VTKFile type=\"PolyData\"><PolyData>\n<Piece NumberOfPoints=\"1\" NumberOfVerts=\"1\"><Points>"
       "<DataArray type=\"Int8\" NumberOfComponents=\"3\">1 2 3</DataArray></Points>\n<Verts>"
       "<DataArray type=\"Int8\" Name=\"connectivity\">0 0 0</DataArray><DataArray type=\"Int8\" "
       "Name=\"offsets\">1</DataArray></Verts>\n<Polys><DataArray type=\"Int8\" "
       "Name=\"connectivity\">0 0 0</DataArray><DataArray type=\"Int8\" Name=\"offsets\">3"
       "</DataArray></Polys></Piece></PolyData></VTKFile>"}},
     {"numbers of points behind those of the last cell: 2 (line 3)",
      "cells of <Polys> without NumberOfPolys: 1 (line 4)"}},
    {"ValuesBehindThoseOfAnArray",
     {{"a.vtu",
       vtu(piece("<CellData><DataArray type=\"Int8\" Name=\"a\" format=\"ASCII\">1 2 30\n</DataArray>"
                 "<DataArray type=\"Float64\" Name=\"b\">7 \n</DataArray></CellData>"))}},
     {"bytes behind the values of arrays: 4 (\"a\")"}},
    {"SurplusNumbersOfAttributes",
     {{"a.vti",
       "<VTKFile type=\"ImageData\">\n<ImageData WholeExtent=\"0 1 0 1 0 1 0 2\" Origin=\"1 2 3 4\" "
       "Spacing=\"1 1 1 one more\" Direction=\"1 0 0 0 1 0 0 0 1 0\">\n<Piece Extent=\"0 1 0 1 0 1 9\"/>\n"
       "</ImageData></VTKFile>"}},
     {"words behind the 6 numbers of WholeExtent: 2 (line 2: 0 2)",
      "words behind the 3 numbers of Origin: 1 (line 2: 4)",
      "words behind the 3 numbers of Spacing: 2 (line 2: one more)",
      "words behind the 9 numbers of Direction: 1 (line 2: 0)",
      "words behind the 6 numbers of Extent: 1 (line 3: 9)"}},
    {"BytesBehindValues",
     {{"a.vtu", vtu(piece("<CellData><DataArray type=\"Int8\" Name=\"a\" "
                          "format=\"binary\">AQAAAAc=AAAA</DataArray></CellData>"))}},
     {"bytes behind the values of arrays: 4 (\"a\")"}},
    {"IntegersBeyond63Bits",
     {{"a.vtu", vtu(piece("<CellData><DataArray type=\"UInt64\" "
                          "Name=\"a&#10;b\">18446744073709551615</DataArray></CellData>"))}},
     {"integers of 2^63 or more, kept as negative ones: 1 (18446744073709551615 of \"a\\x0Ab\")"}}};

INSTANTIATE_TEST_SUITE_P(Xml, DroppedByVtk, testing::ValuesIn(of_vtu), name_of);

// A mesh lacks the elements whose cells are left out, not those whose cells are cut or changed.
TEST(CellsDroppedByVtk, AreElementsThatTheMeshLacks) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vtk", vtk("CELLS 4 20\n4 0 1 2 4\n3 0 1 2\n8 0 1 2 3 4 5 6 7\n1 0\nCELL_TYPES 4\n41 6 11 1\n")));
  ASSERT_EQ(document.dropped.size(), 2u);
  for (const Loss& loss : document.dropped)
    EXPECT_EQ(loss.elements, loss.item == "cells of type 41 (convex point set)") << loss.item;
}

}  // namespace
}  // namespace tetproof
