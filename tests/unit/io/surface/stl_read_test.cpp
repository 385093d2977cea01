// SPDX-License-Identifier: GPL-3.0-or-later
// Every construct of STL's grammar, text and binary: the vertices and triangles that are read.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/unit/io/surface/surface_read_cases.hpp"

namespace tetproof::test {
namespace {

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

// Text whose size happens to be 84 + 50 n, so that only the number of facets shows that it is not binary.
std::string padded_text_stl() {
  std::string text = "solid x\n" + stl_facet + "endsolid x\n";
  while ((text.size() - 84) % 50 != 0) text += '\n';
  return text;
}

std::vector<ReadCase> stl_cases() {
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

class Stl : public testing::TestWithParam<ReadCase> {};
TEST_P(Stl, Reads) {
  expect_read(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surface, Stl, testing::ValuesIn(stl_cases()), name_of_case);

}  // namespace
}  // namespace tetproof::test
