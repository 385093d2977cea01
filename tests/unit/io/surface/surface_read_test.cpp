// SPDX-License-Identifier: GPL-3.0-or-later
// Every corner of the surface formats' grammars: what is read, vertex by vertex and triangle by triangle.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<Index, 3>>;

struct Case {
  std::string name;
  std::string file;
  std::string bytes;
  Points vertices;
  Triangles triangles;

  friend void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }
};

// The tetrahedron of most samples: four vertices, four outward triangles.
const Points tet_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles tet_triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
const Points one_points{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
const Triangles one_triangle{{0, 1, 2}};

std::string with_line_ends(std::string text, const std::string& end) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += end.size())
    text.replace(at, 1, end);
  return text;
}

// Bytes of numbers, in this order of bytes.
class Bytes {
 public:
  explicit Bytes(bool big = false) : big_(big) {}
  template <class Number>
  Bytes& operator()(Number value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_ == (std::endian::native == std::endian::little)) bytes.assign(bytes.rbegin(), bytes.rend());
    text += bytes;
    return *this;
  }
  std::string text;

 private:
  bool big_;
};

std::string binary_stl(const std::string& header, std::uint32_t count, const std::vector<Points>& facets) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  Bytes body;
  body(count);
  for (const Points& facet : facets) {
    for (int k = 0; k < 3; ++k) body(0.0f);
    for (const auto& point : facet)
      for (const double x : point) body(static_cast<float>(x));
    body(std::uint16_t{7});
  }
  return bytes + body.text;
}

const std::string stl_facet =
    "facet normal 0 0 1\n outer loop\n  vertex 1 2 3\n  vertex 4 5 6\n  vertex 7 8 10\n endloop\nendfacet\n";
const std::string stl_other_facet =
    "facet normal 0 0 1\nouter loop\nvertex 4 5 6\nvertex 1 2 3\nvertex 0 0 9\nendloop\nendfacet\n";
const std::vector<Points> stl_two{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}, {{4, 5, 6}, {1, 2, 3}, {0, 0, 9}}};
const Points two_points{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}, {0, 0, 9}};
const Triangles two_triangles{{0, 1, 2}, {1, 0, 3}};

// Text whose size happens to be 84 + 50 n, so that only the count tells it from binary.
std::string padded_text_stl() {
  std::string text = "solid x\n" + stl_facet + "endsolid x\n";
  while ((text.size() - 84) % 50 != 0) text += '\n';
  return text;
}

std::vector<Case> stl_cases() {
  const std::string text = "solid part one\n" + stl_facet + stl_other_facet + "endsolid part one\n";
  std::string upper = text;
  for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  std::string indented = with_line_ends(text, "\n \t ");
  std::string exponents = text;
  exponents.replace(exponents.find("vertex 1 2 3"), 12, "vertex 0.1D+01 2.0d0 +300E-2");
  return {
      {"Text", "a.stl", text, two_points, two_triangles},
      {"TextCrLf", "a.stl", with_line_ends(text, "\r\n"), two_points, two_triangles},
      {"TextCr", "a.stl", with_line_ends(text, "\r"), two_points, two_triangles},
      {"TextUpperCase", "a.STL", upper, two_points, two_triangles},
      {"TextLeadingBlanks", "a.stl", "\n\t  " + indented, two_points, two_triangles},
      {"TextByteOrderMark", "a.stl", "\xEF\xBB\xBF" + text, two_points, two_triangles},
      {"TextDExponents", "a.stl", exponents, two_points, two_triangles},
      {"TextNoName", "a.stl", "solid\n" + stl_facet + "endsolid\n", one_points, one_triangle},
      {"TextNoEnd", "a.stl", "solid x\n" + stl_facet, one_points, one_triangle},
      {"TextNoSolid", "a.stl", stl_facet + "endsolid\n", one_points, one_triangle},
      {"TextNoLastLineEnd", "a.stl", "solid x\n" + stl_facet + "endsolid x", one_points, one_triangle},
      {"TextSeveralSolids", "a.stl",
       "solid a\n" + stl_facet + "endsolid a\nsolid b\n" + stl_other_facet + "endsolid b\n", two_points,
       two_triangles},
      {"TextSolidsWithoutEnds", "a.stl", "solid a\n" + stl_facet + "solid\n" + stl_other_facet, two_points,
       two_triangles},
      {"TextNoNormal", "a.stl",
       "solid\nfacet\nouter loop\nvertex 1 2 3\nvertex 4 5 6\nvertex 7 8 10\nendloop\nendfacet\n", one_points,
       one_triangle},
      {"TextOddNormal", "a.stl",
       "solid\nfacet normal -nan(ind) 1.#IND x\nouter loop\nvertex 1 2 3\nvertex 4 5 6\nvertex 7 8 "
       "10\nendloop\nendfacet\n",
       one_points, one_triangle},
      {"TextNameOfKeywords", "a.stl", "solid facet normal vertex\n" + stl_facet, one_points, one_triangle},
      {"TextOfBinarySize", "a.stl", padded_text_stl(), one_points, one_triangle},
      {"TextEmpty", "a.stl", "solid nothing\nendsolid nothing\n", {}, {}},
      {"TextDoubles",
       "a.stl",
       "solid\nfacet normal 0 0 0\nouter loop\nvertex 0.1 1e-300 3\nvertex 4 5 6\nvertex 7 8 "
       "10\nendloop\nendfacet\n",
       {{0.1, 1e-300, 3}, {4, 5, 6}, {7, 8, 10}},
       one_triangle},
      {"Binary", "a.stl", binary_stl("anything", 2, stl_two), two_points, two_triangles},
      {"BinarySolid", "a.stl", binary_stl("solid x\nfacet normal", 2, stl_two), two_points, two_triangles},
      {"BinaryCountZero", "a.stl", binary_stl("streamed", 0, stl_two), two_points, two_triangles},
      {"BinaryEmpty", "a.stl", binary_stl("nothing", 0, {}), {}, {}},
      {"BinaryMinusZero",
       "a.stl",
       binary_stl("x", 1, {{{0.0, 0, 0}, {1, -0.0, 0}, {-0.0, 1, -0.0}}}),
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
       one_triangle},
      {"BinaryDegenerate",
       "a.stl",
       binary_stl("x", 1, {{{0, 0, 0}, {1, 0, 0}, {-0.0, 0, -0.0}}}),
       {{0, 0, 0}, {1, 0, 0}},
       {{0, 1, 0}}},
      {"BinaryFloats",
       "a.stl",
       binary_stl("x", 1, {{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
       {{0.100000001490116119384765625, 0, 0}, {1, 0, 0}, {0, 1, 0}},
       one_triangle},
      {"BinaryByContent", "a.surface", binary_stl("x", 2, stl_two), two_points, two_triangles},
      {"TextByContent", "nameless", text, two_points, two_triangles},
  };
}

std::vector<Case> off_cases() {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string plain = "OFF\n4 4 6\n" + points + faces;
  return {
      {"Plain", "a.off", plain, tet_points, tet_triangles},
      {"CrLf", "a.OFF", with_line_ends(plain, "\r\n"), tet_points, tet_triangles},
      {"Cr", "a.off", with_line_ends(plain, "\r"), tet_points, tet_triangles},
      {"CountsOnFirstLine", "a.off", "OFF 4 4 6\n" + points + faces, tet_points, tet_triangles},
      {"CountsTouchKeyword", "a.off", "OFF4 4 6\n" + points + faces, tet_points, tet_triangles},
      {"NoEdgeCount", "a.off", "OFF\n4 4\n" + points + faces, tet_points, tet_triangles},
      {"NoKeyword", "a.off", "4 4 6\n" + points + faces, tet_points, tet_triangles},
      {"Comments", "a.off",
       "# made by hand\nOFF # here\n# and\n\n4 4 6 # there\n#\n" + points + "# faces\n" + faces + "# end",
       tet_points, tet_triangles},
      {"Blanks", "a.off", "\n\t OFF \n\n 4\t4  6 \n" + with_line_ends(points + faces, " \n\n\t"), tet_points,
       tet_triangles},
      {"NoLastLineEnd", "a.off", plain.substr(0, plain.size() - 1), tet_points, tet_triangles},
      {"FaceColours", "a.off",
       "OFF\n4 4 6\n" + points + "3 0 2 1 255 0 0\n3 0 1 3 0.5 0.25 1 0.75\n3 1 2 3 7\n3 0 3 2 # none\n",
       tet_points, tet_triangles},
      {"VertexColours", "a.off",
       "COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n0 1 0 .5 .5 .5\n0 0 1 1 1 1 1\n" + faces, tet_points,
       tet_triangles},
      {"Normals", "a.off", "NOFF\n4 4 6\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + faces,
       tet_points, tet_triangles},
      {"TextureColoursNormals", "a.off",
       "STCNOFF 4 4 6\n0 0 0 1 0 0 1 1 1 1 0 0\n1 0 0 0 1 0 1 1 1 1 0 0\n0 1 0 0 0 1 1 1 1 1 0 0\n0 0 1 0 0 "
       "1 1 1 1 1 0 0\n" +
           faces,
       tet_points, tet_triangles},
      {"Square",
       "a.off",
       "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 1 0 0\n",
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
       {{0, 1, 2}, {0, 2, 3}}},
      {"Welded",
       "a.off",
       "OFF 6 2 0\n0 0 0\n1 0 0\n0 1 0\n-0 1 0\n1 -0 -0.0\n2 2 0\n3 0 1 2\n3 3 4 5\n",
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}},
       {{0, 1, 2}, {2, 1, 3}}},
      {"UnusedVertexKept",
       "a.off",
       "OFF 4 1 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n",
       {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
       {{1, 2, 3}}},
      {"DegenerateTriangleKept",
       "a.off",
       "OFF 3 2 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n3 0 1 1\n",
       {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
       {{0, 1, 2}, {0, 1, 1}}},
      {"Empty", "a.off", "OFF 0 0 0\n", {}, {}},
      {"HardNumbers",
       "a.off",
       "OFF 3 1 0\n0.12345678901234567 1e-320 1e400\n-1e-400 +.5 5.\n1D2 -3d-1 0\n3 0 1 2\n",
       {{0.12345678901234567, 1e-320, std::numeric_limits<double>::infinity()}, {0, 0.5, 5}, {100, -0.3, 0}},
       one_triangle},
      {"ByContent", "a.geom", plain, tet_points, tet_triangles},
  };
}

std::vector<Case> obj_cases() {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string plain = points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  return {
      {"Plain", "a.obj", plain, tet_points, tet_triangles},
      {"CrLf", "a.obj", with_line_ends(plain, "\r\n"), tet_points, tet_triangles},
      {"Cr", "a.OBJ", with_line_ends(plain, "\r"), tet_points, tet_triangles},
      {"TextureAndNormal", "a.obj",
       points + "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 2/1 3/1 4/1\nf 1/1/ 4// 3/\n",
       tet_points, tet_triangles},
      {"Negative", "a.obj",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4/-1/-1 -3//-1 -1\nf -3 -2 -1\nf 1 -1 -2\n",
       tet_points, tet_triangles},
      {"NamedBeforeItStands", "a.obj", "f 1 3 2\nf 1 2 4\n" + points + "f 2 3 4\nf 1 4 3\n", tet_points,
       tet_triangles},
      {"Continuation", "a.obj",
       "v 0 0 \\\n0\nv \\\r\n1 0 0\nv 0 1 0\\\n\nv 0 0 1\nvn 1 \\\n0 0\nf 1 3 \\\n \\\n2\nf 1 2 4\\\n \nf 2 "
       "3\\\n 4\nf 1 4 3\\",
       tet_points, tet_triangles},
      {"VertexColoursAndWeights", "a.obj",
       "v 0 0 0 1 0 0\nv 1 0 0 1.0\nv 0 1 0 nan nan nan\nv 0 0 1 0.5 0.5 0.5 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf "
       "1 4 3\n",
       tet_points, tet_triangles},
      {"GroupsAndMaterials", "a.obj",
       "mtllib a.mtl\no part f 1 2 3\ng An f Three Other Things\ns off\nusemtl red\nl 1 2\np 1\nvp 0 1\n" +
           plain,
       tet_points, tet_triangles},
      {"Comments", "a.obj",
       "# v 9 9 9\\\n" + points + "f 1 3 2 # f 1 2 3\n\n  # x\nf 1 2 4#\n\tf 2 3 4\nf 1 4 3", tet_points,
       tet_triangles},
      {"Square",
       "a.obj",
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
       {{0, 1, 2}, {0, 2, 3}}},
      {"Welded",
       "a.obj",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 -0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 5 4 6\n",
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
       {{0, 1, 2}, {2, 1, 3}}},
      {"OnlyPoints", "a.obj", points, tet_points, {}},
      {"Nothing", "a.obj", "# Blender\n", {}, {}},
  };
}

std::string ply_header(const std::string& format, const std::string& scalar = "double",
                       const std::string& list = "uchar int vertex_indices") {
  return "ply\nformat " + format + " 1.0\ncomment x\nelement vertex 4\nproperty " + scalar + " x\nproperty " +
         scalar + " y\nproperty " + scalar + " z\nelement face 4\nproperty list " + list + "\nend_header\n";
}

template <class Scalar, class Count, class Item>
std::string ply_body(bool big) {
  Bytes body(big);
  for (const auto& point : tet_points)
    for (const double x : point) body(static_cast<Scalar>(x));
  for (const auto& triangle : tet_triangles) {
    body(static_cast<Count>(3));
    for (const Index corner : triangle) body(static_cast<Item>(corner));
  }
  return body.text;
}

std::vector<Case> ply_cases() {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string text = ply_header("ascii") + points + faces;
  // A point whose first byte is an LF, which must not be taken for the second half of a line end.
  Bytes lf;
  lf(std::bit_cast<double>(std::uint64_t{0x400000000000000a}))(0.0)(0.0)(1.0)(0.0)(0.0)(0.0)(1.0)(0.0);
  lf(std::uint8_t{3})(std::int32_t{0})(std::int32_t{1})(std::int32_t{2});
  const std::string lf_header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double "
      "y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  const Points lf_points{
      {std::bit_cast<double>(std::uint64_t{0x400000000000000a}), 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Bytes rich(true);  // unknown elements, properties and lists everywhere
  rich(std::int16_t{5})(std::uint8_t{2})(1.5f)(2.5f)(std::int16_t{6})(std::uint8_t{0});
  for (const auto& point : tet_points) {
    rich(std::uint8_t{200})(static_cast<float>(point[2]));
    rich(std::uint32_t{1})(9.0)(static_cast<float>(point[0]))(std::int8_t{-1})(static_cast<float>(point[1]));
  }
  for (const auto& triangle : tet_triangles) {
    rich(std::uint8_t{6});
    for (int k = 0; k < 6; ++k) rich(0.5f);
    rich(std::uint16_t{3});
    for (const Index corner : triangle) rich(static_cast<std::uint16_t>(corner));
    rich(std::uint8_t{255});
  }
  const std::string rich_header =
      "ply\nformat binary_big_endian 1.0\nobj_info hello\nelement camera 2\nproperty short id\nproperty list "
      "uint8 float32 view\n"
      "element nothing 1000000000000\nelement vertex 4\nproperty uchar red\nproperty float z\nproperty list "
      "uint32 float64 weights\n"
      "property float32 x\nproperty int8 flag\nproperty float y\nelement face 4\nproperty list uchar float "
      "texcoord\n"
      "property list uint16 ushort vertex_index\nproperty uchar alpha\nend_header\n";
  std::vector<Case> cases{
      {"Text", "a.ply", text, tet_points, tet_triangles},
      {"TextCrLf", "a.PLY", with_line_ends(text, "\r\n"), tet_points, tet_triangles},
      {"TextCr", "a.ply", with_line_ends(text, "\r"), tet_points, tet_triangles},
      {"TextBlankLines", "a.ply", ply_header("ascii") + with_line_ends(points, "\n\n ") + faces + "\n\n",
       tet_points, tet_triangles},
      {"TextVertexIndex", "a.ply", ply_header("ascii", "float", "uint8 uint32 vertex_index") + points + faces,
       tet_points, tet_triangles},
      {"TextFloatPropertiesKeepDoubles",
       "a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
       "z\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2",
       {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}},
       one_triangle},
      {"FacesFirst", "a.ply",
       "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex "
       "3\nproperty float x\n"
       "property float y\nproperty float z\nend_header\n3 0 1 2\n1 2 3\n4 5 6\n7 8 10\n",
       one_points, one_triangle},
      {"TextSquare",
       "a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\nelement "
       "face 1\n"
       "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
       {{0, 1, 2}, {0, 2, 3}}},
      {"TextUnknownLists", "a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty list uchar int rings\nproperty "
       "float y\nproperty float z\n"
       "property uchar red\nelement face 1\nproperty list uchar float texcoord\nproperty list uchar int "
       "vertex_indices\n"
       "property int flags\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
       "1 2 8 9 2 3 255\n4 0 5 6 0\n7 1 1 8 10 9\n2 0.5 0.5 3 0 1 2 -7\n0 1\n",
       one_points, one_triangle},
      {"LittleEndian", "a.ply",
       ply_header("binary_little_endian") + ply_body<double, std::uint8_t, std::int32_t>(false), tet_points,
       tet_triangles},
      {"BigEndian", "a.ply",
       ply_header("binary_big_endian") + ply_body<double, std::uint8_t, std::int32_t>(true), tet_points,
       tet_triangles},
      {"BigEndianShorts", "a.ply",
       ply_header("binary_big_endian", "short", "ushort short vertex_indices") +
           ply_body<std::int16_t, std::uint16_t, std::int16_t>(true),
       tet_points, tet_triangles},
      {"LittleEndianBytes", "a.ply",
       ply_header("binary_little_endian", "char", "char uchar vertex_index") +
           ply_body<std::int8_t, std::int8_t, std::uint8_t>(false),
       tet_points, tet_triangles},
      {"LittleEndianFloatLists", "a.ply",
       ply_header("binary_little_endian", "float", "int double vertex_index") +
           ply_body<float, std::int32_t, double>(false),
       tet_points, tet_triangles},
      {"LittleEndianUnsigned", "a.ply",
       ply_header("binary_little_endian", "ushort", "uint uint vertex_index") +
           ply_body<std::uint16_t, std::uint32_t, std::uint32_t>(false),
       tet_points, tet_triangles},
      {"BinaryAfterLf", "a.ply", lf_header + lf.text, lf_points, one_triangle},
      {"BinaryAfterCrLf", "a.ply", with_line_ends(lf_header, "\r\n") + lf.text, lf_points, one_triangle},
      {"BinaryAfterCr", "a.ply", with_line_ends(lf_header, "\r") + lf.text, lf_points, one_triangle},
      {"BinaryUnknownEverything", "a.ply", rich_header + rich.text, tet_points, tet_triangles},
      {"Strips",
       "a.ply",
       "ply\nformat ascii 1.0\nelement tristrips 2\nproperty list int int vertex_indices\nproperty int id\n"
       "element vertex 4\nproperty int x\nproperty int y\nproperty int z\nend_header\n"
       "9 0 1 2 3 -1 0 2 3 1 7\n6 1 1 0 3 3 2 8\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n",
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}},
       // 0 1 2, 2 1 3; 0 2 3, 3 2 1; 1 1 0, 0 1 3, 0 3 3 and 3 3 2 in turn: two with equal corners on each
       // side.
       {{0, 1, 2}, {2, 1, 3}, {0, 2, 3}, {3, 2, 1}, {0, 1, 3}}},
      {"ByContent", "a.xyz", text, tet_points, tet_triangles},
  };
  return cases;
}

void check(const Case& given) {
  const test::TestFiles files;
  if (given.triangles.empty()) {
    EXPECT_EQ(files.message([&] { read_surface(files.write(given.file, given.bytes)); }),
              given.file + ": expected a surface, found no triangles or polygons");
    return;
  }
  TriangleSurface surface;
  ASSERT_NO_THROW(surface = read_surface(files.write(given.file, given.bytes)));
  ASSERT_EQ(surface.vertices.size(), given.vertices.size());
  for (std::size_t i = 0; i < given.vertices.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(surface.vertices[i][k], given.vertices[i][k]) << "vertex " << i << " axis " << k;
  EXPECT_EQ(surface.triangles, given.triangles);
  EXPECT_TRUE(surface.parameters.empty());
}

class Stl : public testing::TestWithParam<Case> {};
class Off : public testing::TestWithParam<Case> {};
class Obj : public testing::TestWithParam<Case> {};
class Ply : public testing::TestWithParam<Case> {};
TEST_P(Stl, Reads) {
  check(GetParam());
}
TEST_P(Off, Reads) {
  check(GetParam());
}
TEST_P(Obj, Reads) {
  check(GetParam());
}
TEST_P(Ply, Reads) {
  check(GetParam());
}

const auto name_of = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Surface, Stl, testing::ValuesIn(stl_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Surface, Off, testing::ValuesIn(off_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Surface, Obj, testing::ValuesIn(obj_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Surface, Ply, testing::ValuesIn(ply_cases()), name_of);

TEST(SurfaceWelding, NanStaysUnwelded) {
  const test::TestFiles files;
  const TriangleSurface surface = read_surface(files.write(
      "a.off", "OFF 6 2 0\nnan 0 0\n1 0 0\n0 1 0\nnan 0 0\ninf 0 0\ninf -0 0\n3 0 1 2\n3 3 4 5\n"));
  ASSERT_EQ(surface.vertices.size(), 5u);
  EXPECT_TRUE(std::isnan(surface.vertices[0][0]) && std::isnan(surface.vertices[3][0]));
  EXPECT_EQ(surface.triangles, (Triangles{{0, 1, 2}, {3, 4, 4}}));
}

TEST(SurfaceWelding, FirstOccurrenceKeepsItsSignOfZero) {
  const test::TestFiles files;
  const TriangleSurface surface =
      read_surface(files.write("a.off", "OFF 4 1 0\n-0 0 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"));
  ASSERT_EQ(surface.vertices.size(), 3u);
  EXPECT_TRUE(std::signbit(surface.vertices[0][0]));
}

TEST(SurfaceFiles, KnowsEndings) {
  for (const char* path : {"a.stl", "b/a.STL", "a.b.off", "a.Obj", "x.ply"})
    EXPECT_TRUE(is_surface_file(path)) << path;
  for (const char* path : {"stl", "a.stl/b", "a.stlx", "a.", "", "sphere:r=1", "a.node"})
    EXPECT_FALSE(is_surface_file(path)) << path;
}

}  // namespace
}  // namespace tetproof
