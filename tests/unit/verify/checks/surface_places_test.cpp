// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of a surface are named as its file has them, in every format: by the file's numbers, and by
// coordinates.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/surface_files.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/test_files.hpp"
#include "verify/surface.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

struct Case {
  std::string file, bytes, first;
};

// A tetrahedron on (0, 0, 0), (1, 0, 0), (0, 1, 0) and (0, 0, 1) without one face, and before its vertices a
// point that it does not use. The first edge of the first face is open.
const std::string points = "9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string edge = "from (0, 0, 0) to (0, 1, 0), of ";
std::string facet(const std::string& corners) {
  return "facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n";
}
const std::vector<Case> cases{
    {"a.off", "OFF\n5 3 0\n" + points + "3 1 3 2\n3 1 2 4\n3 2 3 4\n", "1-3 " + edge + "triangle 0"},
    {"a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 4 3\nf 2 3 5\nf 3 4 5\n",
     "2-4 " + edge + "triangle 1"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double "
     "z\nelement "
     "face 3\nproperty list uchar int vertex_indices\nend_header\n" +
         points + "3 1 3 2\n3 1 2 4\n3 2 3 4\n",
     "1-3 " + edge + "triangle 0"},
    {"a.stl",
     "solid a\n" + facet("vertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\n") +
         facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\n") +
         facet("vertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\n") + "endsolid\n",
     edge + "facet 1"},
    {"a.msh",
     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n10 9 9 9\n50 0 0 0\n40 1 0 0\n30 0 1 0\n20 0 0 "
     "1\n$EndNodes\n$Elements\n4\n100 15 2 0 1 10\n8 2 2 0 1 50 30 40\n7 2 2 0 1 50 40 20\n6 2 2 0 1 40 30 "
     "20\n$EndElements\n",
     "50-30 " + edge + "triangle 8"},
    {"a.vtk",
     "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n" + points +
         "CELLS 4 14\n1 0\n3 1 3 2\n3 1 2 4\n3 2 3 4\nCELL_TYPES 4\n1\n5\n5\n5\n",
     "1-3 " + edge + "triangle 1"},
    {"a.smesh",
     "5 3 0 0\n0 9 9 9\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n3 0\n3 1 3 2\n3 1 2 4\n3 2 3 4\n0\n0\n",
     "1-3 " + edge + "triangle 0"},
    {"b.poly",
     "5 3 0 0\n1 9 9 9\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 0 0 1\n3 0\n1\n3 2 4 3\n1\n3 2 3 5\n1\n3 3 4 5\n0\n0\n",
     "2-4 " + edge + "triangle 1"},
    {"a.mesh",
     "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n9 9 9 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 "
     "0\nTriangles\n3\n2 4 3 0\n2 3 5 0\n3 4 5 0\nEnd\n",
     "2-4 " + edge + "triangle 1"},
    // Each face has its own points: equal ones have the number of the first.
    {"b.off",
     "OFF\n10 3 0\n9 9 9\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n3 1 2 3\n3 4 5 6\n3 "
     "7 8 "
     "9\n",
     "1-2 " + edge + "triangle 0"},
};

TEST(SurfacePlaces, AreThoseOfTheFileInEveryFormat) {
  const TestFiles files;
  for (const Case& c : cases) {
    const SurfaceFile read = read_surface_file(files.write(c.file, c.bytes));
    EXPECT_EQ(verify::judge_surface(read.surface, read.numbering).fault,
              "the surface is open: 3 edges have one triangle (first: " + c.first + ")")
        << c.file;
  }
}

TEST(SurfacePlaces, TrianglesOfAPolygonHaveItsNumber) {
  const TestFiles files;
  // A cube whose last side is one of two triangles.
  const SurfaceFile read =
      read_surface_file(files.write("a.off",
                                    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 "
                                    "3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 "
                                    "2 6 5\n4 2 3 7 6\n3 3 0 4\n"));
  ASSERT_EQ(read.surface.triangles.size(), 11u);
  EXPECT_EQ(read.numbering.triangles, (std::vector<std::int64_t>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5}));
  EXPECT_EQ(
      verify::judge_surface(read.surface, read.numbering).fault,
      "the surface is open: 3 edges have one triangle (first: 3-4 from (0, 1, 0) to (0, 0, 1), of face 5)");
}

TEST(SurfacePlaces, WeldedVerticesKeepTheFirstNumber) {
  const TestFiles files;
  const SurfaceFile read = read_surface_file(files.write("b.off", cases.back().bytes));
  std::vector<std::int64_t> numbers;
  for (Index v = 0; v < static_cast<Index>(read.surface.vertices.size()); ++v)
    numbers.push_back(read.numbering.vertex(v));
  // The points of the file in its order: unused, (0, 0, 0), (0, 1, 0), (1, 0, 0), ..., (0, 0, 1).
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{0, 1, 2, 3, 6}));
}

// Other faults of an STL file: no vertex numbers, but facets and coordinates.
TEST(SurfacePlaces, FaultsOfStl) {
  const TestFiles files;
  const std::string a = "vertex 0 0 0\n", b = "vertex 1 0 0\n", c = "vertex 0 1 0\n", d = "vertex 0 0 1\n";
  const std::string three = facet(a + c + b) + facet(a + b + d) + facet(b + c + d);
  const std::vector<Case> faults{
      {"turned", three + facet(a + c + d),
       "the surface is not consistently oriented: 3 edges are run twice in the same direction (first: from "
       "(0, "
       "0, 0) to (0, 1, 0), by facet 1 and facet 4)"},
      {"flat", three + facet(a + d + c) + facet(a + a + b),
       "1 triangle has no area (first: facet 5 at (0, 0, 0))"},
      {"thrice", three + facet(a + d + c) + facet(c + a + "vertex 5 5 5\n") + facet(a + c + "vertex 5 5 5\n"),
       "the surface is not manifold: 1 edge has more than two triangles (first: from (0, 0, 0) to (0, 1, 0) "
       "has "
       "4)"},
      {"nan", three + facet(a + "vertex 0 nan 1\n" + c), "a corner of facet 4 is not finite: (0, nan, 1)"},
  };
  for (const Case& fault : faults) {
    const SurfaceFile read =
        read_surface_file(files.write("a.stl", "solid a\n" + fault.bytes + "endsolid\n"));
    EXPECT_EQ(verify::judge_surface(read.surface, read.numbering).fault, fault.first) << fault.file;
  }
}

TEST(SurfacePlaces, OfTheFindingsAgainstASurface) {
  const TestFiles files;
  // The block is one unit higher than the surface.
  const TriangleSurface cube = box_surface({0, 0, 0}, 1);
  std::string obj = "v 9 9 9\n";
  for (const Eigen::Vector3d& p : cube.vertices)
    obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  for (const auto& t : cube.triangles)
    obj += "f " + std::to_string(t[0] + 2) + " " + std::to_string(t[1] + 2) + " " + std::to_string(t[2] + 2) +
           "\n";
  const SurfaceFile read = read_surface_file(files.write("a.obj", obj));
  const TetMesh block = lattice_mesh({1, 1, 2});
  const auto what = [&](SurfaceNumbering numbering) {
    const verify::JudgedSurface judged(read.surface, std::move(numbering));
    const verify::Report report =
        verify::verify(block, judged, {.region = verify::Region::inside, .voxels = 0});
    return report[verify::Check::off_surface_vertex].findings.at(0).what;
  };
  const auto number = [](const std::string& text) {
    return std::stoi(text.substr(text.find("nearest triangle ") + 17));
  };
  EXPECT_EQ(number(what(read.numbering)), number(what({})) + 1) << what(read.numbering);
}

}  // namespace
}  // namespace tetproof::test
