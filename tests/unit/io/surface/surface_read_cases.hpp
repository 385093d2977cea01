// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of surface files with the vertices and triangles that are expected of them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<Index, 3>>;

struct ReadCase {
  std::string name;
  std::string file;
  std::string bytes;
  Points vertices;
  Triangles triangles;

  friend void PrintTo(const ReadCase& test, std::ostream* out) { *out << test.name; }
};

/// The tetrahedron of most cases: four vertices, four outward triangles.
inline const Points tet_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const Triangles tet_triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
inline const Points one_points{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
inline const Triangles one_triangle{{0, 1, 2}};

inline std::string with_line_ends(std::string text, const std::string& end) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += end.size())
    text.replace(at, 1, end);
  return text;
}

/// Numbers as bytes; `big`: the most significant byte first.
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

/// Reads the file of a case and compares. A case without triangles is refused as a surface.
inline void expect_read(const ReadCase& given) {
  const TestFiles files;
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

/// The name of a case, for INSTANTIATE_TEST_SUITE_P.
inline std::string name_of_case(const testing::TestParamInfo<ReadCase>& test) {
  return test.param.name;
}

}  // namespace tetproof::test
