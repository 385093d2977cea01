// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs open what tetproof-convert writes without a warning and understand it: the same tetrahedra,
// and the same coordinates bit by bit if the program keeps doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

const std::vector<std::array<double, 3>> points{
    {0.1 + 0.2, -0.0, 1.0 / 3},
    {1.1, 0.7, 1e-300},
    {0.123456789012345678, 1.9999999999999998, 17.000000000000004 / 1e3},
    {0.25, 2.0 / 7, 1.3},
    {1.2345678901234567, 1.4142135623730951, 1.7320508075688772}};
const std::vector<std::array<int, 4>> tets{{0, 1, 2, 3},
                                           {1, 4, 2, 3}};  // positive: 0 1 2 are anticlockwise as seen from 3

std::string with_17_digits(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// The listing that the tools are asked to print: the bits of each coordinate, then the points of each
/// tetrahedron, from 0.
std::string expected_listing() {
  std::string text;
  char line[80];
  for (const auto& p : points) {
    std::snprintf(line, sizeof line, "%016llx %016llx %016llx\n", std::bit_cast<unsigned long long>(p[0]),
                  std::bit_cast<unsigned long long>(p[1]), std::bit_cast<unsigned long long>(p[2]));
    text += line;
  }
  for (const auto& t : tets) {
    std::snprintf(line, sizeof line, "%d %d %d %d\n", t[0], t[1], t[2], t[3]);
    text += line;
  }
  return text;
}

void write_mesh(const ScratchFolder& folder) {
  std::string nodes = "5 3\n", elements = "2 4\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    nodes += std::to_string(i + 1) + " " + with_17_digits(points[i][0]) + " " + with_17_digits(points[i][1]) +
             " " + with_17_digits(points[i][2]) + "\n";
  for (std::size_t t = 0; t < tets.size(); ++t) {
    elements += std::to_string(t + 1);
    for (int node : tets[t]) elements += " " + std::to_string(node + 1);
    elements += "\n";
  }
  folder.write("in.node", nodes);
  folder.write("in.ele", elements);
}

void convert(const ScratchFolder& folder, const std::string& in, const std::string& out,
             const std::vector<std::string>& options = {}) {
  std::vector<std::string> command{program("tetproof-convert"), in, out};
  command.insert(command.end(), options.begin(), options.end());
  const Outcome run = run_program(command, {.directory = folder / ""});
  ASSERT_EQ(run.exit_code, 0) << run;
}

std::vector<std::string> strictly(std::vector<std::string> options) {
  options.push_back("--strict");
  return options;
}

bool says(std::string text, const std::string& word) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text.find(word) != text.npos;
}

struct Written {
  const char* name;
  const char* file;
  std::vector<std::string> options;

  friend void PrintTo(const Written& test, std::ostream* out) { *out << test.name; }
};

const std::vector<Written> msh_files{{"Msh41Text", "out.msh", {}},
                                     {"Msh41Binary", "out.msh", {"--binary"}},
                                     {"Msh22Text", "out.msh", {"--to", "msh22"}},
                                     {"Msh22Binary", "out.msh", {"--to", "msh22", "--binary"}}};

// meshio does not read text of version 4.0, not even Gmsh's own.
std::vector<Written> gmsh_files() {
  std::vector<Written> all = msh_files;
  all.push_back({"Msh40Text", "out.msh", {"--to", "msh40"}});
  return all;
}

std::vector<Written> all_files() {
  std::vector<Written> all = msh_files;
  all.push_back({"VtuBinary", "out.vtu", {}});
  all.push_back({"VtuText", "out.vtu", {"--ascii"}});
  all.push_back({"Tetgen", "out.node", {}});
  return all;
}

class OpenedByGmsh : public testing::TestWithParam<Written> {};

TEST_P(OpenedByGmsh, WithoutAWarningAndWithEqualContent) {
  if (!have_tool("gmsh")) GTEST_SKIP() << "gmsh is not installed";
  const ScratchFolder folder;
  write_mesh(folder);
  convert(folder, "in.node", GetParam().file, strictly(GetParam().options));
  // Gmsh writes the file again as binary, which keeps every bit. The result is compared with the original.
  const Outcome run =
      run_program({"gmsh", GetParam().file, "-0", "-bin", "-format", "msh41", "-save_all", "-o", "back.msh"},
                  {.directory = folder / ""});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_FALSE(says(run.out + run.err, "warning") || says(run.out + run.err, "error")) << run;
  EXPECT_TRUE(says(run.out + run.err, "5 nodes") && says(run.out + run.err, "2 elements")) << run;
  // The comments differ: they have the box of the entity, which Gmsh enlarges a little.
  convert(folder, "back.msh", "back.node");
  convert(folder, "in.node", "again.node");
  const std::string back = folder.read("back.node");
  EXPECT_EQ(back.substr(0, back.find("#: ")), folder.read("again.node"));
  EXPECT_EQ(folder.read("back.ele"), folder.read("again.ele"));
}

INSTANTIATE_TEST_SUITE_P(Interoperability, OpenedByGmsh, testing::ValuesIn(gmsh_files()),
                         [](const auto& test) { return test.param.name; });

TEST(OpenedByTetgen, ConsistentAndWithEqualContent) {
  if (!have_tool("tetgen")) GTEST_SKIP() << "tetgen is not installed";
  const ScratchFolder folder;
  write_mesh(folder);
  convert(folder, "in.node", "middle.msh", {"--binary"});
  convert(folder, "middle.msh", "out.1.ele");
  const Outcome run = run_program({"tetgen", "-rC", "out.1"}, {.directory = folder / ""});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_TRUE(says(run.out, "appears to be consistent")) << run;
  EXPECT_FALSE(says(run.out + run.err, "warning") || says(run.out + run.err, "error")) << run;
  // TetGen writes what it understood as further files, with 16 digits.
  std::istringstream nodes(folder.read("out.2.node")), elements(folder.read("out.2.ele"));
  std::string line;
  int count = 0, number = 0;
  nodes >> count;
  std::getline(nodes, line);
  ASSERT_EQ(count, 5);
  for (const auto& p : points) {
    double x = 0, y = 0, z = 0;
    nodes >> number >> x >> y >> z;
    std::getline(nodes, line);
    EXPECT_LT(std::abs(x - p[0]) + std::abs(y - p[1]) + std::abs(z - p[2]), 1e-15) << "node " << number;
  }
  elements >> count;
  std::getline(elements, line);
  ASSERT_EQ(count, 2);
  std::set<std::set<int>> found, expected;
  for (int t = 0; t < 2; ++t) {
    std::array<int, 4> n{};
    elements >> number >> n[0] >> n[1] >> n[2] >> n[3];
    std::getline(elements, line);
    found.insert({n.begin(), n.end()});
    expected.insert({tets[t][0] + 1, tets[t][1] + 1, tets[t][2] + 1, tets[t][3] + 1});
  }
  EXPECT_EQ(found, expected);
}

constexpr const char* python = "/usr/bin/python3";  // the one that Debian's packages belong to

bool python_has(const std::string& module) {
  return run_program({python, "-c", "import " + module}).exit_code == 0;
}

const std::string print_bits =
    "import struct\n"
    "def show(points, tets):\n"
    "  for p in points: print(*('%016x' % struct.unpack('<Q', struct.pack('<d', x))[0] for x in p))\n"
    "  for t in tets: print(*t)\n";

class OpenedByVtk : public testing::TestWithParam<Written> {};

TEST_P(OpenedByVtk, WithoutAWarningAndWithEqualContent) {
  if (!python_has("vtk")) GTEST_SKIP() << "VTK's Python module is not installed";
  const ScratchFolder folder;
  write_mesh(folder);
  convert(folder, "in.node", GetParam().file, strictly(GetParam().options));
  const Outcome run = run_program(
      {python, "-c",
       print_bits +
           "import vtk\n"
           "r = vtk.vtkXMLUnstructuredGridReader()\n"
           "r.SetFileName('out.vtu')\n"
           "r.Update()\n"
           "g = r.GetOutput()\n"
           "assert all(g.GetCellType(c) == 10 for c in range(g.GetNumberOfCells()))\n"
           "show([g.GetPoint(i) for i in range(g.GetNumberOfPoints())],\n"
           "     [[g.GetCell(c).GetPointId(k) for k in range(4)] for c in range(g.GetNumberOfCells())])\n"},
      {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(run.out, expected_listing()) << run;
  EXPECT_EQ(run.err, "");
}

INSTANTIATE_TEST_SUITE_P(Interoperability, OpenedByVtk,
                         testing::Values(Written{"Binary", "out.vtu", {}},
                                         Written{"Text", "out.vtu", {"--ascii"}}),
                         [](const auto& test) { return test.param.name; });

class OpenedByMeshio : public testing::TestWithParam<Written> {};

TEST_P(OpenedByMeshio, WithoutAWarningAndWithEqualContent) {
  if (!python_has("meshio")) GTEST_SKIP() << "meshio is not installed";
  const ScratchFolder folder;
  write_mesh(folder);
  convert(folder, "in.node", GetParam().file, strictly(GetParam().options));
  const Outcome run = run_program({python, "-c",
                                   print_bits + "import meshio, sys\n"
                                                "m = meshio.read(sys.argv[1])\n"
                                                "assert len(m.cells) == 1 and m.cells[0].type == 'tetra'\n"
                                                "show(m.points, m.cells[0].data)\n",
                                   GetParam().file},
                                  {.directory = folder / ""});
  EXPECT_EQ(run.exit_code, 0) << run;
  // meshio prints a blank line after it reads some formats.
  EXPECT_EQ(run.out.substr(run.out.find_first_not_of('\n')), expected_listing()) << run;
  EXPECT_EQ(run.err, "");
}

INSTANTIATE_TEST_SUITE_P(Interoperability, OpenedByMeshio, testing::ValuesIn(all_files()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tetproof::test
