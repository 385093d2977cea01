// SPDX-License-Identifier: GPL-3.0-or-later
// Files that break the grammar of a surface format: the whole text of each message.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Case {
  std::string name;
  std::string file;
  std::string bytes;
  std::string message;

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::string all_endings =
    ".msh .node .ele .face .edge .neigh .vol .mtr .var .t2f .t2e .f2e .cell .poly .smesh .vtu .vtk .mesh "
    ".meshb "
    ".stl .off .obj .ply; through Gmsh .geo .geo_unrolled .step .stp .iges .igs .brep .brp .unv .bdf .nas "
    ".dat "
    ".diff .p3d .ply2 .wrl .pos .med .cgns .sat .x_t";
const std::string stl_start = "solid x\nfacet normal 0 0 1\nouter loop\n";
const std::string stl_vertices = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
const std::string off_points = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string obj_points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string ply_start = "ply\nformat ascii 1.0\n";
const std::string ply_vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply_text = ply_start + ply_vertex + ply_face + "0 0 0\n1 0 0\n0 1 0\n";
const std::string ply_binary =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char "
    "z\n"
    "element face 1\nproperty list char char vertex_indices\nend_header\n";  // 166 bytes

std::string binary_stl(char count, std::size_t size) {
  std::string bytes(size, '\0');
  bytes.replace(0, 7, "solid x");
  bytes[80] = count;
  for (std::size_t i = 84; i < size; ++i) bytes[i] = '\x7f';  // numbers near the largest float
  return bytes;
}

// A binary OFF with these integers behind its keyword.
std::string binary_off(std::initializer_list<unsigned char> integers) {
  std::string bytes = "OFF BINARY\n";
  for (const unsigned char integer : integers) bytes.append(3, '\0').append(1, static_cast<char>(integer));
  return bytes;
}

const std::vector<Case> cases{
    {"StlNothing", "a.stl", "", "a.stl:1: expected 'solid', found the end of the file"},
    {"StlOther", "a.stl", "\nnothing\n", "a.stl:2: expected 'solid', found 'nothing'"},
    {"StlTwoVertices", "a.stl", stl_start + "vertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
     "a.stl:6: facet has 2 vertices, expected 3"},
    {"StlFourVertices", "a.stl", stl_start + stl_vertices + "vertex 1 1 1\nendloop\nendfacet\n",
     "a.stl:8: facet has 4 vertices, expected 3"},
    {"StlNoOuter", "a.stl", "solid\nfacet normal 0 0 1\ninner loop\n",
     "a.stl:3: expected 'outer loop', found 'inner'"},
    {"StlNoLoop", "a.stl", "solid\nfacet normal 0 0 1\nouter\nvertex 0 0 0\n",
     "a.stl:4: expected 'loop', found 'vertex'"},
    {"StlBadNumber", "a.stl", stl_start + "vertex 0 0,5 0\n", "a.stl:4: expected a coordinate, found '0,5'"},
    {"StlMissingNumber", "a.stl", stl_start + "vertex 0 0\nvertex 1 0 0\n",
     "a.stl:5: expected a coordinate, found 'vertex'"},
    {"StlCutInVertex", "a.stl", stl_start + "vertex 0 0",
     "a.stl:4: expected a coordinate, found the end of the file"},
    {"StlCutInFacet", "a.stl", stl_start + stl_vertices,
     "a.stl:7: expected 'vertex' or 'endloop', found the end of the file"},
    {"StlNoEndloop", "a.stl", stl_start + stl_vertices + "endfacet\n",
     "a.stl:7: expected 'vertex' or 'endloop', found 'endfacet'"},
    {"StlNoEndfacet", "a.stl", stl_start + stl_vertices + "endloop\nendsolid\n",
     "a.stl:8: expected 'endfacet', found 'endsolid'"},
    {"StlJunk", "a.stl", "solid\nendsolid\njunk\nfacet\n",
     "a.stl:3: expected 'facet', 'endsolid' or 'solid', found 'junk'"},
    {"StlUnprintable", "a.stl", "\x01\x7f\xff" + std::string(60, 'y'),
     "a.stl:1: expected 'solid', found '\\x01\\x7F\\xFF" + std::string(37, 'y') + "...'"},
    {"StlBinaryCut", "a.stl", binary_stl(2, 183),
     "a.stl: byte 80: expected 184 bytes for the 2 facets announced here, found 183"},
    {"StlBinaryLong", "a.stl", binary_stl(2, 234),
     "a.stl: byte 80: expected 184 bytes for the 2 facets announced here, found 234"},
    {"StlBinaryCutToBlocks", "a.stl", binary_stl(3, 184),
     "a.stl: byte 80: expected 234 bytes for the 3 facets announced here, found 184"},

    {"OffNothing", "a.off", "", "a.off:1: expected OFF or the number of vertices, found the end of the file"},
    {"OffOther", "a.off", "# x\nsolid\n", "a.off:2: expected OFF or the number of vertices, found 'solid'"},
    {"OffFour", "a.off", "4OFF\n1 0 0\n0 0 0 0\n",
     "a.off:1: expected three coordinates a vertex, found 4OFF"},
    {"OffMany", "a.off", "STnOFF\n5\n", "a.off:1: expected three coordinates a vertex, found STnOFF"},
    {"OffBinaryNothing", "a.off", "OFF BINARY\n",
     "a.off: byte 11: expected the number of vertices (4 bytes), found 0 bytes and the end of the file"},
    {"OffBinaryHuge", "a.off", std::string("OFF BINARY\n\x7f\0\0\0\0\0\0\0", 19),
     "a.off: byte 11: expected the number of vertices, found 2130706432, which the 4 bytes left cannot hold"},
    {"OffBinaryVertexTooLarge", "a.off", binary_off({0, 1, 0, 3, 0, 1, 2, 0}),
     "a.off: byte 23: face names vertex 0, but there are no vertices"},
    {"OffBinaryCut", "a.off", binary_off({0, 1, 0, 1, 0}),
     "a.off: byte 31: expected the number of a colour's components (4 bytes), found 0 bytes and the end of "
     "the "
     "file"},
    {"OffNoCounts", "a.off", "OFF\n", "a.off:2: expected the number of vertices, found the end of the file"},
    {"OffBadCount", "a.off", "OFF 4.5 1 0\n", "a.off:1: expected the number of vertices, found '4.5'"},
    {"OffNegativeCount", "a.off", "OFF -4 1 0\n", "a.off:1: expected the number of vertices, found -4"},
    {"OffHugeVertices", "a.off", "OFF 2000000000 1 0\n0 0 0\n",
     "a.off:1: expected the number of vertices, found 2000000000, more than the 11 bytes left can hold"},
    {"OffHugeFaces", "a.off", "OFF 1 9223372036854775807 0\n0 0 0\n",
     "a.off:1: expected the number of faces, found 9223372036854775807, more than the 9 bytes left can hold"},
    {"OffCountTooLarge", "a.off", "OFF 9223372036854775808 1 0\n",
     "a.off:1: expected the number of vertices, found '9223372036854775808'"},
    {"OffBadEdges", "a.off", "OFF 1 1 x\n0 0 0\n", "a.off:1: expected the number of edges, found 'x'"},
    {"OffBadCoordinate", "a.off", "OFF 1 0 0\n0 zero 0\n", "a.off:2: expected a coordinate, found 'zero'"},
    {"OffShortVertex", "a.off", "OFF 2 0 0\n0 0\n1 1 1\n",
     "a.off:2: expected a coordinate, found the end of the line"},
    {"OffShortFace", "a.off", off_points + "3 0 1\n\n",
     "a.off:7: expected a vertex, found the end of the line"},
    {"OffCutInFace", "a.off", off_points + "3 0 1", "a.off:7: expected a vertex, found the end of the file"},
    {"OffJunkAfterVertex", "a.off", "OFF 1 0 0\n0 0 0 red\n",
     "a.off:2: expected a number or the end of the line, found 'red'"},
    {"OffJunkAfterFace", "a.off", off_points + "3 0 1 2 red\n",
     "a.off:7: expected a number or the end of the line, found 'red'"},
    {"OffVertexTooLarge", "a.off", off_points + "3 0 1 4\n", "a.off:7: face names vertex 4, expected 0 to 3"},
    {"OffVertexNegative", "a.off", off_points + "3 0 -1 2\n",
     "a.off:7: face names vertex -1, expected 0 to 3"},
    {"OffNoVertices", "a.off", "OFF 0 1 0\n3 0 1 2\n",
     "a.off:2: face names vertex 0, but there are no vertices"},
    {"OffHugeCorner", "a.off", off_points + "3 0 1 99999999999999999999\n",
     "a.off:7: expected a vertex, found '99999999999999999999'"},
    {"OffHugeFace", "a.off", off_points + "300000000 0 1 2\n",
     "a.off:7: expected the number of a face's corners, found 300000000, more than the 7 bytes left can "
     "hold"},
    {"OffTwoCorners", "a.off", off_points + "2 0 1\n", "a.off:7: face has 2 corners, expected at least 3"},
    {"OffNoCorners", "a.off", off_points + "0\n", "a.off:7: face has 0 corners, expected at least 3"},
    {"OffFaceMissing", "a.off", off_points,
     "a.off:7: expected the number of a face's corners, found the end of the file"},
    {"OffCrossed", "a.off", "OFF 4 1 0\n0 0 0\n2 0 0\n0 2 0\n0.5 -0.5 0\n4 0 1 2 3\n",
     "a.off:6: face with 4 corners crosses itself"},
    {"OffPolygonNotFinite", "a.off", "OFF 4 1 0\n0 0 0\n1 0 0\nnan 1 0\n0 1 0\n4 0 1 2 3\n",
     "a.off:6: face with 4 corners has a coordinate that is not finite or too large"},
    {"OffCr", "a.off", "OFF\r4 1 0\r0 0 0\r1 0 0\rx", "a.off:5: expected a coordinate, found 'x'"},
    {"OffCrLf", "a.off", "OFF\r\n4 1 0\r\n0 0 0\r\n1 0 0\r\nx", "a.off:5: expected a coordinate, found 'x'"},

    {"ObjNothingKnown", "a.obj", "# x\nw 0 0 0\nx\n",
     "a.obj:2: expected a statement of OBJ (v, f, ...), found 'w'"},
    {"ObjFreeFormAlone", "a.obj", obj_points + "surf 0 1 0 1 1 2 3 4\n",
     "a.obj: expected a surface, found no triangles or polygons"},
    {"ObjBadCoordinate", "a.obj", "v 0 0 o\n", "a.obj:1: expected a coordinate, found 'o'"},
    {"ObjShortVertex", "a.obj", "\nv 0 0\nv 1 1 1\n", "a.obj:2: expected 3 coordinates, found fewer"},
    {"ObjJunkAfterVertex", "a.obj", "v 0 0 0 red\n",
     "a.obj:1: expected a number or the end of the line, found 'red'"},
    {"ObjTwoCorners", "a.obj", obj_points + "f 1// 2//\n",
     "a.obj:5: face has 2 corners, expected at least 3"},
    {"ObjVertexTooLarge", "a.obj", obj_points + "f 1 2 5\n", "a.obj:5: face names vertex 5, expected 1 to 4"},
    {"ObjVertexHuge", "a.obj", obj_points + "f 1 2 9223372036854775807\n",
     "a.obj:5: face names vertex 9223372036854775807, expected 1 to 4"},
    {"ObjVertexZero", "a.obj", obj_points + "f 0 1 2\n",
     "a.obj:5: expected a vertex as in 7, 7/1, 7//3, 7/1/3 or -1, found '0'"},
    {"ObjVertexTooFarBack", "a.obj", obj_points + "f 1 2 -5\nv 2 2 2\n",
     "a.obj:5: face names vertex -5, but only 4 stand above it"},
    {"ObjVertexFarthestBack", "a.obj", obj_points + "f 1 2 -9223372036854775808\n",
     "a.obj:5: face names vertex -9223372036854775808, but only 4 stand above it"},
    {"ObjNoVertices", "a.obj", "f 1 2 3\n", "a.obj:1: face names vertex 1, but there are no vertices"},
    {"ObjBadCorner", "a.obj", obj_points + "f 1 2 3/x\n",
     "a.obj:5: expected a vertex as in 7, 7/1, 7//3, 7/1/3 or -1, found '3/x'"},
    {"ObjCornerOfFour", "a.obj", obj_points + "f 1 2 3/1/1/1\n",
     "a.obj:5: expected a vertex as in 7, 7/1, 7//3, 7/1/3 or -1, found '3/1/1/1'"},
    {"ObjCrossedAcrossLines", "a.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv .5 -.5 0\nf 1 2 \\\n 3 4\n",
     "a.obj:5: face with 4 corners crosses itself"},

    {"PlyNothing", "a.ply", "", "a.ply:1: expected 'ply', found the end of the file"},
    {"PlyOther", "a.ply", "PLY\n", "a.ply:1: expected 'ply', found 'PLY'"},
    {"PlyNoFormat", "a.ply", "ply\nelement vertex 0\nend_header\n",
     "a.ply:3: expected a line 'format' in the header, found none"},
    {"PlyBadFormat", "a.ply", "ply\nformat utf8 1.0\n",
     "a.ply:2: expected ascii, binary_little_endian or binary_big_endian, found 'utf8'"},
    {"PlyBadVersion", "a.ply", "ply\nformat ascii 2.0\n", "a.ply:2: expected version 1.0, found '2.0'"},
    {"PlyBadLine", "a.ply", ply_start + "elements vertex 3\n",
     "a.ply:3: expected 'format', 'element', 'property', 'comment' or 'end_header', found 'elements'"},
    {"PlyEarlyProperty", "a.ply", ply_start + "property float x\n",
     "a.ply:3: expected 'format', 'element', 'property', 'comment' or 'end_header', found 'property'"},
    {"PlyBadType", "a.ply", ply_start + "element vertex 1\nproperty real x\n",
     "a.ply:4: expected a type (char, uchar, short, ushort, int, uint, float, double), found 'real'"},
    {"PlyBadCount", "a.ply", ply_start + "element vertex many\n",
     "a.ply:3: expected the number of elements, found 'many'"},
    {"PlyNegativeCount", "a.ply", ply_start + "element vertex -1\n",
     "a.ply:3: expected the number of elements, found -1"},
    {"PlyWordTooMany", "a.ply", ply_start + "element vertex 3 4\n",
     "a.ply:3: expected the end of the line, found '4'"},
    {"PlyTwice", "a.ply", ply_start + "element vertex 3\nelement vertex 3\n",
     "a.ply:4: expected each element once, found 'vertex'"},
    {"PlyNoEnd", "a.ply", ply_start + ply_vertex,
     "a.ply:7: expected 'format', 'element', 'property', 'comment' or 'end_header', found the end of the "
     "file"},
    {"PlyNoVertex", "a.ply", ply_start + "end_header\n",
     "a.ply: expected an element 'vertex' in the header, found none"},
    {"PlyNoZ", "a.ply",
     ply_start + "element vertex 3\nproperty float x\nproperty float y\nproperty list int int z\n" + ply_face,
     "a.ply: expected a property 'z' of element 'vertex' in the header, found none"},
    {"PlyNoFace", "a.ply", ply_start + ply_vertex + "end_header\n0 0 0\n1 0 0\n0 1 0\n",
     "a.ply: expected an element 'face' with a list 'vertex_indices' or 'vertex_index' in the header, found "
     "none"},
    {"PlyHugeVertices", "a.ply",
     ply_start + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n" +
         ply_face + "0 0 0\n",
     "a.ply:10: element 'vertex' announces 4000000000 of at least 6 bytes, more than the 6 bytes left can "
     "hold"},
    {"PlyHugeList", "a.ply", ply_text + "3000000000 0 1 2\n",
     "a.ply:13: list 'vertex_indices' announces 3000000000 entries, more than the 7 bytes left can hold"},
    {"PlyNegativeList", "a.ply", ply_text + "-3 0 1 2\n",
     "a.ply:13: expected the number of entries of a list, found -3"},
    {"PlyBrokenList", "a.ply", ply_text + "2.5 0 1 2\n",
     "a.ply:13: expected the number of entries of a list, found 2.5"},
    {"PlyNanList", "a.ply", ply_text + "nan 0 1 2\n",
     "a.ply:13: expected the number of entries of a list, found nan"},
    {"PlyBadNumber", "a.ply", ply_text + "3 0 1 two\n", "a.ply:13: expected a number, found 'two'"},
    {"PlyBrokenVertex", "a.ply", ply_text + "3 0 1 1.5\n", "a.ply:13: expected a vertex, found 1.5"},
    {"PlyVertexTooLarge", "a.ply", ply_text + "3 0 1 3\n", "a.ply:13: face names vertex 3, expected 0 to 2"},
    {"PlyTwoCorners", "a.ply", ply_text + "2 0 1\n", "a.ply:13: face has 2 corners, expected at least 3"},
    {"PlyNumberTooMany", "a.ply", ply_text + "3 0 1 2 0\n",
     "a.ply:13: expected the end of the line, found '0'"},
    {"PlyShortVertex", "a.ply", ply_start + ply_vertex + ply_face + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
     "a.ply:11: expected a number, found the end of the line"},
    {"PlyShortFace", "a.ply", ply_text + "3 0 1\n\n",
     "a.ply:13: expected a number, found the end of the line"},
    {"PlyCut", "a.ply", ply_text + "3 0 1", "a.ply:13: expected a number, found the end of the file"},
    {"PlyBinaryVertexTooLarge", "a.ply", ply_binary + std::string("\0\0\0\1\0\0\0\1\0\3\0\1\3", 13),
     "a.ply: byte 175: face names vertex 3, expected 0 to 2"},
    {"PlyBinaryCut", "a.ply", ply_binary + std::string("\0\0\0\1\0\0\0\1\0\3\0\1", 12),
     "a.ply: byte 176: list 'vertex_indices' announces 3 entries, more than the 2 bytes left can hold"},
    {"PlyBinaryCutInVertices", "a.ply", ply_binary + std::string("\0\0\0\1\0\0\0\1", 8),
     "a.ply: byte 166: element 'vertex' announces 3 of at least 3 bytes, more than the 8 bytes left can "
     "hold"},
    {"PlyBinaryNegativeList", "a.ply", ply_binary + std::string("\0\0\0\1\0\0\0\1\0\xfd\0\1\2", 13),
     "a.ply: byte 176: expected the number of entries of a list, found -3"},

    {"StlNoFacets", "a.stl", "solid\nendsolid\n",
     "a.stl: expected a surface, found no triangles or polygons"},
    {"OffNoFaces", "a.off", "OFF 1 0 0\n0 0 0\n",
     "a.off: expected a surface, found no triangles or polygons"},
    {"PlyNoFaces", "a.ply",
     ply_start + "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 0\nproperty list uchar uint vertex_indices\nend_header\n",
     "a.ply: expected a surface, found no triangles or polygons"},
    {"UnknownEnding", "a.surf", "nothing\n",
     "a.surf: unknown ending, and the content tells no format; expected one of " + all_endings},
    {"NoEnding", "surface", "",
     "surface: no ending, and the content tells no format; expected one of " + all_endings},
};

class SurfaceErrors : public testing::TestWithParam<Case> {};

TEST_P(SurfaceErrors, Message) {
  const test::TestFiles files;
  const std::string path = files.write(GetParam().file, GetParam().bytes);
  EXPECT_EQ(files.message([&] { read_surface(path); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceErrors, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

TEST(SurfaceErrors, NoFile) {
  const test::TestFiles files;
  EXPECT_EQ(files.message([&] { read_surface(files.path("none.off")); }),
            "none.off: cannot open: No such file or directory");
}

TEST(SurfaceErrors, Folder) {
  const test::TestFiles files;
  std::filesystem::create_directory(files.path("a.off"));
  EXPECT_EQ(files.message([&] { read_surface(files.path("a.off")); }), "a.off: cannot read: Is a directory");
}

}  // namespace
}  // namespace tetproof
