// SPDX-License-Identifier: GPL-3.0-or-later
// The files that are written, compared with text written by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"
#include "tests/unit/io/rich_document.hpp"

namespace tetproof {
namespace {

using test::one_tet;
using test::rich_document;

std::string written(const Document& document, const std::string& name, const WriteOptions& options = {}) {
  const test::TestFiles files;
  write_document(files.path(name), document, options);
  return test::TestFiles::read(files.path(name));
}

TEST(MeshWrite, Msh41OfATetMesh) {
  EXPECT_EQ(
      written(document_of(one_tet), "a.msh"),
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 0.1 5e-324 1e+22 0 0\n$EndEntities\n"
      "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n0.1 0 0\n0 5e-324 0\n-0 0 1e+22\n$EndNodes\n"
      "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n");
}

TEST(MeshWrite, Msh22OfATetMesh) {
  EXPECT_EQ(written(document_of(one_tet), "a.msh", {.format = "msh22"}),
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 0.1 0 0\n3 0 5e-324 0\n4 -0 0 "
            "1e+22\n$EndNodes\n"
            "$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n");
}

TEST(MeshWrite, TetgenOfATetMesh) {
  const test::TestFiles files;
  write_document(files.path("a.1.ele"), document_of(one_tet));
  EXPECT_EQ(test::TestFiles::read(files.path("a.1.node")),
            "4 3 0 0\n1 0 0 0\n2 0.1 0 0\n3 0 5e-324 0\n4 -0 0 1e+22\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.1.ele")), "1 4 0\n1 1 2 3 4\n");
}

TEST(MeshWrite, VtuOfATetMesh) {
  EXPECT_EQ(written(document_of(one_tet), "a.vtu", {.binary = false}),
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" "
            "NumberOfCells=\"1\">\n<Points>\n"
            "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n"
            "0\n0\n0\n0.1\n0\n0\n0\n5e-324\n0\n-0\n0\n1e+22\n</DataArray>\n</Points>\n<Cells>\n"
            "<DataArray type=\"Int64\" Name=\"connectivity\" "
            "format=\"ascii\">\n0\n1\n2\n3\n"
            "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
            "format=\"ascii\">\n4\n"
            "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" "
            "format=\"ascii\">\n10\n"
            "</DataArray>\n</Cells>\n<PointData>\n</PointData>\n<CellData>\n</CellData>\n</Piece>\n</"
            "UnstructuredGrid>\n"
            "</VTKFile>\n");
}

TEST(MeshWrite, IndicesThatNameNoPoint) {
  const Document document = document_of(TetMesh{one_tet.points, {{0, 4, -1, 4}, {-7, 1, 2, 3}}});
  EXPECT_EQ(document.unknown, (std::vector<std::int64_t>{5, 0, -6}));
  const std::string text = written(document, "a.msh");
  EXPECT_NE(text.find("\n1 1 5 0 5\n2 -6 2 3 4\n"), text.npos) << text;
  const Numbering names = numbering(document);
  EXPECT_EQ(tet_mesh(document).tets, (std::vector<std::array<Index, 4>>{{0, -1, -2, -1}, {-3, 1, 2, 3}}));
  EXPECT_EQ(names.point(-1), 5);
  EXPECT_EQ(names.point(-3), -6);
  EXPECT_EQ(names.point(3), 4);
  EXPECT_EQ(names.tet(1), 2);
}

TEST(MeshWrite, NamedCellDataInVtu) {
  Document document = document_of(one_tet);
  document.element_values.push_back({.name = "check <1>", .components = 1, .reals = {}, .integers = {-3}});
  const std::string text = written(document, "a.vtu", {.binary = false});
  EXPECT_NE(text.find("<CellData>\n<DataArray type=\"Int64\" Name=\"check &lt;1&gt;\" "
                      "format=\"ascii\">\n-3\n</DataArray>\n</CellData>\n"),
            text.npos)
      << text;
}

TEST(MeshViews, SecondOrderByItsCorners) {
  const Document document = rich_document();
  const TetMesh mesh = tet_mesh(document);
  EXPECT_EQ(mesh.points.size(), 4u);  // without the nodes between corners
  EXPECT_EQ(mesh.tets, (std::vector<std::array<Index, 4>>{{0, 1, 2, 3}, {0, 1, 2, -1}}));
  const Numbering names = numbering(document);
  EXPECT_EQ(names.point(3), 40);
  EXPECT_EQ(names.tet(1), 3);
  EXPECT_EQ(names.point(-1), 999);
  const TriangleSurface surface = surface_of(document);
  EXPECT_EQ(surface.vertices.size(), 3u);
  EXPECT_EQ(surface.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}}));
}

TEST(MeshWrite, TetgenRenumbersAndKeepsUnknownNumbersUnknown) {
  const test::TestFiles files;
  Document document = rich_document();
  document.unknown = {2};                       // would be a node once nodes are numbered from 1
  document.element_values[0].reals.pop_back();  // the tetrahedra have attributes, the triangle has none
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "2 4 1\n1 1 2 3 4 2.25\n2 1 2 3 11 0\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "1 1\n1 1 2 3 7\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.node")).substr(0, 32), "10 3 0 1\n1 0 0 0 1\n2 0.1 0 0 1\n3");
}

TEST(MeshWrite, Binary22RenumbersWhatItCannotHold) {
  const test::TestFiles files;
  Document document = document_of(one_tet);
  document.node_tags = {1, 1LL << 40, 3, 4};
  document.first_element = 1LL << 33;
  const std::vector<Loss> kept = kept_aside("a.msh", document, {.format = "msh22", .binary = true}).items;
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].item, "numbers of nodes");
  EXPECT_EQ(kept[1].item, "numbers of elements");
  write_document(files.path("a.msh"), document, {.format = "msh22", .binary = true});
  const Document again = read_document(files.path("a.msh"));
  EXPECT_EQ(again.node_tags, document.node_tags);
  EXPECT_EQ(again.element_tag(0), document.first_element);
  test::TestFiles::leave_out_supplement(files.path("a.msh"));
  EXPECT_EQ(test::text_of(read_document(files.path("a.msh"))),
            "msh22\nn 1 0 0 0\nn 2 0.1 0 0\nn 3 0 5e-324 0\nn 4 -0 0 1e+22\ne 1 4 3/1 g p: 1 2 3 4\n");
  EXPECT_TRUE(kept_aside("a.msh", document, {.format = "msh22"}).items.empty());  // text has no such limit
}

}  // namespace
}  // namespace tetproof
