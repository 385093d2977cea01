// SPDX-License-Identifier: GPL-3.0-or-later
// What is written reads back equal: every double in OFF, OBJ, PLY and text STL, every float in binary STL.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>
#include <random>
#include <string>

#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

constexpr std::uint64_t seed = 20261122;

// Finite points of random bits, and random triangles. Vertices are different (except the extremes) and are
// first used in their order, so welding and renumbering change nothing.
TriangleSurface random_surface(int points) {
  std::mt19937_64 random(seed);
  TriangleSurface surface;
  const double extremes[]{0.0,
                          std::numeric_limits<double>::denorm_min(),
                          std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::min(),
                          0.1,
                          1.0 / 3,
                          1e22,
                          1e23};
  for (int i = 0; i < points; ++i) {
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) {
      do point[k] = i < 8 && k == i % 3 ? -extremes[i] : std::bit_cast<double>(random());
      while (!std::isfinite(point[k]));
    }
    surface.vertices.push_back(point);
  }
  for (Index i = 2; i < points; ++i)
    surface.triangles.push_back(
        {i == 2 ? 0 : static_cast<Index>(random() % i), i == 2 ? 1 : static_cast<Index>(random() % i), i});
  return surface;
}

void expect_same(const TriangleSurface& read, const TriangleSurface& written) {
  ASSERT_EQ(read.vertices.size(), written.vertices.size());
  for (std::size_t i = 0; i < read.vertices.size(); ++i)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(read.vertices[i][k]),
                std::bit_cast<std::uint64_t>(written.vertices[i][k]))
          << "vertex " << i << ", seed " << seed;
  EXPECT_EQ(read.triangles, written.triangles);
}

struct Way {
  const char* name;
  const char* file;
  SurfaceWriteOptions options;

  friend void PrintTo(const Way& test, std::ostream* out) { *out << test.name; }
};

class SurfaceRoundTrip : public testing::TestWithParam<Way> {};

TEST_P(SurfaceRoundTrip, EveryBit) {
  const test::TestFiles files;
  const TriangleSurface surface = random_surface(20000);
  const std::string path = files.path(GetParam().file);
  write_surface(path, surface, GetParam().options);
  expect_same(read_surface(path), surface);
}

TEST_P(SurfaceRoundTrip, Empty) {
  const test::TestFiles files;
  const std::string path = files.path(GetParam().file);
  write_surface(path, {}, GetParam().options);
  EXPECT_EQ(read_document(path).points.size(), 0u);
  EXPECT_EQ(files.message([&] { read_surface(path); }),
            std::string(GetParam().file) + ": expected a surface, found no triangles or polygons");
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceRoundTrip,
                         testing::Values(Way{"Off", "a.off", {}}, Way{"Obj", "a.obj", {}},
                                         Way{"PlyBinary", "a.ply", {}},
                                         Way{"PlyText", "a.ply", {.ascii = true}},
                                         Way{"PlyInUpperCase", "a.PLY", {}},
                                         Way{"OffInAnotherFile", "a.off", {.format = "off"}},
                                         Way{"StlText", "a.stl", {.ascii = true}}),
                         [](const auto& test) { return test.param.name; });

TEST(SurfaceWrite, BinaryStlRoundsToFloats) {
  const test::TestFiles files;
  TriangleSurface surface;
  surface.vertices = {{0.1, 0, 0}, {1e300, 0, 0}, {0, -1e-300, 16777217}};
  surface.triangles = {{0, 1, 2}};
  write_surface(files.path("a.stl"), surface);
  const TriangleSurface read = read_surface(files.path("a.stl"));
  EXPECT_EQ(std::filesystem::file_size(files.path("a.stl")), 134u);
  ASSERT_EQ(read.vertices.size(), 3u);
  EXPECT_EQ(read.vertices[0], Eigen::Vector3d(0.100000001490116119384765625, 0, 0));
  EXPECT_EQ(read.vertices[1], Eigen::Vector3d(HUGE_VAL, 0, 0));
  EXPECT_EQ(read.vertices[2], Eigen::Vector3d(0, 0, 16777216));  // half way: rounds to even
}

TEST(SurfaceWrite, BinaryStlOfFloatsIsExact) {
  const test::TestFiles files;
  TriangleSurface surface = random_surface(2000);
  std::mt19937 random(static_cast<std::uint32_t>(seed));
  for (auto& point : surface.vertices)
    for (int k = 0; k < 3; ++k) {
      float value;
      do value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      while (!std::isfinite(value));
      point[k] = value;
    }
  write_surface(files.path("a.stl"), surface);
  expect_same(read_surface(files.path("a.stl")), surface);
}

// The bytes of a tetrahedron, by hand.
TEST(SurfaceWrite, Texts) {
  const test::TestFiles files;
  TriangleSurface surface;
  surface.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 0.1, -0.0}};
  surface.triangles = {{0, 1, 2}};
  write_surface(files.path("a.off"), surface);
  EXPECT_EQ(files.read(files.path("a.off")), "OFF\n3 1 0\n0 0 0\n2 0 0\n0 0.1 -0\n3 0 1 2\n");
  write_surface(files.path("a.obj"), surface);
  EXPECT_EQ(files.read(files.path("a.obj")), "v 0 0 0\nv 2 0 0\nv 0 0.1 -0\nf 1 2 3\n");
  write_surface(files.path("a.ply"), surface, {.ascii = true});
  EXPECT_EQ(
      files.read(files.path("a.ply")),
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 0.1 -0\n3 0 1 "
      "2\n");
  write_surface(files.path("a.stl"), surface, {.ascii = true});
  EXPECT_EQ(files.read(files.path("a.stl")),
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0.1 "
            "-0\nendloop\nendfacet\n"
            "endsolid\n");
}

TEST(SurfaceWrite, NanAndInfinity) {
  const test::TestFiles files;
  TriangleSurface surface;
  surface.vertices = {{std::nan(""), HUGE_VAL, -HUGE_VAL}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{0, 1, 2}};
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"})
    for (const bool ascii : {true, false}) {
      write_surface(files.path(name), surface, {.ascii = ascii});
      const TriangleSurface read = read_surface(files.path(name));
      ASSERT_EQ(read.vertices.size(), 3u) << name;
      EXPECT_TRUE(std::isnan(read.vertices[0][0])) << name;
      EXPECT_EQ(read.vertices[0][1], HUGE_VAL) << name;
      EXPECT_EQ(read.vertices[0][2], -HUGE_VAL) << name;
    }
}

TEST(SurfaceWrite, RefusesAndLeavesNothingBehind) {
  const test::TestFiles files;
  TriangleSurface surface;
  surface.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(files.message([&] { write_surface(files.path("a.off"), surface); }),
            "a.off: cannot write triangle 1: vertex 3 of 3 vertices does not exist");
  surface.triangles = {{0, -1, 2}};
  EXPECT_EQ(files.message([&] { write_surface(files.path("a.stl"), surface); }),
            "a.stl: cannot write triangle 0: vertex -1 of 3 vertices does not exist");
  surface.triangles = {{0, 1, 2}};
  EXPECT_EQ(files.message([&] { write_surface(files.path("a.step"), surface); }),
            "a.step: unknown ending '.step', expected a surface as .stl, .off, .obj or .ply");
  EXPECT_EQ(files.message([&] { write_surface(files.path("a.off"), surface, {.format = "step"}); }),
            "unknown surface format 'step', expected stl, off, obj or ply");
  EXPECT_EQ(files.message([&] { write_surface(files.path("none/a.off"), surface); }),
            "none/a.off: cannot create: No such file or directory");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
}

}  // namespace
}  // namespace tetproof
