// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files of several pieces: structured grids, whose pieces have places in the whole, and arrays that
// go on from piece to piece.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/vtk/vtu_text.hpp"

namespace tetproof {
namespace {

using test::piece;
using test::vtu;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;

// An array of text; `type` "String" has the codes of characters.
std::string array(const std::string& name, const std::string& values, const std::string& type = "Int32") {
  return fmt::format("<{0} type=\"{1}\" Name=\"{2}\">{3}</{0}>", type == "String" ? "Array" : "DataArray",
                     type, name, values);
}

std::string cell_data(const std::string& arrays) {
  return "<CellData>" + arrays + "</CellData>";
}

struct Part {
  std::string extent, of_points, of_cells;
};
std::string image(const std::string& whole, const std::vector<Part>& parts) {
  std::string text = "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"" + whole +
                     "\" Origin=\"0 0 0\" Spacing=\"1 1 1\">";
  for (const Part& part : parts)
    text += "<Piece Extent=\"" + part.extent + "\"><PointData>" + part.of_points + "</PointData>" +
            cell_data(part.of_cells) + "</Piece>";
  return text + "</ImageData></VTKFile>";
}

std::vector<std::string> dropped(const Document& document) {
  std::vector<std::string> lines;
  for (const Loss& loss : document.dropped)
    lines.push_back(fmt::format("{}: {} ({})", loss.item, loss.count, loss.example));
  return lines;
}

// The points of a row of squares, and the squares.
const std::string points_of_two = "n 0 0 0 0\nn 1 1 0 0\nn 2 2 0 0\nn 3 0 1 0\nn 4 1 1 0\nn 5 2 1 0\n",
                  two_squares = "e 0 3 2/0 g p: 0 1 4 3\ne 1 3 2/0 g p: 1 2 5 4\n",
                  points_of_three =
                      "n 0 0 0 0\nn 1 1 0 0\nn 2 2 0 0\nn 3 3 0 0\nn 4 0 1 0\nn 5 1 1 0\nn 6 2 1 "
                      "0\nn 7 3 1 0\n",
                  three_squares = "e 0 3 2/0 g p: 0 1 5 4\ne 1 3 2/0 g p: 1 2 6 5\ne 2 3 2/0 g p: 2 3 7 6\n";

TEST(VtkPieces, OfAStructuredGridShareTheirPoints) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vti", image("0 2 0 1 0 0", {{"0 1 0 1 0 0", array("p", "0 1 10 11"), array("material", "0")},
                                     {"1 2 0 1 0 0", array("p", "1 2 11 12"), array("material", "7")}})));
  EXPECT_EQ(test::text_of(document, false),
            points_of_two + "e 0 3 2/0 g p: 0 1 4 3\ne 1 3 2/0 g7 p: 1 2 5 4\nv nodes p 1: 0 1 2 10 11 12\n");
  EXPECT_THAT(dropped(document), ElementsAre("division into pieces: 1 (2 pieces)"));
  EXPECT_THAT(
      document.warnings,
      ElementsAre(EndsWith("2 pieces of a structured grid of 3 x 2 x 1 points, kept as 2 quadrangles")));
}

// The order in the file is not that of the grid. Hexahedra, with the texts and reals of their cells.
TEST(VtkPieces, OfAStructuredGridStandWhereTheirExtentSays) {
  const test::TestFiles files;
  const auto part = [&](int z, const char* real, const char* text) {
    return Part{fmt::format("0 1 0 1 {} {}", z, z + 1), "",
                array("r", real, "Float64") + array("s", text, "String")};
  };
  const Document document = read_document(
      files.write("a.vti", image("0 1 0 1 4 6", {part(5, "0.5", "98 0"), part(4, "0.25", "97 0")})));
  EXPECT_EQ(test::text_of(document, false),
            "n 0 0 0 4\nn 1 1 0 4\nn 2 0 1 4\nn 3 1 1 4\nn 4 0 0 5\nn 5 1 0 5\nn 6 0 1 5\nn 7 1 1 5\n"
            "n 8 0 0 6\nn 9 1 0 6\nn 10 0 1 6\nn 11 1 1 6\n"
            "e 0 5 3/0 g p: 0 1 3 2 4 5 7 6\ne 1 5 3/0 g p: 4 5 7 6 8 9 11 10\n"
            "v elements r 1: 0.25 0.5\nv elements s 1: 0 1\n");
  EXPECT_THAT(document.element_values.at(1).labels, ElementsAre("a", "b"));
}

TEST(VtkPieces, TheFirstOfAPointCountsAndOthersAreListed) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vti", image("0 3 0 1 0 0", {{"0 2 0 1 0 0", array("p", "1 2 3 4 5 6"), array("c", "1 2")},
                                     {"1 3 0 1 0 0", array("p", "2 13 14 5 6 16"), array("c", "12 13")}})));
  EXPECT_EQ(test::text_of(document, false),
            points_of_three + three_squares + "v nodes p 1: 1 2 3 14 4 5 6 16\nv elements c 1: 1 2 13\n");
  EXPECT_THAT(dropped(document),
              ElementsAre("points that differ from those of another piece: 1 (index 2 0 0 of piece 1)",
                          "cells that differ from those of another piece: 1 (index 1 0 0 of piece 1)",
                          "division into pieces: 1 (2 pieces)"));
}

TEST(VtkPieces, GhostsGiveWayToTheirOriginals) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vti", image("0 2 0 1 0 0", {{"0 2 0 1 0 0", "", array("c", "1 9") + array("vtkGhostType", "0 1")},
                                     {"1 2 0 1 0 0", "", array("c", "2") + array("vtkGhostType", "0")}})));
  EXPECT_EQ(test::text_of(document, false),
            points_of_two + two_squares + "v elements c 1: 1 2\nv elements vtkGhostType 1: 0 0\n");
}

TEST(VtkPieces, CellsBetweenPiecesAreListedWhereTheyHaveNoData) {
  const test::TestFiles files;
  const auto grid = [&](const std::string& one, const std::string& other) {
    return read_document(
        files.write("a.vti", image("0 3 0 1 0 0", {{"0 1 0 1 0 0", "", one}, {"2 3 0 1 0 0", "", other}})));
  };
  EXPECT_EQ(test::text_of(grid("", ""), false), points_of_three + three_squares);
  const Document document = grid(array("c", "1"), array("c", "3"));
  EXPECT_EQ(test::text_of(document, false),
            points_of_three + "e 0 3 2/0 g p: 0 1 5 4\ne 1 3 2/0 g p: 2 3 7 6\nv elements c 1: 1 3\n");
  EXPECT_THAT(dropped(document), ElementsAre("cells between pieces, without data: 1 (index 1 0 0)",
                                             "division into pieces: 1 (2 pieces)"));
  EXPECT_TRUE(document.dropped.at(0).elements);
}

TEST(VtkPieces, ArraysThatAPieceLacksAreListed) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.vti", image("0 2 0 1 0 0", {{"0 1 0 1 0 0", array("p", "1 2 3 4") + array("q", "5 6 7 8"), ""},
                                     {"1 2 0 1 0 0", array("r", "1 1 1 1") + array("q", "6 9 8 9"), ""}})));
  EXPECT_EQ(test::text_of(document, false), points_of_two + two_squares + "v nodes q 1: 5 6 9 7 8 9\n");
  EXPECT_THAT(dropped(document), ElementsAre("values of arrays that a piece lacks: 8 (\"p\" of piece 0)",
                                             "division into pieces: 1 (2 pieces)"));
}

TEST(VtkPieces, PointsOfTheWholeThatNoPieceHasAreSaid) {
  const test::TestFiles files;
  const Document document = read_document(
      files.write("a.vti", image("0 9 0 1 0 0", {{"0 1 0 1 0 0", "", ""}, {"4 5 0 1 0 0", "", ""}})));
  EXPECT_EQ(document.points.size(), 8u);
  EXPECT_EQ(document.elements(), 2u);
  EXPECT_THAT(
      document.warnings,
      ElementsAre(EndsWith("2 pieces of a structured grid of 6 x 2 x 1 points, kept as 2 quadrangles; the "
                           "pieces have 8 of its points")));
}

TEST(VtkPieces, TextsGoOn) {
  const test::TestFiles files;
  const auto of = [](const std::string& codes) { return piece(cell_data(array("s", codes, "String"))); };
  const Document document =
      read_document(files.write("a.vtu", vtu(of("97 98 0") + of("99 0") + of("97 98 0"))));
  ASSERT_EQ(document.element_values.size(), 1u);
  EXPECT_THAT(document.element_values[0].integers, ElementsAre(0, 1, 0));
  EXPECT_THAT(document.element_values[0].labels, ElementsAre("ab", "c"));
  for (const char* name : {"b.vtu", "b.vtk"}) {
    EXPECT_THAT(losses(files.path(name), document), IsEmpty());
    write_document(files.path(name), document);
    EXPECT_THAT(read_document(files.path(name)).element_values.at(0).labels, ElementsAre("ab", "c"));
  }
}

// Parallel programs write such pieces. They have arrays without values.
TEST(VtkPieces, WithoutPointsOrCellsAddNothing) {
  const test::TestFiles files;
  const auto full = piece("<PointData>" + array("p", "1 2 3 4") + "</PointData>" +
                          cell_data(array("q", "5") + array("r", "1.5", "Float64") +
                                    array("s", "97 0", "String") + array("material", "3")));
  const std::string empty = "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"><Points/><Cells>" +
                            array("connectivity", "") + array("offsets", "") + array("types", "", "UInt8") +
                            "</Cells><PointData>" + array("p", "") + "</PointData>" +
                            cell_data(array("q", "") + array("r", "", "Float64") + array("s", "", "String") +
                                      array("material", "")) +
                            "</Piece>";
  for (const std::string& pieces : {empty + full, full + empty, empty + full + empty}) {
    const Document document = read_document(files.write("a.vtu", vtu(pieces)));
    EXPECT_EQ(test::text_of(document, false),
              "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\ne 0 4 3/0 g3 p: 0 1 2 3\nv nodes p 1: 1 2 3 4\n"
              "v elements q 1: 5\nv elements r 1: 1.5\nv elements s 1: 0\n");
    EXPECT_THAT(document.element_values.at(2).labels, ElementsAre("a"));
    EXPECT_THAT(losses(files.path("b.vtu"), document), IsEmpty());
  }
  const Document between = read_document(files.write("a.vtu", vtu(full + empty + full)));
  ASSERT_EQ(between.element_values.size(), 3u);
  EXPECT_THAT(between.element_values[0].integers, ElementsAre(5, 5));
  EXPECT_THAT(between.element_values[1].reals, ElementsAre(1.5, 1.5));
}

// Zeros in one piece say nothing: another tells whether they are tags.
TEST(VtkPieces, TagsAreTagsInAllPieces) {
  const test::TestFiles files;
  const auto of = [](const std::string& values, const std::string& type) {
    return piece(cell_data(array("material", values, type)));
  };
  const Document tags = read_document(files.write("a.vtu", vtu(of("0", "Int32") + of("7", "Int32"))));
  EXPECT_THAT(tags.element_values, IsEmpty());
  ASSERT_EQ(tags.blocks.size(), 2u);
  EXPECT_THAT(tags.tag_sets.at(static_cast<std::size_t>(tags.blocks[0].groups)), IsEmpty());
  EXPECT_THAT(tags.tag_sets.at(static_cast<std::size_t>(tags.blocks[1].groups)), ElementsAre(7));
  EXPECT_EQ(tags.group_word, "material");
  const Document mixed = read_document(files.write("a.vtu", vtu(of("7", "Int32") + of("7.5", "Float64"))));
  EXPECT_EQ(mixed.element_values.size(), 2u);
  write_document(files.path("b.vtu"), mixed);
  const Document back = read_document(files.path("b.vtu"));
  EXPECT_EQ(back.element_values.size(), 2u);
  for (const Document& document : {mixed, back})
    for (const ElementBlock& block : document.blocks) EXPECT_EQ(block.groups, 0);
}

}  // namespace
}  // namespace tetproof
