// SPDX-License-Identifier: GPL-3.0-or-later
// Every construct of PLY's grammar, text and binary: the vertices and triangles that are read.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/unit/io/surface/surface_read_cases.hpp"

namespace tetproof::test {
namespace {

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

std::vector<ReadCase> ply_cases() {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string text = ply_header("ascii") + points + faces;
  // A point whose first byte is an LF. It must not be taken for the second half of a line end.
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
  std::vector<ReadCase> cases{
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
       // The first strip is 0 1 2, 2 1 3. The second one is 0 2 3, 3 2 1. The third one is 1 1 0, 0 1 3, 0 3
       // 3, 3 3 2: its triangles with equal corners are left out.
       {{0, 1, 2}, {2, 1, 3}, {0, 2, 3}, {3, 2, 1}, {0, 1, 3}}},
      {"ByContent", "a.xyz", text, tet_points, tet_triangles},
  };
  return cases;
}

class Ply : public testing::TestWithParam<ReadCase> {};
TEST_P(Ply, Reads) {
  expect_read(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surface, Ply, testing::ValuesIn(ply_cases()), name_of_case);

}  // namespace
}  // namespace tetproof::test
