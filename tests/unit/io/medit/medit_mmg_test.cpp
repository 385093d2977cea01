// SPDX-License-Identifier: GPL-3.0-or-later
// Files as MMG, FreeFem, GHS3D and Medit write them, by hand: nothing of them is lost on the way through a
// .mesh or .meshb. The order of keywords, blanks and numbers that no file has are no losses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Mesh {
  std::string name, text;
  std::string not_in_binary{};  // the one thing that has no code in binary files

  friend void PrintTo(const Mesh& mesh, std::ostream* out) { *out << mesh.name; }
};

const std::string head = "MeshVersionFormatted 2\n\n\nDimension 3\n\n\n";
const std::string vertices = "Vertices\n5\n0 0 0 0 \n1 0 0 1 \n0 1 0 0 \n0 0 1 4 \n1 1 1 0 \n\n";
const std::string tetrahedra = "Tetrahedra\n2\n1 2 3 4 1 \n2 3 4 5 2 \n\n";
const std::string triangles = "Triangles\n3\n1 3 2 10 \n1 2 4 10 \n2 3 5 0 \n\n";
const std::string edges = "Edges\n2\n1 2 3 \n2 3 0 \n\n";

const Mesh meshes[]{
    {"TetrahedraFirst", head + vertices + tetrahedra + triangles + edges + "\nEnd\n"},
    {"AKeywordTwice",
     head + vertices + triangles + tetrahedra + "Triangles\n1\n3 4 5 1\nRequiredTriangles\n1\n4\nEnd\n"},
    {"VerticesLast", head + triangles + edges + tetrahedra + vertices + "End\n"},
    {"Mmg3d", head + vertices + "Corners\n2 \n1 \n5 \n\nRequiredVertices \n1 \n3 \n\n" + triangles +
                  "RequiredTriangles\n1\n2 \n\n" + edges +
                  "Ridges\n1\n2 \n\nRequiredEdges\n1\n1 \n\n"
                  "Normals\n2\n0 0 1 \n0.70710678118654757 0.70710678118654757 0 \n\nNormalAtVertices\n2\n1 "
                  "1 \n3 2 \n\n"
                  "Tangents\n1\n1 0 0 \n\nTangentAtVertices\n1\n2 1 \n\n" +
                  tetrahedra + "RequiredTetrahedra\n1\n2 \n\nEnd\n"},
    {"Parallel",
     head + vertices + tetrahedra + triangles + edges +
         "ParallelVertices\n1\n2\n\nParallelEdges\n1\n2\n\nParallelTriangles\n2\n1\n3\n\n"
         "ParallelTetrahedra\n1\n1\n\nEnd\n",
     "Parallel"},
    {"NormalsWithTrailingBlanks", head + vertices +
                                      "Normals \n2 \n0 0 1 \n0 1 0 \n\nNormalAtVertices  \n1\t\n1 2 \n" +
                                      tetrahedra + "End \n"},
    {"NormalsAtTriangles", head + vertices + triangles +
                               "Normals\n1\n0 0 1\nNormalAtTriangleVertices\n2\n1 1 1\n1 2 1\n"
                               "TangentAtEdgeVertices\n1\n1 1 1\nTangents\n1\n1 0 0\n" +
                               edges + "End\n"},
    {"OneLineEach",
     "MeshVersionFormatted 1 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 Tetrahedra 1 1 2 3 4 0 "
     "Triangles 1 1 2 3 7 End"},
    {"CountsOfZero", head + vertices + "Corners\n0\n\nRidges\n0\n\nTriangles\n0\n\nRequiredTriangles\n0\n\n" +
                         tetrahedra + "End\n"},
    {"PrismsAndHexahedra",
     head + "Vertices\n9\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n"
            "0 0 2 0\nPentahedra\n1\n1 2 3 5 6 7 3\nHexahedra\n1\n1 2 3 4 5 6 7 8 4\n"
            "Pyramids\n1\n5 6 7 8 9 1\nQuadrilaterals\n2\n1 2 3 4 8\n5 6 7 8 9\n"
            "RequiredQuadrilaterals\n1\n2\nTetrahedra\n1\n1 2 3 9 5\nEnd\n"},
    {"SurfaceOfMmgs",
     head + vertices + triangles + "Ridges\n2\n1\n2\n" + edges + "RequiredVertices\n1\n5\nEnd\n"},
    {"Plane",
     "MeshVersionFormatted 2\nDimension\n2\nVertices\n3\n0 0 1\n1 0 2\n0 1 3\nTriangles\n1\n1 2 3 4\nEdges\n"
     "1\n1 2 5\nNormals\n1\n0 1\nCorners\n1\n2\nEnd\n"},
    {"CommentsAndLinesOfDos",
     "# made by hand\r\nMeshVersionFormatted 2\r\nDimension 3\r\nVertices # all\r\n1\r\n"
     "0 0 0 0\r\nRequiredVertices\r\n1\r\n1 # this\r\nBoundingBox\r\n0 0 0 1 1 1 # box\r\n"
     "AngleOfCornerBound\r\n45.5\r\nEnd\r\n"},
    {"NegativeReferences",
     head + "Vertices\n4\n0 0 0 -1\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 -7\nTriangles\n"
            "1\n1 2 3 -2\nEnd\n"},
    {"SecondOrder",
     head + "Vertices\n6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n.5 0 0 0\n.5 .5 0 0\n0 .5 0 0\nTrianglesP2\n1\n"
            "1 2 3 4 5 6 2\nEdges\n1\n1 2 1\nEnd\n"},
    {"Periodic", head + vertices + tetrahedra + "PeriodicVertices\n1\n1 2\n\nEnd\n"},
};

class MeshesOfMmg : public testing::TestWithParam<Mesh> {};

TEST_P(MeshesOfMmg, ComeBackWithoutALoss) {
  const test::TestFiles files;
  const Mesh& mesh = GetParam();
  const Document document = read_document(files.write("a.mesh", mesh.text));
  EXPECT_TRUE(document.warnings.empty()) << document.warnings[0];
  EXPECT_TRUE(document.dropped.empty()) << document.dropped[0].item;
  for (const char* out : {"b.mesh", "b.meshb"}) {
    const bool binary = out[6] == 'b';
    for (const Loss& loss : losses(files.path(out), document))
      EXPECT_TRUE(binary && !mesh.not_in_binary.empty() &&
                  loss.item.find(mesh.not_in_binary) != loss.item.npos)
          << out << ": " << loss.item << " (" << loss.example << ")";
    write_document(files.path(out), document);
    const Document back = read_document(files.path(out));
    EXPECT_TRUE(back.dropped.empty() && back.warnings.empty()) << out;
    if (binary && !mesh.not_in_binary.empty()) continue;
    EXPECT_EQ(test::text_of(back, false), test::text_of(document, false)) << out;
    // And so does what comes back.
    EXPECT_TRUE(losses(files.path("c.mesh"), back).empty()) << out;
  }
}

INSTANTIATE_TEST_SUITE_P(ByHand, MeshesOfMmg, testing::ValuesIn(meshes),
                         [](const auto& test) { return test.param.name; });

// Marks count the elements of their own kind, wherever these stand in the file.
TEST(MeditMarks, NameElementsOfTheirKind) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.mesh",
      head + vertices + tetrahedra + triangles + edges +
          "RequiredTetrahedra 1\n2\nRequiredTriangles 1\n1\nRidges 1\n2\nParallelTriangles 1\n3\nEnd\n"));
  const std::string text = test::text_of(document, false);
  EXPECT_EQ(text.substr(text.find("v elements")),
            "v elements RequiredTetrahedra 1 at 2: 1\nv elements RequiredTriangles 1 at 3: 1\n"
            "v elements Ridges 1 at 7: 1\nv elements ParallelTriangles 1 at 5: 1\n");
}

// VTK's files have arrays for all nodes and all elements.
TEST(MeditMarks, AreWrittenFromArraysOfOnes) {
  const test::TestFiles files;
  Document document =
      read_document(files.write("a.mesh", head + vertices + tetrahedra + triangles + edges + "End\n"));
  document.node_values = {{.name = "Corners", .integers = {1, 0, 0, 0, 1}}};
  document.element_values = {{.name = "Ridges", .integers = {0, 0, 0, 0, 0, 0, 1}},
                             {.name = "RequiredTriangles", .integers = {0, 0, 0, 1, 1, 0, 0}},
                             {.name = "RequiredEdges", .integers = {1, 0, 0, 0, 0, 0, 1}},
                             {.name = "ParallelEdges", .integers = {0, 0, 0, 0, 0, 0, 2}}};
  std::string lost;
  for (const Loss& loss : losses(files.path("b.mesh"), document)) lost += loss.item + "; ";
  EXPECT_EQ(lost, "values \"RequiredEdges\" of elements; values \"ParallelEdges\" of elements; ");
  document.element_values.resize(2);
  for (const char* name : {"b.mesh", "b.meshb"}) {
    EXPECT_TRUE(losses(files.path(name), document).empty()) << name;
    write_document(files.path(name), document);
    const std::string text = test::text_of(read_document(files.path(name)), false);
    EXPECT_EQ(text.substr(text.find("v ")),
              "v nodes Corners 1 at 1 5: 1 1\nv elements Ridges 1 at 7: 1\nv elements RequiredTriangles 1 at "
              "4 5: 1 1\n");
  }
}

// Words of other tools for the one number of a node.
TEST(MeditReferences, FromMarkers) {
  const test::TestFiles files;
  Document document = read_document(files.write("a.mesh", head + vertices + "End\n"));
  const std::string references = test::text_of(document, false);
  ASSERT_EQ(document.node_values.size(), 1u);
  for (const char* word : {"markers", "tetgen:ref", "medit:ref"})
    for (const bool real : {false, true}) {
      Values& values = document.node_values[0];
      values = {.name = word};
      if (real)
        values.reals = {0, 1, 0, 4, 0};
      else
        values.integers = {0, 1, 0, 4, 0};
      for (const char* name : {"b.mesh", "b.meshb"}) {
        EXPECT_TRUE(losses(files.path(name), document).empty()) << name << " " << word;
        write_document(files.path(name), document);
        EXPECT_EQ(test::text_of(read_document(files.path(name)), false), references) << name;
      }
    }
}

// Medit counts elements by kind: where TetGen's files come in another order, nothing is lost that was said.
TEST(MeditNumbers, OfElementsAreNone) {
  const test::TestFiles files;
  const Document document =
      read_document(files.write("a.mesh", head + vertices + edges + triangles + tetrahedra + "End\n"));
  std::string aside;
  for (const Loss& loss : kept_aside(files.path("b.ele"), document).items) aside += loss.item + "; ";
  EXPECT_EQ(aside, "");
}

}  // namespace
}  // namespace tetproof
