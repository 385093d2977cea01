// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of all surface formats share: welding of equal points, and the endings of files.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

TEST(SurfaceWelding, NanStaysUnwelded) {
  const test::TestFiles files;
  const TriangleSurface surface = read_surface(files.write(
      "a.off", "OFF 6 2 0\nnan 0 0\n1 0 0\n0 1 0\nnan 0 0\ninf 0 0\ninf -0 0\n3 0 1 2\n3 3 4 5\n"));
  ASSERT_EQ(surface.vertices.size(), 5u);
  EXPECT_TRUE(std::isnan(surface.vertices[0][0]) && std::isnan(surface.vertices[3][0]));
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {3, 4, 4}}));
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
