// SPDX-License-Identifier: GPL-3.0-or-later
// Polyhedra in both formats of VTK, and in the two ways in which XML files list their faces.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/refused_file.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/vtk/legacy_text.hpp"
#include "tests/unit/io/vtk/there_and_back.hpp"
#include "tests/unit/io/vtk/vtu_text.hpp"

namespace tetproof {
namespace {

using test::expect_back;
using test::legacy;
using test::losses_in_words;
using test::points4;
using test::RefusedFile;
using test::vtu;

const std::string four_points = "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\nn 3 0 0 1\n";

// Four points with a polyhedron, a tetrahedron and a polyhedron; their faces as VTK 9.4 and later list them,
// and `more` in <Cells>.
std::string by_four_arrays(const std::string& corners = "0 2 1 0 1 3 1 2 3 0 3 2",
                           const std::string& face_ends = "3 6 9 12",
                           const std::string& faces = "0 1 2 3 3 2 1 0", const std::string& ends = "4 4 8",
                           const std::string& more = "") {
  const auto array = [](const char* name, const std::string& numbers) {
    return fmt::format("<DataArray type=\"Int64\" Name=\"{}\">{}</DataArray>", name, numbers);
  };
  return vtu(
      "<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\"><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n<Cells>" +
          array("connectivity", "0 1 2 3 0 1 2 3 0 1 2 3") + array("types", "42 10 42") +
          array("offsets", "4 8 12") + array("face_connectivity", corners) +
          array("face_offsets", face_ends) + array("polyhedron_to_faces", faces) +
          array("polyhedron_offsets", ends) + more + "</Cells></Piece>",
      "version=\"2.3\"");
}

TEST(VtkPolyhedra, OfBothFormats) {
  const test::TestFiles files;
  // The tetrahedron by its faces, twice: with the same faces, and with another order of corners.
  const std::string faces = "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2";
  const Document document = read_document(files.write(
      "a.vtk", legacy(points4 + "CELLS 4 59\n17 " + faces + "\n4 0 1 2 3\n17 " + faces +
                      "\n17 4 3 0 1 2 3 0 1 3 3 1 2 3 3 0 3 2\nCELL_TYPES 4\n42 10 42 42\nCELL_DATA 4\n"
                      "SCALARS a int\nLOOKUP_TABLE default\n1 2 3 4\n")));
  EXPECT_EQ(test::text_of(document, false),
            four_points +
                "e 0 35 3/0 g p: 0 2 1 3\ne 1 4 3/0 g p: 0 1 2 3\ne 2 35 3/0 g p: 0 2 1 3\n"
                "e 3 35 3/0 g p: 0 1 2 3\nv elements a 1: 1 2 3 4\n");
  EXPECT_TRUE(document.dropped.empty());
  ASSERT_EQ(document.blocks.size(), 4U);
  EXPECT_EQ(document.blocks[0].faces,
            (std::vector<std::int32_t>{3, 0, 1, 2, 3, 0, 2, 3, 3, 2, 1, 3, 3, 0, 3, 1}));
  expect_back(files, "b.vtk", document);
  expect_back(files, "b.vtu", document);
  // The other formats have none; Gmsh's polyhedra are something else. The file keeps them for us.
  EXPECT_EQ(losses_in_words("b.mesh", document),
            "polyhedra of 4 nodes (type 35): 3 (element 0)\nvalues \"a\" of elements: 4 (1)\n");
  write_document(files.path("b.msh"), document);
  const Document back = read_document(files.path("b.msh"));
  EXPECT_EQ(test::text_of(back, false), test::text_of(document, false));
  ASSERT_EQ(back.blocks.size(), 4U);
  EXPECT_EQ(back.blocks[3].faces, document.blocks[3].faces);
}

TEST(VtkPolyhedra, AsNewerVtkListsTheirFaces) {
  const test::TestFiles files;
  const Document document = read_document(files.write("a.vtu", by_four_arrays()));
  EXPECT_EQ(test::text_of(document, false),
            four_points + "e 0 35 3/0 g p: 0 2 1 3\ne 1 4 3/0 g p: 0 1 2 3\ne 2 35 3/0 g p: 0 3 2 1\n");
  EXPECT_TRUE(document.dropped.empty());
  ASSERT_EQ(document.blocks.size(), 3U);
  EXPECT_EQ(document.blocks[0].faces,
            (std::vector<std::int32_t>{3, 0, 1, 2, 3, 0, 2, 3, 3, 2, 1, 3, 3, 0, 3, 1}));
  EXPECT_EQ(document.blocks[2].faces,  // 0 3 2, 1 2 3, 0 1 3, 0 2 1
            (std::vector<std::int32_t>{3, 0, 1, 2, 3, 3, 2, 1, 3, 0, 3, 1, 3, 0, 2, 3}));
  expect_back(files, "b.vtu", document);
  expect_back(files, "b.vtk", document);
  const Document both = read_document(
      files.write("c.vtu", by_four_arrays("0 2 1 0 1 3 1 2 3 0 3 2", "3 6 9 12", "0 1 2 3 3 2 1 0", "4 4 8",
                                          "<DataArray type=\"Int64\" Name=\"faces\">1 1 0</DataArray>")));
  EXPECT_EQ(test::text_of(both, false), test::text_of(document, false));
  ASSERT_EQ(both.dropped.size(), 1U);
  EXPECT_EQ(both.dropped[0].item, "\"faces\" of cells that have \"face_connectivity\"");
}

// In a legacy file the faces stand for the nodes.
TEST(VtkPolyhedra, NodesThatNoFaceNamesAreLostInLegacyFiles) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.vtu", by_four_arrays("0 2 1 0 1 2", "3 6", "0 1 0 1", "2 2 4")));
  ASSERT_EQ(document.blocks.size(), 3U);
  EXPECT_EQ(document.blocks[0].nodes_each, 4);
  expect_back(files, "b.vtu", document);
  EXPECT_EQ(losses_in_words("b.vtk", document),
            "nodes between the corners of polyhedra of 4 nodes (type 35): 2 (element 0)\n");
}

class VtkPolyhedraErrors : public testing::TestWithParam<RefusedFile> {};

TEST_P(VtkPolyhedraErrors, HaveOneLineWithThePlace) {
  test::expect_refusal(GetParam());
}

// A face of 2000 corners that each of 2000 polyhedra would have ten times.
std::string many_of_a_face() {
  std::string corners, faces;
  for (int k = 0; k < 2000; ++k) corners += "0 ";
  for (int k = 0; k < 2000; ++k) faces += "0 ";
  return by_four_arrays(corners, "2000", faces, "2000 2000 2000");
}

INSTANTIATE_TEST_SUITE_P(
    ByHand, VtkPolyhedraErrors,
    testing::Values(
        RefusedFile{"NoSuchFace", "a.vtu", by_four_arrays("0 2 1", "3", "0 1", "1 1 2"),
                    "a.vtu:5: cell 2: expected one of 1 face, found 1"},
        RefusedFile{"OffsetOfAFace", "a.vtu", by_four_arrays("0 2 1", "4", "0 0", "1 1 2"),
                    "a.vtu:5: face 0: expected an offset from 0 to 3, found 4"},
        RefusedFile{"OffsetOfAPolyhedron", "a.vtu", by_four_arrays("0 2 1", "3", "0 0", "1 0 2"),
                    "a.vtu:5: cell 1: expected a polyhedron offset from 1 to 2, found 0"},
        RefusedFile{"NumberOfPolyhedra", "a.vtu", by_four_arrays("0 2 1", "3", "0 0", "1 2"),
                    "a.vtu:5: expected 3 values of \"polyhedron_offsets\", found 2"},
        RefusedFile{
            "FacesOfVeryManyCells", "a.vtu", many_of_a_face(),
            "a.vtu:5: cell 0: expected faces of one or two cells each, found more than 17024 corners for "
            "2000 numbers"}),
    test::name_of);

}  // namespace
}  // namespace tetproof
