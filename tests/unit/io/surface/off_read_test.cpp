// SPDX-License-Identifier: GPL-3.0-or-later
// Every construct of OFF's grammar: the vertices and triangles that are read.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/unit/io/surface/surface_read_cases.hpp"

namespace tetproof::test {
namespace {

std::vector<ReadCase> off_cases() {
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

class Off : public testing::TestWithParam<ReadCase> {};
TEST_P(Off, Reads) {
  expect_read(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surface, Off, testing::ValuesIn(off_cases()), name_of_case);

}  // namespace
}  // namespace tetproof::test
