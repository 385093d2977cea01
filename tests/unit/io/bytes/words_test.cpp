// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/words.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tetproof::io {
namespace {

TEST(Words, OneIsSingular) {
  const std::vector<std::pair<std::string, std::string>> words{
      {"hexahedra", "1 hexahedron"},
      {"tetrahedra as in a.ele", "1 tetrahedron as in a.ele"},
      {"prisms", "1 prism"},
      {"vertices", "1 vertex"},
      {"entities", "1 entity"},
      {"boundary faces", "1 boundary face"},
      {"numbers of nodes that do not exist", "1 number of nodes that do not exist"},
      {"elements of type 42", "1 element of type 42"},
      {"cells of type 42 (polyhedron)", "1 cell of type 42 (polyhedron)"},
      {"lines behind those that a file announces", "1 line behind those that a file announces"},
      // Without a plural, or with one that is a name.
      {"check volume-voxel", "1 check volume-voxel"},
      {"keyword Pentahedra", "1 keyword Pentahedra"},
      {"keyword of code 12 in meshes", "1 keyword of code 12 in meshes"},
      {"", "1 "},
  };
  for (const auto& [many, one] : words) EXPECT_EQ(counted(1, many), one);
}

TEST(Words, AllOthersArePlural) {
  EXPECT_EQ(counted(0, "vertices"), "0 vertices");
  EXPECT_EQ(counted(std::size_t{2}, "vertices"), "2 vertices");
  EXPECT_EQ(counted(-1, "vertices"), "-1 vertices");
}

}  // namespace
}  // namespace tetproof::io
