// SPDX-License-Identifier: GPL-3.0-or-later
// Both formats of VTK: files that are refused, and the place that the message names.
#include <gtest/gtest.h>

#include <string>

#include "io/mesh_files.hpp"
#include "tests/support/refused_file.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/vtk/vtu_text.hpp"

namespace tetproof {
namespace {

using test::piece;
using test::RefusedFile;
using test::vtu;

class VtkErrors : public testing::TestWithParam<RefusedFile> {};

TEST_P(VtkErrors, HaveOneLineWithThePlace) {
  test::expect_refusal(GetParam());
}

const std::string head = "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n",
                  points = head + "POINTS 1 double\n0 0 0\n";

INSTANTIATE_TEST_SUITE_P(
    ByHand, VtkErrors,
    testing::Values(
        RefusedFile{"NoHead", "a.vtk", "vtk", "a.vtk:1: expected # vtk DataFile Version, found 'vtk'"},
        RefusedFile{"OtherDataSet", "a.vtk", "# vtk DataFile Version 2.0\n\nASCII\nDATASET TABLE\n",
                    "a.vtk:4: expected UNSTRUCTURED_GRID, POLYDATA, STRUCTURED_POINTS, STRUCTURED_GRID or "
                    "RECTILINEAR_GRID, found 'TABLE'"},
        RefusedFile{
            "MorePointsThanTheFileHasDataFor", "a.vtk",
            "# vtk DataFile Version 2.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 9999 9999 9999\n",
            "a.vtk:6: 9999 x 9999 x 9999 points are more than a file of 86 bytes can have data for"},
        RefusedFile{"Extent", "a.vtk",
                    "# vtk DataFile Version 2.0\n\nASCII\nDATASET STRUCTURED_POINTS\nEXTENT 0 1 "
                    "-9223372036854775808 9223372036854775807 0 1\n",
                    "a.vtk:5: expected an EXTENT, found -9223372036854775808 to 9223372036854775807"},
        RefusedFile{"NegativeDimension", "a.vtk",
                    "# vtk DataFile Version 2.0\n\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 -1 2\n",
                    "a.vtk:6: 2 x -1 x 2 points are more than a file of 78 bytes can have data for"},
        RefusedFile{"PointsOfAStructuredGrid", "a.vtk",
                    "# vtk DataFile Version 2.0\n\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 2 1 1\n"
                    "POINTS 1 int\n0 0 0\n",
                    "a.vtk:8: expected 2 x 1 x 1 points, found 1"},
        RefusedFile{"CoordinatesOfARectilinearGrid", "a.vtk",
                    "# vtk DataFile Version 2.0\n\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 2 1 1\n"
                    "X_COORDINATES 2 int\n0 1\nY_COORDINATES 1 int\n0\n",
                    "a.vtk:10: expected 1 Z_COORDINATES, found 0"},
        RefusedFile{"FaceOfAPolyhedron", "a.vtk", points + "CELLS 1 5\n4 2 1 0 9\nCELL_TYPES 1\n42\n",
                    "a.vtk: cell 0: expected 2 faces of a polyhedron, found 1 in 4 numbers"},
        RefusedFile{"NumbersBehindThePolyhedron", "a.vtk",
                    points + "CELLS 1 5\n4 1 1 0 9\nCELL_TYPES 1\n42\n",
                    "a.vtk: cell 0: expected the faces of a polyhedron in 4 numbers, found 3 numbers"},
        RefusedFile{"TypesOfOtherCells", "a.vtk", points + "CELL_TYPES 2\n1 1\nCELLS 1 2\n1 0\n",
                    "a.vtk:11: expected the types of 1 cell, found 2"},
        RefusedFile{"TooManyPoints", "a.vtk", head + "POINTS 99 float\n1 2 3\n",
                    "a.vtk:5: expected the number of points, found 99, more than the 13 bytes left can hold"},
        RefusedFile{"NoPoints", "a.vtk", head + "CELLS 1 2\n1 0\nCELL_TYPES 1\n1\n",
                    "a.vtk:9: expected POINTS, found the end of the file"},
        RefusedFile{"CellLongerThanItsList", "a.vtk", points + "CELLS 1 2\n3 0\n",
                    "a.vtk:8: cell 0: expected its number of points, up to 1, found 3"},
        RefusedFile{"NoTypes", "a.vtk", points + "CELLS 1 2\n1 0\n",
                    "a.vtk:9: expected CELL_TYPES, found the end of the file"},
        RefusedFile{"TypeAndSize", "a.vtk", points + "CELLS 1 2\n1 0\nCELL_TYPES 1\n10\n",
                    "a.vtk: cell 0: a cell of VTK's type 10 does not have 1 point"},
        RefusedFile{"UnknownWord", "a.vtk", points + "POINT_DATA 1\nSCALRS a int\n",
                    "a.vtk:8: expected an attribute of points or cells, found 'SCALRS'"},
        RefusedFile{"TooManyValues", "a.vtk", points + "POINT_DATA 99999\nVECTORS a float\n1\n",
                    "a.vtk:8: expected 99999 times 3 values, more than the 3 bytes left can hold"},
        RefusedFile{"NoXml", "a.vtu", "<VTKFile",
                    "a.vtu:1: expected the end of a tag, found the end of the file"},
        RefusedFile{"OtherType", "a.vtu", "<VTKFile type=\"Table\"></VTKFile>",
                    "a.vtu:1: expected VTK's type UnstructuredGrid, PolyData, ImageData, RectilinearGrid or "
                    "StructuredGrid, found 'Table'"},
        RefusedFile{
            "MorePointsThanTheFileHasDataForInXml", "a.vti",
            "<VTKFile type=\"ImageData\">\n<ImageData WholeExtent=\"0 9999 0 9999 0 9999\">\n<Piece/>"
            "</ImageData></VTKFile>",
            "a.vti:3: 10000 x 10000 x 10000 points are more than a file of 104 bytes can have data for"},
        RefusedFile{
            "MorePointsThanPackedDataStandFor", "a.vti",
            "<VTKFile type=\"ImageData\">\n<ImageData WholeExtent=\"0 99 0 99 0 99\">\n<Piece><PointData>"
            "<DataArray type=\"Int8\" Name=\"a\" format=\"binary\">AA==</DataArray></PointData></Piece>"
            "</ImageData></VTKFile>",
            "a.vti:3: 100 x 100 x 100 points are more than a file of 192 bytes can have data for"},
        RefusedFile{
            "OffsetsOfPolyData", "a.vtp",
            "<VTKFile type=\"PolyData\"><PolyData>\n<Piece NumberOfPoints=\"1\" NumberOfVerts=\"1\">"
            "<Points><DataArray type=\"Int8\" NumberOfComponents=\"3\">1 2 3</DataArray></Points>\n<Verts>"
            "<DataArray type=\"Int8\" Name=\"connectivity\">0</DataArray><DataArray type=\"Int8\" "
            "Name=\"offsets\">2</DataArray></Verts></Piece></PolyData></VTKFile>",
            "a.vtp:3: expected an offset from 0 to 1, found 2"},
        RefusedFile{"TagsCross", "a.vtu", "<VTKFile type=\"UnstructuredGrid\">\n<a></b>\n</VTKFile>",
                    "a.vtu:2: expected XML: Start-end tags mismatch"},
        RefusedFile{"OtherCompressor", "a.vtu", vtu("", "compressor=\"vtkMineDataCompressor\""),
                    "a.vtu:3: data compressed by vtkMineDataCompressor, expected vtkZLibDataCompressor, "
                    "vtkLZ4DataCompressor, vtkLZMADataCompressor or none"},
        RefusedFile{"NoPiece", "a.vtu", vtu(""), "a.vtu:4: expected <Piece>"},
        RefusedFile{
            "ValuesMissing", "a.vtu",
            vtu(piece("<PointData>\n<DataArray type=\"Int8\" Name=\"a\">1 2</DataArray></PointData>")),
            "a.vtu:5: array \"a\": expected 4 values, found 2"},
        RefusedFile{"NotANumber", "a.vtu", vtu(piece("", "0 1 2 x")),
                    "a.vtu:4: expected an integer, found 'x'"},
        RefusedFile{"OffsetBehindTheEnd", "a.vtu", vtu(piece("", "0 1 2")),
                    "a.vtu: cell 0: expected an offset from 0 to 3, found 4"},
        RefusedFile{
            "PointsOutOfNumber", "a.vtu", vtu("<Piece NumberOfPoints=\"99999999999\" NumberOfCells=\"0\"/>"),
            "a.vtu:4: NumberOfPoints of 99999999999 are more than the 2147483647 that can be numbered here"},
        RefusedFile{"Base64", "a.vtu",
                    vtu("<FieldData><DataArray type=\"Int8\" Name=\"a\" "
                        "format=\"binary\">AQ*A</DataArray></FieldData><Piece/>"),
                    "a.vtu: byte 155: expected base64, found '*'"},
        RefusedFile{"SizeBeyondTheData", "a.vtu",
                    vtu("<FieldData><DataArray type=\"Int8\" Name=\"a\" "
                        "format=\"binary\">/////w==</DataArray></FieldData><Piece/>"),
                    "a.vtu: byte 161: expected 4294967295 bytes of an array, found 3 at most"}),
    test::name_of);

TEST(VtuFiles, DeepNestingIsRefused) {
  const test::TestFiles files;
  std::string deep = "<VTKFile type=\"UnstructuredGrid\">";
  for (int k = 0; k < 300000; ++k) deep += "<a>";
  EXPECT_EQ(files.message([&] { read_document(files.write("a.vtu", deep)); }),
            "a.vtu:1: tags are nested more than 64 deep");
}

}  // namespace
}  // namespace tetproof
