// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces in mesh files: the triangles, welded, or a refusal in one line.
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

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
  // Only the tetrahedron uses the inner node 5. Node 9 repeats node 1.
  const TriangleSurface surface = read_surface(
      files.write("a.msh", msh({"1 0 0 0", "2 1 0 0", "5 0.1 0.1 0.1", "3 0 1 0", "4 0 0 1", "9 0 0 -0"},
                               {"1 15 2 0 1 1", "2 2 2 0 1 1 3 2", "3 2 2 0 1 9 2 4", "4 2 2 0 1 2 3 4",
                                "5 2 2 0 1 9 4 3", "6 4 2 0 1 1 2 3 5"})));
  ASSERT_EQ(surface.vertices.size(), 4u);
  EXPECT_EQ(surface.vertices[2], Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(surface.triangles,
            (std::vector<std::array<Index, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}));
}

// The surface of the same tetrahedron in the formats of other programs, by hand.
TEST(MeshSurface, FromOtherPrograms) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"a.mesh",
       "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
       "Triangles\n4\n1 3 2 7\n1 2 4 7\n2 3 4 7\n1 4 3 7\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"},
      {"a.vtk",
       "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
       "0 0 0 1 0 0 0 1 0 0 0 1\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"},
      {"a.VTU",
       "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
       "<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\"><Points><DataArray type=\"Float64\" "
       "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
       "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>"
       "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray>"
       "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 5 5 5</DataArray></Cells></Piece>"
       "</UnstructuredGrid></VTKFile>"},
      {"a.face", "4 0\n1 1 3 2\n2 1 2 4\n3 2 3 4\n4 1 4 3\n"}};
  const test::TestFiles files;
  files.write("a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  for (const auto& [name, bytes] : cases) {
    const TriangleSurface surface = read_surface(files.write(name, bytes));
    EXPECT_EQ(surface.vertices, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}))
        << name;
    EXPECT_EQ(surface.triangles,
              (std::vector<std::array<Index, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}))
        << name;
  }
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

INSTANTIATE_TEST_SUITE_P(
    All, MshSurfaceRefusals,
    testing::Values(Refusal{"NoTriangles",
                            {"7 4 2 0 1 1 2 3 4"},
                            "a.msh: expected a surface, found no triangles or polygons"},
                    Refusal{"Nothing", {}, "a.msh: expected a surface, found no triangles or polygons"},
                    Refusal{"UnknownNode",
                            {"7 2 2 0 1 1 2 3", "8 2 2 0 1 1 2 77"},
                            "a.msh: element 8 names node 77, which does not exist"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof
