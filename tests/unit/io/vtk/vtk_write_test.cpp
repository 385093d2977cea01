// SPDX-License-Identifier: GPL-3.0-or-later
// Writes both formats of VTK: everything comes back equal, and other programs can read it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

// Everything that both formats hold, and doubles that are easily damaged.
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

// VTK's writer gives every file this title, so that a file of VTK's loses nothing on its way to other
// formats.
TEST(VtkFiles, TheTitleThatVtkMakesUpIsNone) {
  const test::TestFiles files;
  std::string text =
      "# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
      "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  Document document = read_document(files.write("a.vtk", text));
  EXPECT_EQ(document.title, "");
  for (const char* to : {"b.vtu", "b.mesh", "b.vtk"})
    EXPECT_TRUE(losses(files.path(to), document).empty()) << to;
  text.replace(text.find("vtk output"), 10, "vtk outputs");
  EXPECT_EQ(read_document(files.write("a.vtk", text)).title, "vtk outputs");
  document.title = "vtk output";  // of another format: it would not come back
  EXPECT_EQ(losses(files.path("b.vtk"), document).size(), 1U);
}

// Padding inside an array's base64 stops Python's decoder ("Incorrect padding" since Python 3.13).
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
  document.node_values.push_back({.name = "u", .reals = {1}, .at = {1}});  // the other node is written as nan
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

}  // namespace
}  // namespace tetproof
