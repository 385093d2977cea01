// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that stand in a mesh file: its triangles, welded, or one line.
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "io/surface_files.hpp"
#include "test_files.hpp"

namespace tetproof {
namespace {

// A .msh 2.2 with these nodes and elements.
std::string msh(const std::vector<std::string>& nodes, const std::vector<std::string>& elements) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(nodes.size()) + "\n";
  for (const std::string& node : nodes) text += node + "\n";
  text += "$EndNodes\n$Elements\n" + std::to_string(elements.size()) + "\n";
  for (const std::string& element : elements) text += element + "\n";
  return text + "$EndElements\n";
}

TEST(MshSurface, TrianglesWeldedAndInnerNodesLeftOut) {
  const test::TestFiles files;
  // Node 5 stands inside, used by the tetrahedron alone; node 9 repeats node 1.
  const TriangleSurface surface = read_surface(
      files.write("a.msh", msh({"1 0 0 0", "2 1 0 0", "5 0.1 0.1 0.1", "3 0 1 0", "4 0 0 1", "9 0 0 -0"},
                               {"1 15 2 0 1 1", "2 2 2 0 1 1 3 2", "3 2 2 0 1 9 2 4", "4 2 2 0 1 2 3 4",
                                "5 2 2 0 1 9 4 3", "6 4 2 0 1 1 2 3 5"})));
  ASSERT_EQ(surface.vertices.size(), 4u);
  EXPECT_EQ(surface.vertices[2], Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(surface.triangles,
            (std::vector<std::array<Index, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}));
}

struct Refusal {
  std::string name;
  std::vector<std::string> elements;
  std::string message;

  friend void PrintTo(const Refusal& test, std::ostream* out) { *out << test.name; }
};

class MshSurfaceRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(MshSurfaceRefusals, Message) {
  const test::TestFiles files;
  const std::string path =
      files.write("a.msh", msh({"1 0 0 0", "2 1 0 0", "3 0 1 0", "4 0 0 1"}, GetParam().elements));
  EXPECT_EQ(files.message([&] { read_surface(path); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(All, MshSurfaceRefusals,
                         testing::Values(Refusal{"NoTriangles",
                                                 {"7 4 2 0 1 1 2 3 4"},
                                                 "a.msh: expected a surface, found no triangles"},
                                         Refusal{
                                             "Nothing", {}, "a.msh: expected a surface, found no triangles"},
                                         Refusal{"Quadrangle",
                                                 {"7 2 2 0 1 1 2 3", "8 3 2 0 1 1 2 3 4"},
                                                 "a.msh: element 8 is no triangle; cut it into triangles"},
                                         Refusal{"UnknownNode",
                                                 {"7 2 2 0 1 1 2 3", "8 2 2 0 1 1 2 77"},
                                                 "a.msh: element 8 names node 77, which does not exist"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof
