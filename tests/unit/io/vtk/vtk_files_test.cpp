// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's files, both formats, by hand. Files that VTK itself writes: tests/programs/vtk_files.py.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/refused_file.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

std::string read_text(const test::TestFiles& files, const std::string& name, const std::string& bytes) {
  return test::text_of(read_document(files.write(name, bytes)), false);
}

const std::string four_points = "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\n";

TEST(VtkFiles, LegacyText) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.vtk",
                                "# vtk DataFile Version 2.0\r\nmy title\nASCII\n"
                                "dataset UNSTRUCTURED_GRID\n"
                                "FIELD FieldData 1\nTIME 1 1 double\n2.5\n"
                                "POINTS 4 float\n0 0 0 1 0 0\n0 1 0  0 0 1\n"
                                "CELLS 3 14\n4 0 1 2 3 3 0 1 9\n4 0 2 1 3\n"
                                "CELL_TYPES 3\n10 5 10\n"
                                "CELL_DATA 3\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n7 8 -7\n"
                                "POINT_DATA 4\nSCALARS a%20b double\nLOOKUP_TABLE mine\n1 2 3 0.1\n"
                                "LOOKUP_TABLE mine 1\n0 1 0.5 1\n"
                                "METADATA\nINFORMATION 0\n\n"
                                "VECTORS v float\n1 2 3 4 5 6 7 8 9 10 11 12\n"
                                "FIELD more 1\ni 2 4 long\n1 2 3 4 5 6 7 8\n"));
  EXPECT_EQ(document.title, "my title");
  EXPECT_EQ(test::text_of(document, false),
            four_points +
                "e 0 4 3/7 g p: 0 1 2 3\ne 1 2 2/8 g p: 0 1 ?9\ne 2 4 3/-7 g p: 0 2 1 3\n"
                "v nodes a b 1: 1 2 3 0.1\nv nodes v 3: 1 2 3 4 5 6 7 8 9 10 11 12\n"
                "v nodes i 2: 1 2 3 4 5 6 7 8\n");
  ASSERT_EQ(document.tables.size(), 2U);
  EXPECT_EQ(document.tables[0].name, "TIME");
  EXPECT_EQ(document.tables[0].columns[0].reals, std::vector<double>{2.5});
  EXPECT_EQ(document.tables[1].columns[0].integers, (std::vector<std::int64_t>{0, 255, 128, 255}));
}

TEST(VtkFiles, LegacyPolygonalData) {
  const test::TestFiles files;
  // A strip, a line of two pieces, two vertices in one cell, a pentagon; cell data by kind, not as listed.
  EXPECT_EQ(
      read_text(files, "a.vtk",
                "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
                "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n"
                "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nLINES 1 4\n3 0 1 2\nVERTICES 1 3\n2 3 4\n"
                "POLYGONS 1 6\n5 0 1 2 3 4\nCELL_DATA 4\nSCALARS group int\nLOOKUP_TABLE default\n1 2 3 4\n"),
      four_points +
          "n 4 1 1 1\ne 0 15 0/0 g1 p: 3\ne 1 15 0/0 g1 p: 4\ne 2 1 1/0 g2 p: 0 1\ne 3 1 1/0 g2 p: 1 2\n"
          "e 4 34 2/0 g3 p: 0 1 2 3 4\ne 5 2 2/0 g4 p: 0 1 2\ne 6 2 2/0 g4 p: 2 1 3\n");
}

TEST(VtkFiles, Version51InBinary) {
  const test::TestFiles files;
  std::string bytes = "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n";
  const auto add = [&](auto value) { test::append(bytes, value, std::endian::big); };
  for (const double x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) add(x);
  bytes += "\nCELLS 2 4\nOFFSETS vtktypeint64\n";
  for (const std::int64_t i : {0, 4}) add(i);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t i : {0, 1, 2, 3}) add(i);
  bytes += "\nCELL_TYPES 1\n";
  add(std::int32_t{10});
  bytes += "\nPOINT_DATA 4\nCOLOR_SCALARS c 1\n\x01\x20\x0a\xff\nFIELD FieldData 1\nbits 1 4 bit\n\xa0\n";
  EXPECT_EQ(read_text(files, "a.vtk", bytes),
            four_points + "e 0 4 3/0 g p: 0 1 2 3\nv nodes c 1: 1 32 10 255\nv nodes bits 1: 1 0 1 0\n");
}

std::string vtu(const std::string& piece, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<!-- <VTKFile> -->\n<VTKFile type=\"UnstructuredGrid\" " + attributes +
         ">\n<UnstructuredGrid>" + piece + "</UnstructuredGrid></VTKFile>\n";
}

std::string piece(const std::string& more = "", const std::string& nodes = "0 1 2 3") {
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\" "
         "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
         "<DataArray type=\"Int32\" Name=\"connectivity\">" +
         nodes +
         "</DataArray><DataArray type=\"Int8\" Name=\"types\">10</DataArray>"
         "<DataArray type=\"UInt64\" Name=\"offsets\" format=\"ascii\">4</DataArray></Cells>" +
         more + "</Piece>";
}

TEST(VtuFiles, PiecesOneAfterTheOther) {
  const test::TestFiles files;
  const std::string shared = "<DataArray type=\"Int16\" Name=\"a&lt;&#10;b\">-3</DataArray>",
                    own = "<DataArray type=\"Float64\" Name=\"own\">0.1</DataArray>";
  const Document document =
      read_document(files.write("a.vtu", vtu(piece("<CellData>" + shared + "</CellData>") +
                                             piece("<CellData>" + own + shared + "</CellData>"))));
  EXPECT_EQ(test::text_of(document, false),
            four_points +
                "n 4 0 0 0\nn 5 1 0 0\nn 6 0 1 0\nn 7 0 0 1\ne 0 4 3/0 g p: 0 1 2 3\ne 1 4 3/0 g p: 4 5 6 7\n"
                "v elements a<\nb 1: -3 -3\nv elements own 1 at 1: 0.1\n");
  EXPECT_EQ(document.element_values[1].first, 1U);
}

TEST(VtuFiles, CompressedAndAppendedRaw) {
  const test::TestFiles files;
  // Two blocks of 12 values' 96 bytes, the border inside of a number; big-endian, header of 32 bits.
  std::string values;
  for (const double x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) test::append(values, x, std::endian::big);
  const auto packed = [](const std::string& plain) {
    std::string to(200, '\0');
    uLongf size = to.size();
    ::compress(reinterpret_cast<Bytef*>(to.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
               plain.size());
    return to.substr(0, size);
  };
  const std::string first = packed(values.substr(0, 50)), second = packed(values.substr(50));
  std::string data;
  for (const std::size_t n : {std::size_t{2}, std::size_t{50}, std::size_t{46}, first.size(), second.size()})
    test::append(data, static_cast<std::uint32_t>(n), std::endian::big);
  data += first + second;
  const std::string text =
      "<VTKFile type=\"UnstructuredGrid\" byte_order=\"BigEndian\" compressor=\"vtkZLibDataCompressor\">"
      "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"0\"><Points><DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" format=\"appended\" "
      "offset=\"3\"/></Points><Cells/></Piece></UnstructuredGrid>"
      "<AppendedData encoding=\"raw\">\n _<&>" +
      data + "\n</AppendedData></VTKFile>";
  EXPECT_EQ(read_text(files, "a.vtu", text), four_points);
  std::string broken = text;
  broken[broken.find(second) + 8] ^= 0x55;
  EXPECT_NE(
      files.message([&] { read_document(files.write("b.vtu", broken)); }).find("bytes compressed by zlib"),
      std::string::npos);
}

using test::RefusedFile;

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
        RefusedFile{"Structured", "a.vtk", "# vtk DataFile Version 2.0\n\nASCII\nDATASET STRUCTURED_POINTS\n",
                    "a.vtk:4: expected UNSTRUCTURED_GRID or POLYDATA, found 'STRUCTURED_POINTS'"},
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
        RefusedFile{"OtherType", "a.vtu", "<VTKFile type=\"PolyData\"></VTKFile>",
                    "a.vtu:1: expected VTK's type UnstructuredGrid, found 'PolyData'"},
        RefusedFile{"TagsCross", "a.vtu", "<VTKFile type=\"UnstructuredGrid\">\n<a></b>\n</VTKFile>",
                    "a.vtu:2: expected XML: Start-end tags mismatch"},
        RefusedFile{
            "NotZlib", "a.vtu", vtu("", "compressor=\"vtkLZ4DataCompressor\""),
            "a.vtu:3: data compressed by vtkLZ4DataCompressor, expected vtkZLibDataCompressor or none"},
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

// All that both formats hold, and doubles that are easily lost.
TEST(VtkFiles, RoundTrips) {
  Document document;
  document.title = "a title";
  document.points = {{0, -0.0, 5e-324}, {0.1 + 0.2, 1e300, 1.0 / 3}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1},
                     {2, 1, 1}};
  document.tag_sets = {{}, {3}, {-4, 3, 9}};
  document.blocks = {
      {.type = 4, .dim = 3, .entity = 5, .groups = 2, .nodes_each = 4, .count = 1},
      {.type = 34, .dim = 2, .entity = -2, .groups = 1, .nodes_each = 5, .count = 1, .first = 1, .nodes = 4},
      {.type = 6, .dim = 3, .entity = 5, .nodes_each = 6, .count = 1, .first = 2, .nodes = 9}};
  document.connectivity = {0, 1, 2, 3, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5};
  document.first_node = document.first_element = 0;
  document.node_values.push_back(
      {.name = "r \"1\"%", .components = 2, .reals = {1, -0.0, 0.1, 5e-324, 3, 4, 5, 6, 7, 8, 9, 1e22}});
  document.element_values.push_back(
      {.name = "i", .integers = {1, -2, std::numeric_limits<std::int64_t>::min()}});
  document.tables.push_back(
      {"words", 2, {{.name = "words", .type = "String", .texts = {"one two", std::string(70, 'x')}}}});
  document.tables.push_back(
      {"n", 1, {{.name = "n", .type = "UInt8", .components = 2, .integers = {0, 255}}}});
  const test::TestFiles files;
  for (const char* name : {"a.vtk", "a.vtu"})
    for (const bool binary : {false, true}) {
      const std::string path = files.path(name);
      if (std::string(name) == "a.vtu") document.title.clear();
      EXPECT_TRUE(losses(path, document, {.binary = binary}).empty());
      write_document(path, document, {.binary = binary});
      const Document back = read_document(path);
      EXPECT_EQ(test::text_of(back, false), test::text_of(document, false)) << name << binary;
      EXPECT_EQ(back.title, document.title);
      ASSERT_EQ(back.tables.size(), 2U);
      EXPECT_EQ(back.tables[0].columns[0].texts, document.tables[0].columns[0].texts);
      EXPECT_EQ(back.tables[1].columns[0].integers, document.tables[1].columns[0].integers);
      EXPECT_EQ(back.tables[1].columns[0].type, "UInt8");
      EXPECT_TRUE(std::signbit(back.points[0].y()));
    }
}

// Padding inside the base64 of an array stops Python's decoder: "Incorrect padding" since Python 3.13.
TEST(VtuFiles, Base64IsPaddedAtItsEndOnly) {
  const test::TestFiles files;
  for (int cells = 0; cells < 7; ++cells) {
    std::string text = "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" +
                       std::string("0 0 0 1 0 0 0 1 0 0 0 1\nCELLS ") + std::to_string(cells) + " " +
                       std::to_string(5 * cells) + "\n";
    for (int i = 0; i < cells; ++i) text += "4 0 1 2 3\n";
    text += "CELL_TYPES " + std::to_string(cells) + "\n";
    for (int i = 0; i < cells; ++i) text += "10\n";
    if (cells > 0) text += "CELL_DATA " + std::to_string(cells) + "\n";
    for (const char* type : {"char", "short", "float", "long"}) {
      if (cells == 0) break;
      text += "SCALARS " + std::string(type) + " " + type + " 1\nLOOKUP_TABLE default\n";
      for (int i = 0; i < cells; ++i) text += std::to_string(7 * i - 3) + "\n";
    }
    const Document document = read_document(files.write("a.vtk", text));
    write_document(files.path("a.vtu"), document, {.binary = true});
    const std::string written = test::TestFiles::read(files.path("a.vtu"));
    std::size_t arrays = 0;
    for (std::size_t at = 0; (at = written.find("format=\"binary\">", at)) != std::string::npos; ++arrays) {
      at = written.find('>', at) + 1;
      const std::string base64 = written.substr(at, written.find('<', at) - at);
      const std::size_t padding = base64.find('=');
      EXPECT_EQ(base64.find_first_not_of("=\n", std::min(padding, base64.size())), std::string::npos)
          << base64;
    }
    EXPECT_EQ(arrays, cells == 0 ? 4U : 8U);
    EXPECT_EQ(test::text_of(read_document(files.path("a.vtu")), false), test::text_of(document, false));
  }
}

TEST(VtkFiles, SaysWhatVtkItselfMisreads) {
  Document document;
  document.points = {{0, 0, 0}, {1, 0, 0}};
  document.node_values.push_back({.name = "u", .reals = {1}, .at = {1}});  // the other node gets nan
  const std::string misread =
      "a.vtk: point data \"u\" has nan or inf, which VTK itself reads in binary, but not in text, where it "
      "misreads all that follows";
  const std::string vtk_text = write_warning("a.vtk", document, {.binary = false});
  EXPECT_EQ(vtk_text, misread);
  EXPECT_EQ(write_warning("a.vtk", document), "");
  EXPECT_EQ(write_warning("a.vtu", document, {.binary = false}), "");
  document.node_values[0] = {.name = "u", .reals = {1, -std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(write_warning("a.vtk", document, {.binary = false}), misread);
  EXPECT_EQ(write_warning("a.vtu", document, {.binary = false}),
            "a.vtu: point data \"u\" has -inf, which VTK itself reads in text as inf");
  EXPECT_EQ(write_warning("a.vtu", document), "");
  document.node_values.clear();
  EXPECT_EQ(write_warning("a.vtk", document, {.binary = false}), "");
  document.points[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(write_warning("a.vtk", document, {.binary = false}).substr(0, 27), "a.vtk: a point has nan or i");
}

TEST(VtkFiles, SamplesOfOtherPrograms) {
  const auto folder = std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared" / "formats";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  // What Gmsh wrote as .msh and as .vtk is the same mesh: 62 nodes, 189 elements.
  const Document msh = read_document(folder / "gmsh484_out/two41all.msh"),
                 vtk = read_document(folder / "gmsh484_out/g.vtk");
  ASSERT_EQ(vtk.points.size(), msh.points.size());
  EXPECT_EQ(vtk.elements(), 189U);
  EXPECT_EQ(tet_mesh(vtk).tets.size(), 158U);
  EXPECT_EQ(vtk.title, "two41, Created by Gmsh");
  std::set<std::int64_t> volumes;
  for (const ElementBlock& block : vtk.blocks)
    if (block.dim == 3) volumes.insert(block.entity);
  EXPECT_EQ(volumes, (std::set<std::int64_t>{11, 12}));  // groups, where Gmsh has any
  const Document tetgen = read_document(folder / "tetgen150_out/cube_attr.1.vtk");
  EXPECT_EQ(tet_mesh(tetgen).tets,
            (std::vector<std::array<Index, 4>>{
                {0, 3, 7, 2}, {0, 7, 4, 6}, {5, 0, 4, 6}, {0, 7, 6, 2}, {5, 0, 6, 1}, {6, 0, 2, 1}}));
  ASSERT_EQ(tetgen.element_values.size(), 1U);
  EXPECT_EQ(tetgen.element_values[0].integers, std::vector<std::int64_t>(6, 2));
}

}  // namespace
}  // namespace tetproof
