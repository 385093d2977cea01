// SPDX-License-Identifier: GPL-3.0-or-later
// Everything in surface files besides points and triangles: what is read, what is listed as dropped, and that
// it is written and comes back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/surface/surface_document_text.hpp"

namespace tetproof {
namespace {

using test::obj_square;
using test::ply_list;
using test::ply_start;
using test::ply_xyz;
using test::square;
using test::told;

struct Case {
  std::string name, file, bytes, told;
  std::vector<std::string> warnings{};  // without the folder's name
  bool binary = false;                  // the encoding in which it is written again
  std::vector<std::string> dropped{};   // "count item (example)"

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string other_facet =
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";

// A file of one facet with this header and attribute; its normal is along z.
std::string binary_stl(std::string bytes, std::uint16_t attribute, float normal_z = 1) {
  bytes.resize(84 + 50);
  bytes[80] = 1;
  const float numbers[12]{0, 0, normal_z, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::memcpy(bytes.data() + 84, numbers, 48);
  std::memcpy(bytes.data() + 132, &attribute, 2);
  return bytes;
}

std::string announcing(std::uint32_t facets, std::string bytes) {
  for (int k = 0; k < 4; ++k)
    bytes[static_cast<std::size_t>(80 + k)] = static_cast<char>(facets >> 8 * k & 255);
  return bytes;
}

// Turns each number of four bytes behind the first line around.
std::string other_order(std::string bytes) {
  for (std::size_t i = bytes.find('\n') + 1; i + 4 <= bytes.size(); i += 4)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
  return bytes;
}

// Appends numbers of binary OFF, the most significant byte first.
std::string binary_off(std::string bytes, const std::vector<std::uint32_t>& integers) {
  for (const std::uint32_t integer : integers)
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(integer >> shift & 255);
  return bytes;
}
std::string floats(const std::vector<float>& numbers) {
  std::vector<std::uint32_t> bits(numbers.size());
  std::memcpy(bits.data(), numbers.data(), 4 * numbers.size());
  return binary_off("", bits);
}

const std::vector<Case> cases{
    {"StlNameless", "a.stl", "solid\n" + facet + "endsolid\n", "e2: 1 2 3\n"},
    {"StlNamed", "a.stl", "solid left  wing \n" + facet + "endsolid\n",
     "group 2 1 left  wing\ne2 g1: 1 2 3\n"},
    {"StlSolids", "a.stl",
     "solid a\n" + facet + "endsolid\nsolid 7\n" + other_facet + "endsolid\nsolid b #-3\n" + facet,
     "group 2 1 a\ngroup 2 -3 b\ne2 g1: 1 2 3\ne2 g7: 2 4 3\ne2 g-3: 1 2 3\n"},
    {"StlNamelessSolids", "a.stl", "solid\n" + facet + "endsolid\nsolid\n" + other_facet,
     "e2 g1: 1 2 3\ne2 g2: 2 4 3\n"},
    {"StlOneNamelessSolid", "a.stl", "solid\n" + facet + "endsolid\nsolid b\n" + other_facet,
     "group 2 1 b\ne2: 1 2 3\ne2 g1: 2 4 3\n"},
    {"StlBinary",
     "a.stl",
     binary_stl("solid of a CAD   ", 0x7fff),
     "title solid of a CAD\ne2: 1 2 3\nelement attribute x1 i: 32767\n",
     {},
     true},
    {"StlAgainstItsNormal",
     "a.stl",
     "solid\nfacet normal 0 0 -2" + facet.substr(18),
     "e2: 1 2 3\n",
     {},
     false,
     {"1 normals that point against the order of the corners (line 2)"}},
    {"StlBinaryAgainstItsNormal",
     "a.stl",
     binary_stl("", 0, -1),
     "e2: 1 2 3\n",
     {},
     true,
     {"1 normals that point against the order of the corners (byte 84)"}},
    {"StlTrailingBytes",
     "a.stl",
     binary_stl("", 0) + "xy",
     "e2: 1 2 3\n",
     {},
     true,
     {"2 bytes behind the last facet (byte 134)"}},
    {"StlMoreFacetsThanAnnounced",
     "a.stl",
     binary_stl("a CAD", 0) + binary_stl("", 0).substr(84),
     "title a CAD\ne2: 1 2 3\ne2: 1 2 3\n",
     {"a.stl: byte 80: 1 facet is announced, 2 are there"},
     true},
    {"StlFewerFacetsThanAnnounced",
     "a.stl",
     announcing(3, binary_stl("", 0) + std::string(20, '\1')),
     "e2: 1 2 3\n",
     {"a.stl: byte 80: 3 facets are announced, 1 is there"},
     true,
     {"2 facets that are announced but not there (1 of 3 is there)",
      "20 bytes behind the last facet (byte 134)"}},
    {"StlUnknownNumberOfFacets",
     "a.stl",
     announcing(0xFFFFFFFF, binary_stl("", 0)),
     "e2: 1 2 3\n",
     {"a.stl: byte 80: 4294967295 facets are announced, 1 is there"},
     true},
    {"StlMoreBytesThanAnnounced",
     "a.stl",
     binary_stl("", 0) + binary_stl("", 0).substr(84) + "xyz",
     "e2: 1 2 3\n",
     {},
     true,
     {"53 bytes behind the last facet (byte 134)"}},
    {"StlTextBehindTheEnd",
     "a.stl",
     "solid s\n" + facet + "endsolid s\n\nmade by hand, with 1 triangle\n",
     "group 2 1 s\ne2 g1: 1 2 3\n",
     {},
     false,
     {"30 bytes behind the last solid (line 11)"}},
    {"StlEndOfDos",
     "a.stl",
     "solid\r\n" + facet + "endsolid\r\n\x1a",
     "e2: 1 2 3\n",
     {"a.stl: byte 103: ^Z at the end is passed over"}},
    {"StlEndsInTwoWords",
     "a.stl",
     "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nEND Loop\nend "
     "facet\n"
     "end solid s\n",
     "group 2 1 s\ne2 g1: 1 2 3\n",
     {"a.stl: line 7: `end` and its keyword are two words (the first of 3 such)"}},
    {"StlZeroBytes",
     "a.stl",
     "solid\n" + facet + "endsolid\n" + std::string(100, '\0'),
     "e2: 1 2 3\n",
     {"a.stl: byte 101: 100 zero bytes at the end are passed over"}},

    {"OffPolygons", "a.off",
     "OFF\n# a title\n#  of two lines\n5 4 0\n" + square + "2 .5 0\n3 0 1 2\n4 0 1 2 3\n5 0 1 4 2 3\n2 0 1\n",
     "title a title\n of two lines\ne2: 0 1 2\ne3: 0 1 2 3\ne34: 0 1 4 2 3\ne1: 0 1\n"},
    {"OffColours", "a.off",
     "OFF 4 5 0\n" + square + "3 0 1 2 255 0 7\n3 0 2 3 0 0 0\n3 0 1 3 0.5 0.25 1 0.75\n3 1 2 3 9\n3 3 1 2\n",
     "e2: 0 1 2\ne2: 0 2 3\ne2: 0 1 3\ne2: 1 2 3\ne2: 3 1 2\nelement color x1 i: 9 at 3\n"
     "element color x3 i: 255 0 7 0 0 0 at 0 1\nelement color x4: 0.5 0.25 1 0.75 at 2\n"},
    {"OffOfVertices",
     "a.off",
     "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 1 .5 1\n1 0 0 0 1 0 2 3 4 0 0\n0 1 0 1 0 -0 5 6 300 1 1\n3 0 1 2\n",
     "e2: 0 1 2\nnode normal x3: 0 0 1 0 1 0 1 0 -0\nnode color x3 i: 255 0 1 2 3 4 5 6 300\n"
     "node texture x2: 0.5 1 0 0 1 1\n",
     {"a.off: 1 number in colours of vertices is outside of 0 to 255"}},
    {"OffWholeReals", "a.off", "OFF\n3 1 0\n0 0 0 1.0 0 0\n1 0 0 0 0 1\n0 1 0 1 1 1\n3 0 1 2\n",
     "e2: 0 1 2\nnode color x3: 1 0 0 0 0 1 1 1 1\n"},
    {"OffUnknownVertex", "a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n", "e2: 0 1 9\n"},
    {"OffOddNumbers",
     "a.off",
     "OFF 3 1 0\n0 0 0 1\n1 0 0\n0 1 0\n3 0 1 2 5 5\n",
     "e2: 0 1 2\n",
     {},
     false,
     {"1 numbers behind vertices to which OFF gives no meaning (line 2: 0 0 0 1)",
      "1 numbers behind faces to which OFF gives no meaning (line 5: 3 0 1 2 5 5)"}},
    {"OffFacesOverLines",
     "a.off",
     "OFF 4 2 0\n" + square + "3 0 1\n2\n4\n0 1\n2 3\n",
     "e2: 0 1 2\ne3: 0 1 2 3\n",
     {"a.off:6: a face goes on in the next line (the first such)"}},
    {"OffZeroBytes",
     "a.off",
     "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" + std::string(3, '\0'),
     "e2: 0 1 2\n",
     {"a.off: byte 36: 3 zero bytes at the end are passed over"}},
    {"OffBinary",
     "a.off",
     binary_off("STCNOFF BINARY\n", {3, 2, 0}) + floats({0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, .5}) +
         floats({1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0}) + floats({0, 1, 0, 1, 0, 0, 0, 0, 1, .25, 1, 1}) +
         binary_off("", {3, 0, 1, 2, 3}) + floats({1, .5, 0}) + binary_off("", {2, 0, 1, 0}) + "xyz",
     "e2: 0 1 2\ne1: 0 1\nnode normal x3: 0 0 1 0 1 0 1 0 0\nnode color x4: 1 0 0 1 0 1 0 1 0 0 1 0.25\n"
     "node texture x2: 0 0.5 1 0 1 1\nelement color x3: 1 0.5 0 at 0\n",
     {},
     false,
     {"3 bytes behind the last face (byte 219)"}},

    {"OffBinaryOfTheOtherOrder",
     "a.off",
     other_order(binary_off("OFF BINARY\n", {3, 1, 0}) + floats({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                 binary_off("", {3, 0, 1, 2, 0})),
     "e2: 0 1 2\n",
     {"a.off: byte 11: the numbers are little-endian; OFF has big-endian ones"}},
    {"OffEndOfDos",
     "a.off",
     "\xEF\xBB\xBFOFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\x1a\r\n",
     "e2: 0 1 2\n",
     {"a.off: byte 39: ^Z at the end is passed over"}},

    {"ObjGroups", "a.obj",
     "# made by hand\n#\nmtllib a.mtl b.mtl\n" + obj_square +
         "g wing left\nf 1 2 3\ng left 12\nf 1 3 4\ng\nf 2 3 4\ng two%20words\np 1 2\nl 1 2 3\n",
     "title made by hand\n\ngroup 2 1 wing\ngroup 2 2 left\ngroup 0 3 two words\ngroup 1 3 two words\n"
     "e2 g1 g2: 1 2 3\ne2 g2 g12: 1 3 4\ne2: 2 3 4\ne15 g3: 1\ne15 g3: 2\ne1000 g3: 1 2 3\n"
     "table mtllib 2\n  file (text) a.mtl|b.mtl []\n"},
    {"ObjNumbersOfGroups", "a.obj",
     obj_square + "# group 9 tip\n# group -4 root\ng root\nf 1 2 3\ng tip\nf 1 3 4\n",
     "group 2 -4 root\ngroup 2 9 tip\ne2 g-4: 1 2 3\ne2 g9: 1 3 4\n"},
    {"ObjStates", "a.obj",
     obj_square +
         "f 1 2 3\no first part\nusemtl red\ns 3\nf 1 3 4\nusemtl\ns off\nf 2 3 4\nusemtl red\nf 1 2 4\n",
     "e2: 1 2 3\ne2: 1 3 4\ne2: 2 3 4\ne2: 1 2 4\nelement object x1 i: 0 1 1 1 labels [|first part]\n"
     "element material x1 i: 0 1 0 1 labels [|red]\nelement smoothing x1 i: 0 3 0 0\n"},
    {"ObjCorners", "a.obj",
     obj_square + "vt 0 0\nvt 1 .5\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 1 3 4\nf 1//-1 2//-1 4//1\n",
     "e2: 1 2 3\ne2: 1 3 4\ne2: 1 2 4\ncorner texture x2: 0 0 1 0.5 0 0 at 0 nodes 3\n"
     "corner normal x3: 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 at 0 2 nodes 3 3\n"},
    {"ObjColoursAndWeights", "a.obj", "v 0 0 0 0.1 0 1\nv 1 0 0\nv 0 1 0 0.5\nf 1 2 3\n",
     "e2: 1 2 3\nnode weight x1: 0.5 at 2\nnode color x3: 0.1 0 1 at 0\n"},
    {"ObjFreeForm",
     "a.obj",
     obj_square + "vp 0 1\nvp 1 1\ncurv 0 1 1 2\nf 1 2 3 4\nsurf 0 1 0 1 1 2 3 4\n",
     "e3: 1 2 3 4\n",
     {},
     false,
     {"2 statements `vp` (line 5: vp 0 1)", "1 statements `curv` (line 7: curv 0 1 1 2)",
      "1 statements `surf` (line 9: surf 0 1 0 1 1 2 3 4)"}},
    {"ObjUnknownStatements",
     "a.obj",
     "t 0 1\n" + obj_square + "vw 0 1 \\\n 0.5\nf 1 2 3\n",
     "e2: 1 2 3\n",
     {},
     false,
     {"2 statements that OBJ does not have (line 1: t 0 1)"}},
    {"ObjOddNumbers",
     "a.obj",
     "v 0 0 0 1 2\nv 1 0 0\nv 0 1 0\nvt 0 0\ns first\nf 1 2 3\nl 1/1 2/1\n",
     "e2: 1 2 3\ne1: 1 2\n",
     {},
     false,
     {"1 numbers behind x y z of vertices, neither a weight nor a colour (line 1: v 0 0 0 1 2)",
      "1 smoothing groups that are neither a number nor off (line 5: s first)",
      "1 texture coordinates and normals of lines and points (line 7: l 1/1 2/1)",
      "1 texture coordinates (`vt`) that no face uses (`vt` number 1)"}},
    {"ObjZeroBytes",
     "a.obj",
     obj_square + "f 1 2 3" + std::string(1, '\0'),
     "e2: 1 2 3\n",
     {"a.obj: byte 39: 1 zero byte at the end is passed over"}},
    {"ObjEndOfDos",
     "a.obj",
     "\xEF\xBB\xBF" + obj_square + "f 1 2 3\n\x1a" + std::string(2, '\0'),
     "e2: 1 2 3\n",
     {"a.obj: byte 43: 2 zero bytes and ^Z at the end are passed over"}},
    {"ObjBadCorners",
     "a.obj",
     obj_square + "vt 0 0\nvt 1 1\nf 1/1 2/7 3/1\nf 1/1 2 3/1\n",
     "e2: 1 2 3\ne2: 1 2 3\n",
     {},
     false,
     {"2 texture coordinates of faces that name some that do not exist, or not at every corner (line 7: f "
      "1/1 2/7 "
      "3/1)",
      "2 texture coordinates (`vt`) that no face uses (`vt` number 1)"}},

    {"PlyValues", "a.ply",
     ply_start + "comment by hand\nobj_info from nowhere\nelement vertex 3\n" + ply_xyz +
         "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
         "property uchar blue\nproperty double heat%20of\nproperty short v_0\nproperty short v_1\nelement "
         "face 1\n" +
         ply_list +
         "property list uchar float texcoord\nproperty int flag\nend_header\n"
         "0 0 0 0 0 1 255 0 0 0.1 1 2\n1 0 0 0 1 0 0 255 0 0.2 3 4\n0 1 0 1 0 0 0 0 255 1e-310 -5 6\n"
         "3 0 1 2 6 0 0 1 0 0.5 1 -7\n",
     "title by hand\nobj_info from nowhere\ne2: 0 1 2\nnode normal x3: 0 0 1 0 1 0 1 0 0\n"
     "node color x3 i: 255 0 0 0 255 0 0 0 255\nnode heat of x1: 0.1 0.2 1e-310\nnode v x2 i: 1 2 3 4 -5 6\n"
     "element flag x1 i: -7\ncorner texture x2: 0 0 1 0 0.5 1 nodes 3\n"},
    {"PlyTablesAndEdges", "a.ply",
     ply_start + "element vertex 3\n" + ply_xyz + "property list uchar uint ring\nelement face 1\n" +
         ply_list +
         "property float q\nelement edge 2\nproperty int vertex1\nproperty int vertex2\nproperty float q\n"
         "element camera 2\nproperty float32 f\nproperty list uint8 int16 view\nend_header\n"
         "0 0 0 0\n1 0 0 2 7 8\n0 1 0 1 9\n3 0 1 2 0.5\n0 1 1.5\n1 2 2.5\n0.25 1 -4\n3 0\n",
     "e2: 0 1 2\ne1: 0 1\ne1: 1 2\nelement q x1: 0.5 1.5 2.5\ntable vertex 3\n  ring (list uchar uint) 7 8 9 "
     "[0 2 1]\n"
     "table camera 2\n  f (float32) 0.25 3 []\n  view (list uint8 int16) -4 [1 0]\n"},
    {"PlyTwoValuesOfOneName", "a.ply",  // of faces and of edges; the names are equal when decoded
     ply_start + "element vertex 3\n" + ply_xyz + "element face 1\n" + ply_list +
         "property uchar markers\nelement edge 2\nproperty int vertex1\nproperty int vertex2\n"
         "property uchar %6Darkers\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 5\n0 1 6\n1 2 7\n",
     "e2: 0 1 2\ne1: 0 1\ne1: 1 2\nelement markers x1 i: 5\nelement markers x1 i: 6 7 from 1\n"},
    {"PlyStrips",
     "a.ply",
     ply_start + "element vertex 4\n" + ply_xyz + "element tristrips 1\n" + ply_list +
         "property float heat\nend_header\n" + square + "5 0 1 3 2 -1 0.5\n",
     "e2: 0 1 3\ne2: 3 1 2\n",
     {},
     false,
     {"1 properties of tristrips (heat)"}},
    {"PlyEndOfDos",
     "a.ply",
     "\xEF\xBB\xBF" + ply_start + "element vertex 3\n" + ply_xyz + "element face 1\n" + ply_list +
         "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\x1a",
     "e2: 0 1 2\n",
     {"a.ply: byte 183: ^Z at the end is passed over"}},
    {"PlyStripsWithRestarts", "a.ply",
     ply_start + "element vertex 4\n" + ply_xyz +
         "element tristrips 2\nproperty list int int vertex_index\n" + "end_header\n" + square +
         "8 0 1 3 -1 3 1 2 0\n5 -1 0 1 1 3\n",
     "e2: 0 1 3\ne2: 3 1 2\ne2: 2 1 0\n"},
    {"PlyPoints", "a.ply",
     ply_start + "element vertex 2\n" + ply_xyz +
         "property uchar confidence\nend_header\n0 0 0 1\n1 0 0 200\n",
     "node confidence x1 i: 1 200\n"},
};

class SurfaceDocuments : public testing::TestWithParam<Case> {};

TEST_P(SurfaceDocuments, ReadAndWrittenAgain) {
  const test::TestFiles files;
  const Case& given = GetParam();
  const Document document = read_document(files.write(given.file, given.bytes));
  EXPECT_EQ(told(document), given.told);
  std::vector<std::string> warnings;
  for (const std::string& warning : document.warnings)
    warnings.push_back(warning.substr(files.path("").size()));
  EXPECT_EQ(warnings, given.warnings);
  std::vector<std::string> dropped;
  for (const Loss& loss : document.dropped)
    dropped.push_back(fmt::format("{} {} ({})", loss.count, loss.item, loss.example));
  EXPECT_EQ(dropped, given.dropped);

  // Written in its own format it comes back. Elements that name unknown nodes do not.
  if (!document.unknown.empty()) return;
  const bool is_ply = given.file == "a.ply";
  for (const bool binary : {false, true}) {
    if (!is_ply && binary != given.binary) continue;
    const std::string again = files.path("again" + given.file.substr(1));
    EXPECT_TRUE(losses(again, document, {.binary = binary}).empty());
    write_document(again, document, {.binary = binary});
    const Document back = read_document(again);
    EXPECT_EQ(told(back), given.told) << files.read(again);
    EXPECT_EQ(test::text_of(back), test::text_of(document));
  }
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceDocuments, testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

// Also where only the surface is read.
TEST(StlAsASurface, SaysTheSameOfNormalsAndCounts) {
  const test::TestFiles files;
  std::string without_count = binary_stl("", 0, -1);
  without_count[80] = 0;
  for (const std::string& bytes : {"solid\nfacet normal 0 0 -2" + facet.substr(18) + other_facet,
                                   binary_stl("", 0, -1), without_count, binary_stl("", 0)}) {
    const std::string path = files.write("a.stl", bytes);
    const SurfaceFile surface = read_surface_file(path);
    const Document document = read_document(path);
    EXPECT_EQ(surface.warnings, document.warnings);
    ASSERT_EQ(surface.dropped.size(), document.dropped.size());
    for (std::size_t k = 0; k < surface.dropped.size(); ++k) {
      EXPECT_EQ(surface.dropped[k].item, document.dropped[k].item);
      EXPECT_EQ(surface.dropped[k].count, document.dropped[k].count);
      EXPECT_EQ(surface.dropped[k].example, document.dropped[k].example);
    }
    EXPECT_EQ(surface.dropped.size(), bytes == binary_stl("", 0) ? 0u : 1u);
  }
}

}  // namespace
}  // namespace tetproof
