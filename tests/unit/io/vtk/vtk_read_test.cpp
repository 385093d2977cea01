// SPDX-License-Identifier: GPL-3.0-or-later
// Reads both formats of VTK: text and bytes written by hand, and samples of other programs. For files that
// VTK itself writes see tests/programs/vtk_files.py.
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "io/mesh_files.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/vtk/vtu_text.hpp"

namespace tetproof {
namespace {

using test::piece;
using test::vtu;

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
  // A strip, a polyline of two segments, two vertices in one cell, a pentagon. Cell data are in the order of
  // the kinds, not in the file's order.
  EXPECT_EQ(
      read_text(files, "a.vtk",
                "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
                "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n"
                "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nLINES 1 4\n3 0 1 2\nVERTICES 1 3\n2 3 4\n"
                "POLYGONS 1 6\n5 0 1 2 3 4\nCELL_DATA 4\nSCALARS group int\nLOOKUP_TABLE default\n1 2 3 4\n"),
      four_points +
          "n 4 1 1 1\ne 0 15 0/0 g1 p: 3\ne 1 15 0/0 g1 p: 4\ne 2 1000 1/0 g2 p: 0 1 2\n"
          "e 3 34 2/0 g3 p: 0 1 2 3 4\ne 4 2 2/0 g4 p: 0 1 2\ne 5 2 2/0 g4 p: 2 1 3\n");
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
  // The 96 bytes of 12 values in two blocks; a number lies in both. Big-endian, with a header of 32 bits.
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

TEST(VtkFiles, SamplesOfOtherPrograms) {
  const auto folder = std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared" / "formats";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  // Gmsh wrote the same mesh as .msh and as .vtk: 62 nodes, 189 elements.
  const Document msh = read_document(folder / "gmsh484_out/two41all.msh"),
                 vtk = read_document(folder / "gmsh484_out/g.vtk");
  ASSERT_EQ(vtk.points.size(), msh.points.size());
  EXPECT_EQ(vtk.elements(), 189U);
  EXPECT_EQ(tet_mesh(vtk).tets.size(), 158U);
  EXPECT_EQ(vtk.title, "two41, Created by Gmsh");
  std::set<std::int64_t> volumes;
  for (const ElementBlock& block : vtk.blocks)
    if (block.dim == 3) volumes.insert(block.entity);
  EXPECT_EQ(volumes, (std::set<std::int64_t>{11, 12}));  // groups, if Gmsh has any
  const Document tetgen = read_document(folder / "tetgen150_out/cube_attr.1.vtk");
  EXPECT_EQ(tet_mesh(tetgen).tets,
            (std::vector<std::array<Index, 4>>{
                {0, 3, 7, 2}, {0, 7, 4, 6}, {5, 0, 4, 6}, {0, 7, 6, 2}, {5, 0, 6, 1}, {6, 0, 2, 1}}));
  EXPECT_TRUE(tetgen.element_values.empty());  // its regions are groups
  for (const ElementBlock& block : tetgen.blocks)
    EXPECT_EQ(tetgen.tag_sets.at(static_cast<std::size_t>(block.groups)), std::vector<std::int64_t>{2});
}

}  // namespace
}  // namespace tetproof
