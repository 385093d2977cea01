// SPDX-License-Identifier: GPL-3.0-or-later
// Every construct of OBJ's grammar: the vertices and triangles that are read.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/io/surface/surface_read_cases.hpp"

namespace tetproof::test {
namespace {

std::vector<ReadCase> obj_cases() {
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

class Obj : public testing::TestWithParam<ReadCase> {};
TEST_P(Obj, Reads) {
  expect_read(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surface, Obj, testing::ValuesIn(obj_cases()), name_of_case);

}  // namespace
}  // namespace tetproof::test
