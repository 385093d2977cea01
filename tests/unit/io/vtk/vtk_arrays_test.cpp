// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays in both formats of VTK: bits, large integers, texts, packings, and their names.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4.h>
#include <lzma.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/binary_bytes.hpp"
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
using test::tet;
using test::vtu;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(VtkArrays, Bits) {
  const test::TestFiles files;
  // Ten bits, the highest of a byte first, as VTK 9.1 writes them: two bytes behind their number.
  const std::string points =
      "<Points><DataArray type=\"Int8\" NumberOfComponents=\"3\">" +
      [] {
        std::string numbers;
        for (int i = 0; i < 10; ++i) numbers += fmt::format("{} 0 0 ", i);
        return numbers;
      }() +
      "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\"/><DataArray "
      "type=\"Int8\" Name=\"types\"/><DataArray type=\"Int32\" Name=\"offsets\"/></Cells>";
  const std::string bits[] = {"<DataArray type=\"Bit\" Name=\"b\">1 0 0 1 1 0 0 0 0 1</DataArray>",
                              "<DataArray type=\"Bit\" Name=\"b\" format=\"binary\">AgAAAJhA</DataArray>"};
  for (const std::string& array : bits) {
    const Document document =
        read_document(files.write("a.vtu", vtu("<Piece NumberOfPoints=\"10\" NumberOfCells=\"0\">" + points +
                                               "<PointData>" + array + "</PointData></Piece>")));
    ASSERT_EQ(document.node_values.size(), 1U);
    EXPECT_EQ(document.node_values[0].integers, (std::vector<std::int64_t>{1, 0, 0, 1, 1, 0, 0, 0, 0, 1}));
    EXPECT_TRUE(document.dropped.empty());
  }
  const Document field = read_document(
      files.write("a.vtu", vtu("<FieldData><DataArray type=\"Bit\" Name=\"b\" NumberOfTuples=\"3\" "
                               "format=\"binary\">AQAAAKA=</DataArray></FieldData>" +
                               piece())));
  ASSERT_EQ(field.tables.size(), 1U);
  EXPECT_EQ(field.tables[0].columns[0].integers, (std::vector<std::int64_t>{1, 0, 1}));
}

// All integers of 64 bits without a sign, in text as in binary.
TEST(VtkArrays, LargeIntegersInText) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vtk", legacy(tet + "CELL_DATA 1\nFIELD FieldData 2\nu 2 1 vtktypeuint64\n9223372036854775808 7\n"
                            "v 1 1 unsigned_long\n18446744073709551615\n")));
  ASSERT_EQ(document.element_values.size(), 2U);
  EXPECT_EQ(document.element_values[0].integers,
            (std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), 7}));
  EXPECT_EQ(document.element_values[1].integers, std::vector<std::int64_t>{-1});
  ASSERT_EQ(document.dropped.size(), 1U);
  EXPECT_EQ(document.dropped[0].item, "integers of 2^63 or more, kept as negative ones");
  EXPECT_EQ(document.dropped[0].count, 2);
}

// Texts stay texts if their numbers are in another order, or if some of them are used no more.
TEST(VtkArrays, TextsOfWhatIsLeft) {
  const test::TestFiles files;
  Document document = read_document(files.write(
      "a.vtu",
      vtu(piece("<PointData><Array type=\"String\" Name=\"m\">97 0 98 0 97 0 99 0</Array></PointData>"))));
  document.node_values.at(0).integers = {2, 2, 0, 2};
  for (const char* name : {"b.vtu", "b.vtk"}) {
    EXPECT_EQ(losses_in_words(files.path(name), document), "");
    write_document(files.path(name), document);
    const Document back = read_document(files.path(name));
    EXPECT_EQ(back.node_values.at(0).labels, (std::vector<std::string>{"c", "a"}));
    EXPECT_EQ(back.node_values[0].integers, (std::vector<std::int64_t>{0, 0, 1, 0}));
  }
}

TEST(VtkArrays, TextsOfSignedCharacters) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vtu", vtu(piece("<CellData><Array type=\"String\" Name=\"m\">-61 -92 0</Array></CellData>"))));
  ASSERT_EQ(document.element_values.size(), 1U);
  EXPECT_EQ(document.element_values[0].labels, std::vector<std::string>{"\xC3\xA4"});
  expect_back(files, "b.vtu", document);
  expect_back(files, "b.vtk", document);
  EXPECT_EQ(read_document(files.path("b.vtk")).element_values[0].labels, document.element_values[0].labels);
}

// An array of `size` zeros as VTK packs it, in one block that claims `claimed` bytes.
std::string packed_file(const std::string& compressor, const std::string& block, std::uint64_t claimed) {
  std::string data;
  for (const std::uint64_t n : {std::uint64_t{1}, claimed, std::uint64_t{0}, std::uint64_t{block.size()}})
    test::append(data, n, std::endian::little);
  return "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\" compressor=\"" + compressor +
         "\"><UnstructuredGrid><FieldData><DataArray type=\"UInt8\" Name=\"zeros\" format=\"appended\" "
         "offset=\"0\"/></FieldData><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/></UnstructuredGrid>"
         "<AppendedData encoding=\"raw\">\n_" +
         data + block + "\n</AppendedData></VTKFile>";
}

std::string lz4(const std::string& plain) {
  std::string packed(static_cast<std::size_t>(LZ4_compressBound(static_cast<int>(plain.size()))), '\0');
  packed.resize(static_cast<std::size_t>(LZ4_compress_default(
      plain.data(), packed.data(), static_cast<int>(plain.size()), static_cast<int>(packed.size()))));
  return packed;
}

std::string xz(const std::string& plain) {
  std::string packed(lzma_stream_buffer_bound(plain.size()), '\0');
  std::size_t size = 0;
  EXPECT_EQ(lzma_easy_buffer_encode(6, LZMA_CHECK_CRC32, nullptr,
                                    reinterpret_cast<const std::uint8_t*>(plain.data()), plain.size(),
                                    reinterpret_cast<std::uint8_t*>(packed.data()), &size, packed.size()),
            LZMA_OK);
  packed.resize(size);
  return packed;
}

TEST(VtkArrays, Lz4AndLzma) {
  const test::TestFiles files;
  const std::string zeros(3'000'000, '\0');
  const std::pair<std::string, std::string> all[] = {{"vtkLZ4DataCompressor", lz4(zeros)},
                                                     {"vtkLZMADataCompressor", xz(zeros)}};
  for (const auto& [compressor, block] : all) {
    const Document document =
        read_document(files.write("a.vtu", packed_file(compressor, block, zeros.size())));
    ASSERT_EQ(document.tables.size(), 1U);
    EXPECT_EQ(document.tables[0].columns[0].integers.size(), zeros.size());
    const auto message = [&](const std::string& text) {
      return files.message([&] { read_document(files.write("b.vtu", text)); });
    };
    const std::string name = compressor == "vtkLZ4DataCompressor" ? "LZ4" : "LZMA";
    // Less or more than it claims, a damaged block, and a claim that no block of this size can meet.
    for (const std::uint64_t claimed : {zeros.size() - 1, zeros.size() + 1})
      EXPECT_NE(message(packed_file(compressor, block, claimed)).find("bytes compressed by " + name),
                std::string::npos)
          << name << claimed;
    std::string broken = block;
    for (char& c : broken) c = static_cast<char>(c ^ 0x5A);
    EXPECT_NE(message(packed_file(compressor, broken, zeros.size()))
                  .find("compressed by " + name + ", found other"),
              std::string::npos);
    EXPECT_NE(message(packed_file(compressor, block, std::uint64_t{1} << 60))
                  .find("the size of a compressed block"),
              std::string::npos);
  }
}

// Only entities are written as integers under this name.
TEST(VtkArrays, RealsWithTheNameOfEntitiesStayReals) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.vtk", legacy(tet)));
  document.element_values.push_back({.name = "CellEntityIds", .reals = {0.5}});
  EXPECT_THAT(losses(files.path("b.vtk"), document), IsEmpty());
  write_document(files.path("b.vtk"), document);
  EXPECT_THAT(read_document(files.path("b.vtk")).element_values.at(0).reals, ElementsAre(0.5));
}

// VTK 9.1 crashes at two arrays of one name.
TEST(VtkArrays, NoTwoArraysHaveOneName) {
  const test::TestFiles files;
  Document document = read_document(
      files.write("a.vtk", legacy(tet + "CELL_DATA 1\nSCALARS gmsh:physical int\nLOOKUP_TABLE default\n7\n"
                                        "SCALARS entity int\nLOOKUP_TABLE default\n3\n")));
  for (const char* name : {"gmsh:physical", "gmsh:geometrical", "CellEntityIds", "gmsh:physical"})
    document.element_values.push_back({.name = name, .reals = {0.5}});
  const auto count = [&](const char* file, const std::string& name) {
    write_document(files.path(file), document, {.binary = false});
    const std::string text = test::TestFiles::read(files.path(file));
    int found = 0;
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  for (const char* name : {"\"gmsh:physical\"", "\"gmsh:physical #2\"", "\"gmsh:physical #3\"",
                           "\"gmsh:geometrical\"", "\"gmsh:geometrical #2\"", "\"CellEntityIds\""})
    EXPECT_EQ(count("b.vtu", name), 1) << name;
  for (const char* name : {"gmsh:physical 1 ", "gmsh:physical%20#2 1", "gmsh:geometrical 1",
                           "CellEntityIds int", "CellEntityIds%20#2 1"})
    EXPECT_EQ(count("b.vtk", name), 1) << name;
  EXPECT_EQ(losses(files.path("b.vtu"), document).at(0).count, 3);
}

}  // namespace
}  // namespace tetproof
