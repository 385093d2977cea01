// SPDX-License-Identifier: GPL-3.0-or-later
// The files that are written, and the losses that are listed, compared with text written by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const TetMesh one_tet{{{0, 0, 0}, {0.1, 0, 0}, {0, 5e-324, 0}, {-0., 0, 1e22}}, {{0, 1, 2, 3}}};

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
            "<DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" "
            "format=\"ascii\">\n0\n1\n2\n3\n"
            "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" NumberOfComponents=\"1\" "
            "format=\"ascii\">\n4\n"
            "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" NumberOfComponents=\"1\" "
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
  EXPECT_NE(
      text.find("<CellData>\n<DataArray type=\"Int64\" Name=\"check &lt;1&gt;\" NumberOfComponents=\"1\" "
                "format=\"ascii\">\n-3\n</DataArray>\n</CellData>\n"),
      text.npos)
      << text;
}

// A document with everything: two tetrahedra (one of second order), a triangle in two groups, sparse numbers,
// a node that does not exist, parameters, a boundary, attributes, and a section of another program.
Document rich() {
  Document document;
  document.format = "msh41";
  document.path = "rich.msh";
  document.points = {{0, 0, 0},    {0.1, 0, 0}, {0, 1, 0},  {0, 0, 1},   {.05, 0, 0},
                     {.05, .5, 0}, {0, .5, 0},  {0, 0, .5}, {0, .5, .5}, {.05, 0, .5}};
  document.node_tags = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
  document.node_blocks = {{.dim = 2, .entity = 6, .first = 0, .count = 3, .parameters_each = 2},
                          {.dim = 3, .entity = 5, .first = 3, .count = 7}};
  document.parameters = {0, 0, 1, 0, 0, 1};
  document.tag_sets = {{}, {7, 8}, {9}};
  document.blocks = {
      {.type = 11, .dim = 3, .entity = 5, .groups = 2, .nodes_each = 10, .count = 1},
      {.type = 4, .dim = 3, .entity = 5, .groups = 2, .nodes_each = 4, .count = 1, .first = 1, .nodes = 10},
      {.type = 2, .dim = 2, .entity = 6, .groups = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 14}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1, 2, -1, 0, 1, 2};
  document.element_tags = {5, 3, 9};
  document.unknown = {999};
  document.entities = {{.dim = 2, .groups = 1, .tag = 6, .box = {0, 0, 0, 0.1, 1, 0}},
                       {.dim = 3, .groups = 2, .tag = 5, .box = {0, 0, 0, 0.1, 1, 1}, .boundary = {-6}}};
  document.group_names = {{2, 7, "skin"}};
  document.node_values.push_back(
      {.name = "markers", .components = 1, .reals = {}, .integers = std::vector<std::int64_t>(10, 1)});
  document.element_values.push_back(
      {.name = "attributes", .components = 1, .reals = {2.25, 0, 0}, .integers = {}});
  document.sections = {{.name = "Periodic", .body = "0\n", .format = "msh41"},
                       {.name = "Mine", .body = "x\n", .format = "msh41"}};
  return document;
}

struct LossCase {
  std::string name, file;
  WriteOptions options;
  std::vector<std::string> expected;

  friend void PrintTo(const LossCase& test, std::ostream* out) { *out << test.name; }
};

const std::vector<LossCase> loss_cases{
    {"Msh41", "a.msh", WriteOptions(), {"values \"markers\" of nodes: 10 (1)"}},
    {"Msh41Binary",
     "a.msh",
     {.binary = true},
     {"values \"markers\" of nodes: 10 (1)", "section $Periodic: 1 (2 bytes)"}},
    {"Msh22",
     "a.msh",
     {.format = "msh22"},
     {"entities with their boxes and boundaries: 1 (5 of dimension 3)", "values \"markers\" of nodes: 10 (1)",
      "section $Periodic: 1 (2 bytes)"}},
    {"Tetgen",
     "a.node",
     WriteOptions(),
     {"nodes between the corners of tetrahedra of 10 nodes (type 11): 1 (element 5)",
      "numbers of nodes: 10 (the first is 10)", "numbers of elements: 3 (the first is 5)",
      "entities of elements: 3 (element 5 in entity 5)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 2 (6 of dimension 2)",
      "physical groups of elements: 3 (element 5 in groups 9)", "names of physical groups: 1 (skin)",
      "nodes with parametric coordinates: 3 (node 10)", "values \"attributes\" of elements: 3 (2.25)",
      "section $Periodic: 1 (2 bytes)", "section $Mine: 1 (2 bytes)"}},
    {"Vtu",
     "a.vtu",
     WriteOptions(),
     {"elements that name nodes which do not exist: 1 (element 3 names node 999)",
      "numbers of nodes: 10 (the first is 10)", "numbers of elements: 2 (the first is 5)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 1 (5 of dimension 3)", "names of physical groups: 1 (skin)",
      "nodes with parametric coordinates: 3 (node 10)", "section $Periodic: 1 (2 bytes)",
      "section $Mine: 1 (2 bytes)"}},
    {"Stl",
     "a.stl",
     WriteOptions(),
     {"tetrahedra of 10 nodes (type 11): 1 (element 5)", "tetrahedra of 4 nodes (type 4): 1 (element 3)",
      "nodes of no element that is written: 7 (node 40)", "numbers of nodes: 3 (the first is 10)",
      "numbers of elements: 1 (the first is 9)",
      "coordinates rounded to 32 bits: 1 (0.1 becomes 0.10000000149011612)",
      "entities of elements: 1 (element 9 in entity 6)",
      "entities of nodes: 10 (node 10 on entity 6 of dimension 2)",
      "entities with their boxes and boundaries: 2 (6 of dimension 2)",
      "physical groups of elements: 1 (element 9 in groups 7 8)", "names of physical groups: 1 (skin)",
      "nodes with parametric coordinates: 3 (node 10)", "values \"markers\" of nodes: 10 (1)",
      "values \"attributes\" of elements: 3 (2.25)", "section $Periodic: 1 (2 bytes)",
      "section $Mine: 1 (2 bytes)"}},
};

// The items that the format does not hold. They are either lost or kept aside.
std::vector<Loss> unheld(const std::string& path, const Document& document, const WriteOptions& options) {
  const std::vector<Loss> lost = losses(path, document, options);
  const std::vector<Loss> kept = kept_aside(path, document, options).items;
  EXPECT_TRUE(lost.empty() || kept.empty());
  return lost.empty() ? kept : lost;
}

class Losses : public testing::TestWithParam<LossCase> {};

TEST_P(Losses, AreListed) {
  std::vector<std::string> listed;
  for (const Loss& loss : unheld(GetParam().file, rich(), GetParam().options))
    listed.push_back(fmt::format("{}: {} ({})", loss.item, loss.count, loss.example));
  EXPECT_EQ(listed, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(OfARichDocument, Losses, testing::ValuesIn(loss_cases),
                         [](const auto& test) { return test.param.name; });

TEST(Losses, NoneForAPlainMesh) {
  for (const char* file : {"a.msh", "a.node", "a.vtu"})
    EXPECT_TRUE(losses(file, document_of(one_tet)).empty()) << file;
  EXPECT_TRUE(losses("a.msh", document_of(one_tet), {.format = "msh22"}).empty());
  const TriangleSurface triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
  for (const char* file : {"a.msh", "a.vtu", "a.stl", "a.off", "a.obj", "a.ply"})
    EXPECT_TRUE(losses(file, document_of(triangle)).empty()) << file;
}

// A view of Gmsh with two time steps, and a view of one element only.
TEST(Losses, OfValuesWhoseNumbersAreThere) {
  const test::TestFiles files;
  const std::string data = "1\n\"heat\"\n1\n", two = "3\n0\n1\n2\n8 0.5\n9 1.5\n$EndNodeData\n";
  const Document document = read_document(
      files.write("a.msh",
                  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n8 0 0 0\n9 1 0 0\n$EndNodes\n"
                  "$Elements\n2\n3 1 2 0 1 8 9\n4 1 2 0 1 9 8\n$EndElements\n"
                  "$NodeData\n" +
                      data + "0\n" + two + "$NodeData\n" + data + "2.5\n" + two +
                      "$ElementData\n1\n\"\"\n1\n0\n3\n7\n1\n1\n3 6\n$EndElementData\n"));
  const auto listed = [&](const std::string& file) {
    std::vector<std::string> items;
    for (const Loss& loss : losses(file, document))
      if (!loss.item.starts_with("numbers"))
        items.push_back(fmt::format("{}: {} ({})", loss.item, loss.count, loss.example));
    return items;
  };
  const std::vector<std::string> expected{
      "names of values of nodes: 1 (\"heat\" becomes \"heat #2\")",
      "times and steps of values of nodes: 1 (\"heat\" of time 2.5, step 0)",
      "names of values of elements: 1 (\"\" becomes \"values\")",
      "gaps in values of elements: 1 (element 4 has no \"\")",
      "times and steps of values of elements: 1 (\"\" of time 0, step 7)"};
  EXPECT_EQ(listed("a.vtu"), expected);
  EXPECT_EQ(listed("a.vtk"), expected);
  write_document(files.path("a.vtu"), document);
  const Document back = read_document(files.path("a.vtu"));
  ASSERT_EQ(back.node_values.size(), 2u);
  EXPECT_EQ(back.node_values[1].name, "heat #2");
  EXPECT_EQ(back.node_values[1].reals, (std::vector{0.5, 1.5}));
  ASSERT_EQ(back.element_values.size(), 1u);
  ASSERT_EQ(back.element_values[0].reals.size(), 2u);
  EXPECT_EQ(back.element_values[0].reals[0], 6);
  EXPECT_TRUE(std::isnan(back.element_values[0].reals[1]));
}

// In 4.1 an element has the groups and partitions of its entity, so an entity with elements of two groups
// becomes two entities.
TEST(Losses, AnEntityInTwoGroups) {
  const test::TestFiles files;
  const Document document = read_document(files.write(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n3\n1 4 2 7 5 1 2 3 4\n2 4 2 8 5 1 2 4 3\n3 4 4 7 5 1 2 1 3 2 4\n$EndElements\n"));
  EXPECT_TRUE(losses("b.msh", document).empty());
  const std::vector<Loss> kept = kept_aside("b.msh", document).items;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].item + ": " + kept[0].example,
            "numbers of entities: element 2 in entity 5 comes into entity 6");
  write_document(files.path("b.msh"), document);
  EXPECT_EQ(test::text_of(read_document(files.path("b.msh"))).substr(5), test::text_of(document).substr(5));
  test::TestFiles::leave_out_supplement(files.path("b.msh"));
  EXPECT_EQ(test::text_of(read_document(files.path("b.msh"))),
            "msh41\nE 3/5 0 0 0 1 1 1 g7 b\nE 3/6 0 0 0 1 1 1 g8 b\nE 3/7 0 0 0 1 1 1 g7 b (3/5 p2)\n"
            "n 1 0 0 0\nn 2 1 0 0\nn 3 0 1 0\nn 4 0 0 1\nN 3/5 4: \n"
            "e 1 4 3/5 g7 p: 1 2 3 4\ne 2 4 3/6 g8 p: 1 2 4 3\ne 3 4 3/7 g7 p2: 1 3 2 4\n");
}

TEST(MeshViews, SecondOrderByItsCorners) {
  const Document document = rich();
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
  Document document = rich();
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
