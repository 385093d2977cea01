// SPDX-License-Identifier: GPL-3.0-or-later
// A solid gives the same surface from every format, whatever polygons its faces consist of.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/cube_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

// Whether each edge has one triangle on either side; the area; the volume.
struct Measured {
  bool closed = true;
  double area = 0, volume = 0;
};

Measured measure(const TriangleSurface& surface) {
  Measured measured;
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d &a = surface.vertices.at(static_cast<std::size_t>(t[0])),
                          &b = surface.vertices.at(static_cast<std::size_t>(t[1])),
                          &c = surface.vertices.at(static_cast<std::size_t>(t[2]));
    measured.area += (b - a).cross(c - a).norm() / 2;
    measured.volume += a.dot(b.cross(c)) / 6;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (count != 1 || other == edges.end() || other->second != 1) measured.closed = false;
  }
  return measured;
}

class SameCube : public testing::TestWithParam<std::string> {};

TEST_P(SameCube, OfTrianglesOfQuadranglesAndOfBoth) {
  const test::TestFiles files;
  std::vector<std::array<Index, 3>> expected;  // the two halves of each quadrangle, by hand
  for (const test::Face& q : test::cube_quads) {
    expected.push_back({q[0], q[1], q[2]});
    expected.push_back({q[0], q[2], q[3]});
  }
  for (const std::size_t cut : {6, 0, 3}) {
    const std::string path =
        files.write("cube" + GetParam(), test::cube_file(GetParam(), test::cube_faces(cut)));
    const SurfaceFile read = read_surface_file(path);
    EXPECT_EQ(read.warnings, std::vector<std::string>{});
    EXPECT_TRUE(read.dropped.empty());
    ASSERT_EQ(read.surface.vertices.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(read.surface.vertices[i][k], test::cube_corners[i][static_cast<std::size_t>(k)]);
    EXPECT_EQ(read.surface.triangles, expected) << cut;
    const Measured measured = measure(read.surface);
    EXPECT_TRUE(measured.closed);
    EXPECT_DOUBLE_EQ(measured.area, 6);
    EXPECT_DOUBLE_EQ(measured.volume, 1);
    // The document gives the same surface.
    const TriangleSurface again = surface_of(read_document(path));
    EXPECT_EQ(again.triangles, read.surface.triangles);
    EXPECT_EQ(again.vertices, read.surface.vertices);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SameCube, testing::ValuesIn(test::cube_endings),
                         [](const auto& test) { return test.param.substr(1); });

// Every format refuses the same faces, with the same words.
TEST(SurfaceOf, RefusesTheSameFromEveryFormat) {
  const test::TestFiles files;
  for (const std::string& ending : test::cube_endings) {
    const auto message = [&](const std::vector<test::Face>& faces) {
      return files.message([&] { read_surface(files.write("a" + ending, test::cube_file(ending, faces))); });
    };
    EXPECT_EQ(message({}), "a" + ending + ": expected a surface, found no triangles or polygons");
    const std::string crossed = message({{0, 2, 1, 3}});
    EXPECT_NE(crossed.find("with 4 corners crosses itself"), crossed.npos) << crossed;
    const std::string unknown = message({{0, 1, 2}, {0, 1, 9}});
    EXPECT_NE(unknown.find(" names "), unknown.npos) << unknown;
  }
}

// Every format cuts a face that is not planar in the same way.
TEST(SurfaceOf, CutsTheSameFromEveryFormat) {
  for (const std::string& ending : test::cube_endings) {
    const test::TestFiles files;
    const SurfaceFile read =
        read_surface_file(files.write("a" + ending, test::cube_file(ending, {{0, 1, 2, 7}})));
    ASSERT_EQ(read.surface.triangles.size(), 2u) << ending;
    EXPECT_EQ(read.surface.triangles[0], (std::array<Index, 3>{0, 1, 2})) << ending;
    ASSERT_EQ(read.warnings.size(), 1u) << ending;
    EXPECT_NE(read.warnings[0].find("1 quadrangle is not planar"), std::string::npos) << read.warnings[0];
  }
}

TEST(SurfaceOf, PassesOverWhatIsNoFace) {
  // Only a tetrahedron uses node 6, and no element uses node 7.
  const test::TestFiles files;
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 .5 .5 1\n"
      "6 .5 .5 .5\n7 9 9 9\n$EndNodes\n$Elements\n5\n1 15 2 0 1 1\n2 1 2 0 1 1 2\n3 3 2 0 1 1 4 3 2\n"
      "4 2 2 0 1 1 2 5\n5 4 2 0 1 1 2 3 6\n$EndElements\n";
  const TriangleSurface surface = read_surface(files.write("a.msh", text));
  EXPECT_EQ(surface.vertices.size(), 6u);
  EXPECT_EQ(surface.vertices[5], Eigen::Vector3d(9, 9, 9));
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}}));
}

TEST(SurfaceOf, CutsSecondOrderByItsCorners) {
  // A quadrangle of 8 nodes and a triangle of 6.
  Document document;
  for (int i = 0; i < 11; ++i) document.points.emplace_back(i % 4 == 1 || i % 4 == 2, i % 4 >= 2, 0);
  document.blocks.push_back({.type = 16, .dim = 2, .nodes_each = 8, .count = 1});
  document.blocks.push_back({.type = 9, .dim = 2, .nodes_each = 6, .count = 1, .first = 1, .nodes = 8});
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 3, 8, 9, 10};
  const TriangleSurface surface = surface_of(document);
  EXPECT_EQ(surface.vertices.size(), 4u);
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
}

TEST(SurfaceOf, RefusesTypesThatItCannotCut) {
  const test::TestFiles files;
  Document document;
  document.path = "x.msh";
  document.points.resize(3);
  document.blocks.push_back({.type = 68, .dim = 2, .nodes_each = 3, .count = 1});  // a sub-element
  document.connectivity = {0, 1, 2};
  EXPECT_EQ(files.message([&] { surface_of(document); }),
            "x.msh: element 1 of type 68 is neither a triangle, a quadrangle nor a polygon");
}

}  // namespace
}  // namespace tetproof
