// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of Medit, Gmsh, TetGen, STL, OFF and PLY files drop, kind by kind. For VTK see
// vtk/vtk_dropped_test.cpp.
#include <bit>
#include <cstdint>

#include "io/surface_files.hpp"
#include "tests/support/binary_bytes.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/dropped_files.hpp"

namespace tetproof {
namespace {

using Case = test::DroppedFiles;
class Dropped : public testing::TestWithParam<Case> {};

TEST_P(Dropped, IsListed) {
  test::expect_dropped(GetParam());
}

const auto name_of = [](const auto& test) { return test.param.name; };

// Medit's files.

const std::string mesh =
    "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 "
    "3 4 7\n";

// A .meshb with one vertex and the keyword `code`, whose data are these numbers.
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
     {{"a.meshb", meshb(11, {1, 1})}},
     {"keyword of code 11: 1 (byte 68: 8 bytes)"}},
    {"BinaryKeywordOfAnotherForm",
     {{"a.meshb", meshb(60, {0, 9})}},
     {"keyword Normals: 1 (byte 68: 8 bytes)"}},
    {"BytesBehindNumbers",
     {{"a.meshb", meshb(5, {1, 1, 1, 0, 9, 9})}},
     {"bytes behind the numbers of Edges: 8 (byte 84)"}},
    {"BytesBehindTheEnd", {{"a.meshb", meshb(5, {0}, "xyz")}}, {"bytes behind End: 3 (byte 80)"}},
    {"NothingOfAMark", {{"a.meshb", meshb(15, {1, 1})}}, {}},
    {"NothingOfMmgsMark", {{"a.meshb", meshb(12, {1, 1})}}, {}}};

INSTANTIATE_TEST_SUITE_P(Medit, Dropped, testing::ValuesIn(of_medit), name_of);

// Surfaces.

const std::string off = "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n",
                  ply_properties = "property char x\nproperty char y\nproperty char z\n",
                  ply_faces = "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n",
                  ply_text = "ply\nformat ascii 1.0\nelement vertex 3\n" + ply_properties + ply_faces +
                             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                  ply_binary = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + ply_properties +
                               ply_faces + std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13);

const std::vector<Case> of_surfaces{
    {"OffNothing", {{"a.off", off + "\n# the end\n"}}, {}},
    {"OffLines",
     {{"a.off", off + "3 0 2 3\n# more\nend\n"}},
     {"lines behind the faces that are announced: 2 (line 8: 3 0 2 3)"}},
    {"OffNoNumbers",
     {{"a.off", off + "end\n"}},
     {"lines behind the faces that are announced: 1 (line 8: end)"}},
    {"OffFaceOverLinesIsNone", {{"a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2\n3\n"}}, {}},
    {"StlColours",
     {{"a.stl",
       "solid a\ncolor 0.1 0.2 0.3\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nendsolid a\nsolid b\nCOLOR 1 0 0\nendsolid b\n"}},
     {"colours of solids: 2 (line 2: color 0.1 0.2 0.3)"}},
    {"PlyNothing", {{"a.ply", ply_text + "\n \n"}}, {}},
    {"PlyLines", {{"a.ply", ply_text + "3 2 1 0\nend\n"}}, {"lines behind the last element: 2 (line 14)"}},
    {"PlyBytes", {{"a.ply", ply_binary + "xy"}}, {"bytes behind the last element: 2 (byte 181)"}}};

INSTANTIATE_TEST_SUITE_P(Surfaces, Dropped, testing::ValuesIn(of_surfaces), name_of);

// A face that is not read is an element which the surface lacks; a remark is none.
TEST(LinesBehindASurface, MayBeElements) {
  const test::TestFiles files;
  const auto elements = [&](const char* name, const std::string& bytes) {
    const Document document = read_document(files.write(name, bytes));
    EXPECT_EQ(document.elements(), 1u) << bytes;
    return document.dropped.at(0).elements;
  };
  EXPECT_TRUE(elements("a.off", off + "3 0 2 3\n"));
  EXPECT_TRUE(elements("a.ply", ply_text + "3 2 1 0\n"));
  EXPECT_FALSE(elements("a.ply", ply_text + "end\n"));
  EXPECT_TRUE(elements("a.ply", ply_binary + std::string("\3\2\1\0", 4)));
  EXPECT_FALSE(elements("a.ply", ply_binary + "xy"));
}

// VTK and meshio read faces of two corners. A surface has no such faces.
TEST(Ply, HasFacesOfTwoCornersAsLines) {
  const test::TestFiles files;
  std::string text = ply_text.substr(0, ply_text.size() - 8) + "2 2 0\n";
  const Document document = read_document(files.write("a.ply", text));
  EXPECT_EQ(test::text_of(document, false), "n 0 0 0 0\nn 1 1 0 0\nn 2 0 1 0\ne 1 1 1/0 g p: 2 0\n");
  EXPECT_EQ(files.message([&] { read_surface(files.path("a.ply")); }),
            "a.ply:13: face has 2 corners, expected at least 3");
}

// Gmsh's files.

const std::string v22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
                  nodes22 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";

std::string elements22(const std::string& lines, int count = 1) {
  return fmt::format("$Elements\n{}\n{}$EndElements\n", count, lines);
}

// Enough elements to be read by several threads.
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

// Text is no element; a section, a number and binary bytes may be some.
TEST(BytesBehindTheLastSection, MayBeElements) {
  const test::TestFiles files;
  const auto elements_in = [&](const std::string& bytes) {
    const Document document =
        read_document(files.write("a.msh", v22 + nodes22 + elements22("1 4 0 1 2 3 4\n") + bytes));
    EXPECT_EQ(document.dropped.size(), 1u) << bytes;
    return !document.dropped.empty() && document.dropped[0].elements;
  };
  for (const std::string text : {"garbage $\n", "written by mesher 1.2 at 10:30\n\n \t# end\n", "costs $5",
                                 "\xC3\xA9t\xC3\xA9\r\n", "-- end --"})
    EXPECT_FALSE(elements_in(text)) << text;
  for (const std::string& bytes :
       {std::string("2 4 0 1 2 3 4\n"), std::string("more $Elements"), std::string("more\n\n +5"),
        std::string("end\n.5"), std::string("x\0\0\0", 4), std::string("2,4,0")})
    EXPECT_TRUE(elements_in(bytes)) << bytes;
  EXPECT_EQ(
      read_document(files.write("a.msh", v22 + nodes22 + elements22("1 4 0 1 2 3 4\n") + " \n\t\r\n\v\f"))
          .dropped.size(),
      0u);
}

TEST(BytesBetweenSections, AreDroppedAndMayBeElements) {
  const test::TestFiles files;
  const std::string more = "$Elements\n1\n2 4 0 1 2 4 3\n$EndElements\n";
  const Document document = read_document(files.write(
      "a.msh", v22 + "// by hand\n" + nodes22 + elements22("1 4 0 1 2 3 4\n") + "costs $5\n\n" + more));
  EXPECT_EQ(document.elements(), 2u);
  ASSERT_EQ(document.dropped.size(), 1u);
  EXPECT_EQ(document.dropped[0].item, "bytes between sections");
  EXPECT_EQ(document.dropped[0].count, 11 + 10);
  EXPECT_FALSE(document.dropped[0].elements);
  const Document numbers = read_document(
      files.write("a.msh", v22 + nodes22 + elements22("1 4 0 1 2 3 4\n") + "7 4 0 1 2 3 4\n" + more));
  EXPECT_EQ(numbers.elements(), 2u);
  EXPECT_TRUE(numbers.dropped.at(0).elements);
}

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

// "Pentahedra" is another name of prisms, so nothing is dropped.
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

TEST(DroppedOfMedit, AKeywordOfUnknownCodeMayBeElements) {
  const test::TestFiles files;
  files.write("unknown.meshb", meshb(11, {1, 2}));
  files.write("normals.meshb", meshb(60, {0, 9}));
  const std::vector<Loss> unknown = read_document(files.path("unknown.meshb")).dropped;
  const std::vector<Loss> normals = read_document(files.path("normals.meshb")).dropped;
  ASSERT_EQ(unknown.size(), 1u);
  ASSERT_EQ(normals.size(), 1u);
  EXPECT_TRUE(unknown[0].elements);
  EXPECT_FALSE(normals[0].elements);
}

}  // namespace
}  // namespace tetproof
