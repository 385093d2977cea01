// SPDX-License-Identifier: GPL-3.0-or-later
// Formats that are read through Gmsh, in a process of its own: equal content if Gmsh wrote the file, meshed
// geometry, and unchanged doubles.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using ::testing::HasSubstr;

// Two tetrahedra with a common face. Each tetrahedron and the face have their own group, and the numbers have
// gaps.
const char* const two_tetrahedra =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n2 21 \"between\"\n3 11 \"steel\"\n3 12 \"air\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 1 2\n1 0 0 0 1 1 0 1 21 0\n1 0 0 0 1 1 1 1 11 0\n2 0 0 -1 1 1 0 1 12 0\n$EndEntities\n"
    "$Nodes\n1 5 10 50\n3 1 0 5\n10\n20\n30\n40\n50\n0 0 0\n1 0 0\n0 1 0\n0.25 0.5 1\n0.125 0.25 "
    "-1\n$EndNodes\n"
    "$Elements\n3 3 1 9\n2 1 2 1\n1 10 20 30\n3 1 4 1\n5 10 20 30 40\n3 2 4 1\n9 10 30 20 50\n$EndElements\n";

// Elements as their corners' points and their blocks' groups, which do not depend on any numbering.
using Point = std::array<double, 3>;
using Elements = std::multiset<std::pair<std::set<std::int64_t>, std::vector<Point>>>;

Elements elements_of(const Document& document, bool groups) {
  Elements all;
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e) {
      std::vector<Point> corners;
      for (int k = 0; k < block.nodes_each; ++k) {
        const Index node = document.connectivity[block.nodes + e * block.nodes_each + k];
        const auto& p = document.points.at(static_cast<std::size_t>(node));
        corners.push_back({p.x(), p.y(), p.z()});
      }
      const auto& tags = document.tag_sets[block.groups];
      all.insert(
          {groups ? std::set<std::int64_t>(tags.begin(), tags.end()) : std::set<std::int64_t>{}, corners});
    }
  return all;
}

std::set<std::string> names_of(const Document& document) {
  std::set<std::string> all;
  for (const GroupName& name : document.group_names)
    all.insert(std::to_string(name.dim) + " " + std::to_string(name.group) + " " + name.name);
  return all;
}

/// Converts a file of the folder to .msh with tetproof-convert, and reads the result.
Document converted(const ScratchFolder& folder, const std::string& in) {
  const Outcome run =
      run_program({program("tetproof-convert"), in, "converted.msh", "--binary"}, {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 0) << run;
  return read_document(folder / "converted.msh");
}

struct SolverFile {
  const char* ending;
  bool tetrahedra, groups, names;
};
class ThroughGmsh : public testing::TestWithParam<SolverFile> {};

TEST_P(ThroughGmsh, EqualContent) {
  if (!have_tool("gmsh")) GTEST_SKIP() << "gmsh is not installed";
  const ScratchFolder folder;
  const Document original = read_document(folder.write("a.msh", two_tetrahedra));
  const std::string in = std::string("a.") + GetParam().ending;
  ASSERT_EQ(run_program({"gmsh", "a.msh", "-0", "-save_all", "-o", in}, {.directory = folder / ""}).exit_code,
            0);
  const Document read = converted(folder, in);
  Elements expected = elements_of(original, GetParam().groups);
  if (!GetParam().tetrahedra)
    std::erase_if(expected, [](const auto& element) { return element.second.size() != 3; });
  EXPECT_EQ(elements_of(read, GetParam().groups), expected);
  if (GetParam().tetrahedra) {
    EXPECT_EQ(read.points.size(), original.points.size());
  }
  if (GetParam().names) {
    EXPECT_EQ(names_of(read), names_of(original));
  }
}

INSTANTIATE_TEST_SUITE_P(GmshImport, ThroughGmsh,
                         testing::Values(SolverFile{"unv", true, true, true},
                                         SolverFile{"bdf", true, false, false},
                                         SolverFile{"nas", true, false, false},
                                         SolverFile{"ply2", false, false, false}),
                         [](const auto& test) { return std::string(test.param.ending); });

TEST(GmshImport, GeometryIsMeshed) {
  const ScratchFolder folder;
  folder.write("box.geo",
               "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 1, 1/3};\n"
               "Physical Volume(\"steel part\", 7) = {1};\nPhysical Surface(\"left\", 8) = {1};\n");
  const Outcome run = run_program({program("tetproof-convert"), "box.geo", "box.msh", "--json", "-"},
                                  {.directory = folder / ""});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.err, HasSubstr("warning: box.geo: Gmsh: the file holds geometry, and its mesh is Gmsh 4."));
  EXPECT_THAT(run.out, HasSubstr("\"format\": \"gmsh:geo\""));
  EXPECT_THAT(run.out, HasSubstr("\"file\": \"box.geo\""));
  const Document read = read_document(folder / "box.msh");
  EXPECT_EQ(names_of(read), (std::set<std::string>{"2 8 left", "3 7 steel part"}));
  const TetMesh mesh = tet_mesh(read);
  ASSERT_GT(mesh.tets.size(), 5u);
  double volume = 0;
  for (const auto& t : mesh.tets) {
    const Eigen::Vector3d a = mesh.points[t[0]];
    volume += (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).dot(mesh.points[t[3]] - a) / 6;
  }
  EXPECT_NEAR(volume, 2.0 / 3, 1e-14);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"box.geo", "box.msh"}));
}

TEST(GmshImport, WhatIsNoMeshIsListedAsDropped) {
  const ScratchFolder folder;
  folder.write("box.geo",
               "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 1, 1};\n"
               "View \"a pressure\" {\nSP(0,0,0){1};\n};\n");
  const Outcome run = run_program({program("tetproof-convert"), "box.geo", "box.msh", "--strict"},
                                  {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 1) << run;
  // 8 points, 12 curves, 6 surfaces and a volume.
  EXPECT_THAT(run.err, HasSubstr("not read: geometry of entities: 27 ("));
  EXPECT_THAT(run.err, HasSubstr(" of dimension 3 and tag 1)\n"));
  EXPECT_THAT(run.err, HasSubstr("not read: views of values: 1 (a pressure)\n"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"box.geo"});
}

TEST(GmshImport, WhatAScriptMeshedStaysAsItIs) {
  const ScratchFolder folder;
  folder.write("a.geo",
               "Point(1) = {0, 0, 0, 1}; Point(2) = {1, 0, 0, 1}; Line(1) = {1, 2};\n"
               "Transfinite Curve {1} = 4; Mesh 1; Mesh.Binary = 0; Mesh.MshFileVersion = 2.2;\n");
  const Document read = converted(folder, "a.geo");
  EXPECT_EQ(read.elements(), 5u);  // three lines, two points
}

TEST(GmshImport, EveryDoubleIsTheOneThatGmshHas) {
  const ScratchFolder folder;
  std::string points;
  // Gmsh reads the numbers of a .p3d in free format: a cell of 2 x 2 x 2 points, all x, all y, all z.
  const std::vector<const char*> x{"0.30000000000000004",    "1.0000000000000002",      "-0", "4.9e-324",
                                   "1.7976931348623157e308", "2.2250738585072009e-308", "3",  "0.1"};
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 8; ++i)
      points += std::string(axis == 0 ? x[i] : i >> axis & 1 ? "1" : "0") + " ";
  folder.write("a.p3d", "1\n2 2 2\n" + points + "\n");
  const Document read = converted(folder, "a.p3d");
  std::multiset<std::string> found, expected;
  for (const auto& p : read.points) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", p.x());
    found.insert(text);
  }
  for (const char* number : x) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", std::strtod(number, nullptr));
    expected.insert(text);
  }
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace tetproof::test
