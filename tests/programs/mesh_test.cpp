// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh as a user runs it: grids of real surfaces, refusals, options, JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/cube_files.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string shipped = TETPROOF_SOURCE_DIR "/corpus/surfaces/";
const std::string shared = TETPROOF_SOURCE_DIR "/../shared/surfaces/";

// The path of a surface of the collection, or else of the project's own copy.
std::string collected(const std::string& file) {
  return std::filesystem::exists(shared + file) ? shared + file : shipped + file;
}

Outcome mesh(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program("tetproof-mesh"));
  return run_program(arguments, {.timeout_s = 600});
}

// Every clean surface of the collection gives a certified grid, at 24 and at 64 cells, inside and outside.
struct Surface {
  const char* name;
  const char* file;
};
const Surface clean[] = {{"sphere", "unit_sphere.STL"},    {"torus", "torus.STL"},
                         {"wing", "NACA0012.obj"},         {"spot", "spot.obj"},
                         {"dog_skull", "BONESkull.stl"},   {"plate", "plate_holes.STL"},
                         {"tray", "1002_tray_bottom.STL"}, {"shell", "Cray_left.obj"},
                         {"hulls", "hull-body.obj"},       {"skull", "ct_skull.off"}};

class CleanSurfaces : public testing::TestWithParam<std::tuple<Surface, const char*, const char*>> {};

TEST_P(CleanSurfaces, GiveACertifiedGrid) {
  const auto& [surface, cells, region] = GetParam();
  const std::string file = collected(surface.file);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "neither ../shared/surfaces nor corpus/surfaces has it";
  const ScratchFolder folder;
  // Coarse grids are adapted, which is the default. Fine grids test steps (i) to (iv) alone.
  const bool adapted = std::string(cells) == "24";
  const Outcome run = mesh({file, "-o", folder / "grid.msh", "--binary", "--cells", cells, "--region", region,
                            "--points", adapted ? "auto" : "0", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const json report = json::parse(run.out);
  EXPECT_EQ(report.contains("adaptation"), adapted && report["generation"]["first_grid"]["tets"] > 0);
  EXPECT_EQ(report["verdict"], "sound");
  EXPECT_EQ(report["certificate"], true);
  EXPECT_TRUE(folder.has("grid.msh"));
  for (const json& check : report["checks"])
    if (check["id"] == "volume-surface" || check["id"] == "volume-voxel") {
      EXPECT_EQ(check["verdict"], "pass") << check.dump(1);
    } else if (check["id"] == "surface-to-mesh" || check["id"] == "missing-region") {
      EXPECT_THAT(check["verdict"], testing::AnyOf("pass", "warning"))
          << "what is thinner than a cell is lost";
    } else if (check["id"] == "off-surface-vertex" || check["id"] == "mesh-to-surface" ||
               check["id"] == "excess-region") {
      EXPECT_EQ(check["verdict"], "pass") << check.dump(1);
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, CleanSurfaces,
                         testing::Combine(testing::ValuesIn(clean), testing::Values("24", "64"),
                                          testing::Values("inside", "outside")),
                         [](const auto& each) {
                           return std::string(std::get<0>(each.param).name) + "_" + std::get<1>(each.param) +
                                  "_" + std::get<2>(each.param);
                         });

// Bad surfaces are refused with one line and exit code 2, and no file is written.
struct Bad {
  const char* name;
  std::string file;
  const char* says;
};
const Bad bad[] = {
    {"open", "sphereWithHole.stl", "the surface is open: 9 edges have one triangle (first: "},
    {"crossing", "self_intersectA.obj",
     "the surface intersects itself: 338 pairs of triangles meet (first: "},
    {"touching", "shared.STL", "the surface is not manifold: 1 edge has more than two triangles (first: "},
    {"turned", "simpleCar.stl",
     "the surface is not consistently oriented: component 0 (3142 triangles from facet 1 at (-0.4, -1.5, "
     "2.4492936e-17), volume -2.449"},
    {"everything", "hat_skull.stl", "the surface is open: 84 edges have one triangle (first: "},
};
class BadSurfaces : public testing::TestWithParam<Bad> {};

TEST_P(BadSurfaces, AreRefusedInOneLine) {
  const std::string file = collected(GetParam().file);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "neither ../shared/surfaces nor corpus/surfaces has it";
  const ScratchFolder folder;
  const Outcome run = mesh({file, "-o", folder / "grid.msh"});
  EXPECT_EQ(run.exit_code, 2) << run;
  EXPECT_EQ(lines(run.err), 1u) << run;
  EXPECT_THAT(run.err, HasSubstr(file + ": " + GetParam().says));
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(folder.names().empty());
}
INSTANTIATE_TEST_SUITE_P(Shared, BadSurfaces, testing::ValuesIn(bad),
                         [](const auto& each) { return each.param.name; });

TEST(Mesh, WritesWhatItCounted) {
  const ScratchFolder folder;
  const Outcome run =
      mesh({shipped + "spot.obj", "-o", folder / "spot.node", "--json", folder / "spot.json"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"spot.ele", "spot.json", "spot.node"}));
  const json report = json::parse(folder.read("spot.json"));
  std::istringstream nodes(folder.read("spot.node")), tets(folder.read("spot.ele"));
  std::int64_t node_count = 0, tet_count = 0;
  nodes >> node_count;
  tets >> tet_count;
  EXPECT_EQ(report["mesh"]["points"], node_count);
  EXPECT_EQ(report["mesh"]["tets"], tet_count);
  EXPECT_THAT(run.out, HasSubstr("written: " + folder / "spot.node"));
}

TEST(Mesh, JsonHasTheAgreedKeys) {
  const ScratchFolder folder;
  const Outcome run =
      mesh({"torus:R=1,r=0.4,n=2000", "-o", folder / "t.msh", "--cells", "20", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const json generation = json::parse(run.out)["generation"];
  EXPECT_EQ(generation["surface"]["file"], "torus:R=1,r=0.4,n=2000");
  EXPECT_EQ(generation["surface"]["components"], 1);
  EXPECT_EQ(generation["surface"]["orientation"], "outward");
  const auto cells = generation["lattice"]["cells"].get<std::array<std::int64_t, 3>>();
  EXPECT_EQ(cells, (std::array<std::int64_t, 3>{20, 20, 6}));  // 2.8 : 2.8 : 0.8 = 20 : 20 : 5.7
  EXPECT_EQ(generation["lattice"]["points"], 21 * 21 * 7);
  EXPECT_EQ(generation["lattice"]["tets"], 6 * 20 * 20 * 6);
  std::int64_t cases = 0;
  for (const auto& [row, count] : generation["cases"].items()) cases += count.get<std::int64_t>();
  EXPECT_EQ(cases, 6 * 20 * 20 * 6) << "every lattice tetrahedron is one case";
  EXPECT_EQ(generation["table3"].size(), 7u);
  EXPECT_EQ(generation["table3"]["3a"], 0);
  for (const char* key : {"moved_to_surface", "collapsed", "mended", "not_positive", "dropped_intersections"})
    EXPECT_TRUE(generation[key].is_number_integer()) << key;
}

// A solid gives the same grid from every format, whether its faces are triangles, quadrangles or both.
TEST(Mesh, TakesACubeFromEveryFormat) {
  const ScratchFolder folder;
  std::string first;
  for (const std::string& ending : cube_endings)
    for (const std::size_t cut : {6, 0, 3}) {
      const Outcome run = mesh({folder.write("cube" + ending, cube_file(ending, cube_faces(cut))), "-o",
                                folder / "grid.msh", "--cells", "4", "--json", "-"});
      ASSERT_EQ(run.exit_code, 0) << ending << cut << run;
      const json report = json::parse(run.out);
      EXPECT_NEAR(report["surface"]["volume"].get<double>(), 1, 1e-15) << ending << cut;
      if (first.empty()) first = folder.read("grid.msh");
      EXPECT_EQ(folder.read("grid.msh"), first) << ending << cut;
    }
}

TEST(Mesh, AnInwardSurfaceIsNoFault) {
  const ScratchFolder folder;
  std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n";
  const Outcome run = mesh({folder.write("in.off", off), "-o", folder / "g.msh", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.err, HasSubstr("inward"));
  const json report = json::parse(run.out);
  EXPECT_EQ(report["generation"]["surface"]["orientation"], "inward");
  EXPECT_GT(report["volume"]["mesh"], 0.1);
}

// One of the two says that the surface is inside out.
TEST(Mesh, NormalsThatContradictTheFacetsAreSaid) {
  const ScratchFolder folder;
  std::string stl = "solid\n";
  for (const char* corners : {"0 0 0 vertex 0 1 0 vertex 1 0 0", "0 0 0 vertex 1 0 0 vertex 0 0 1",
                              "1 0 0 vertex 0 1 0 vertex 0 0 1", "0 0 0 vertex 0 0 1 vertex 0 1 0"})
    stl += std::string("facet normal -1 -1 -1 outer loop vertex ") + corners + " endloop endfacet\n";
  const Outcome run = mesh({folder.write("a.stl", stl), "-o", folder / "g.msh", "--cells", "4"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.err,
              HasSubstr("not read: normals that point against the order of the corners: 1 (line 4)\n"));
}

TEST(Mesh, AnEmptyGridIsSaidAndIsNotCertified) {
  const ScratchFolder folder;
  const Outcome run =
      mesh({"box:x0=0,x1=10,y0=0,y1=10,z0=0,z1=0.05", "-o", folder / "g.msh", "--cells", "3,3,1"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_THAT(
      run.err,
      HasSubstr("the grid is empty: the surface is thinner than the lattice of 3 cells everywhere; use "
                "more --cells"));
  EXPECT_THAT(run.out, HasSubstr("incomplete: no certificate, the mesh is empty; warnings: topology, "
                                 "surface-to-mesh; not judged: mesh\n"));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("certified")));
}

// A thin shell of which the tolerance takes the few vertices of the default lattice that are inside.
TEST(Mesh, AThinSurfaceGetsMoreCellsByDefault) {
  const ScratchFolder folder;
  std::vector<std::string> thin{TETPROOF_SOURCE_DIR "/corpus/surfaces/Cray_left.obj", "--on-surface", "0.1"};
  for (const std::string& word : {std::string("--points"), std::string("0"), std::string("--voxels"),
                                  std::string("0"), std::string("-o"), folder / "g.msh"})
    thin.push_back(word);
  const Outcome run = mesh(thin);
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.err,
              HasSubstr("the grid with 24 cells is empty, because the surface is thin: 96 are taken"));
  thin.insert(thin.end(), {"--cells", "24"});
  const Outcome told = mesh(thin);
  EXPECT_EQ(told.exit_code, 1) << told;
}

TEST(Mesh, VerticesThatNoTriangleNamesDoNotCount) {
  const ScratchFolder folder;
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const Outcome plain = mesh({folder.write("a.obj", corners + faces), "-o", folder / "a.msh", "--curvature"});
  const Outcome stray = mesh({folder.write("b.obj", corners + "v 9 9 9\nv 8 8 8\nl 5 6\n" + faces), "-o",
                              folder / "b.msh", "--curvature"});
  EXPECT_EQ(plain.exit_code, 0) << plain;
  EXPECT_EQ(stray.exit_code, 0) << stray;
  EXPECT_THAT(stray.err, HasSubstr("b.obj: without 2 vertices that no triangle names"));
  EXPECT_EQ(folder.read("a.msh"), folder.read("b.msh"));
}

TEST(Mesh, FarFromTheOriginItGoesWithoutVoxels) {
  const ScratchFolder folder;
  const Outcome run = mesh({"box:x0=999999999996,x1=1e12,y0=0,y1=4,z0=0,z1=4", "-o", folder / "g.msh"});
  EXPECT_EQ(run.exit_code, 4) << run;
  EXPECT_THAT(run.out, HasSubstr("incomplete: certified"));
  EXPECT_THAT(run.out, HasSubstr("no voxel account: the surface is too far from the origin"));
}

TEST(Mesh, ATerminalSeesProgressAndAnEstimate) {
  if (!have_tool("script")) GTEST_SKIP() << "script, of bsdutils, is not installed";
  const ScratchFolder folder;
  const std::string command =
      program("tetproof-mesh") + " sphere -o " + (folder / "g.msh") + " --binary --cells 150 --points 0";
  const Outcome shown = run_program({"script", "-qec", command, "/dev/null"},
                                    {.timeout_s = 600, .environment = {"TERM=xterm"}});
  EXPECT_EQ(shown.exit_code, 0) << shown;
  if (shown.seconds < 4) GTEST_SKIP() << "done in " << shown.seconds << " s: too fast for a progress line";
  EXPECT_THAT(shown.out, testing::ContainsRegex("[a-z]+: [0-9]+ s, about [0-9]+ s left"));
  EXPECT_THAT(shown.out, HasSubstr("\r\x1b[K"));
}

TEST(Mesh, LiteralReportsWhatRoundingDid) {
  const ScratchFolder folder;
  // Rounding puts lattice planes beside the cube's faces, so there are cuts close to vertices.
  const std::vector<std::string> cube{"box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4",
                                      "-o",
                                      folder / "g.msh",
                                      "--cells",
                                      "6",
                                      "--box-scale",
                                      "1.5",
                                      "--json",
                                      "-"};
  auto literal = cube, mended = cube;
  literal.push_back("--literal");
  mended.insert(mended.end(), {"--on-surface", "0"});
  const Outcome as_printed = mesh(literal), as_read = mesh(mended);
  EXPECT_EQ(as_printed.exit_code, 1) << as_printed;
  EXPECT_GT(json::parse(as_printed.out)["generation"]["not_positive"], 0);
  EXPECT_EQ(json::parse(as_printed.out)["certificate"], false);
  EXPECT_TRUE(folder.has("g.msh")) << "a grid with a defect is written all the same";
  EXPECT_EQ(as_read.exit_code, 0) << as_read;
  EXPECT_GT(json::parse(as_read.out)["generation"]["mended"], 0);
  EXPECT_EQ(json::parse(as_read.out)["generation"]["not_positive"], 0);
}

struct Usage {
  const char* name;
  std::vector<std::string> arguments;
  const char* says;
};
class WrongUsage : public testing::TestWithParam<Usage> {};

TEST_P(WrongUsage, IsOneLineAndExit2) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = GetParam().arguments;
  for (std::string& a : arguments)
    if (a.starts_with("OUT")) a = folder / ("grid" + a.substr(3));
  const Outcome run = mesh(arguments);
  EXPECT_EQ(run.exit_code, 2) << run;
  EXPECT_EQ(lines(run.err), 1u) << run;
  EXPECT_THAT(run.err, HasSubstr(GetParam().says));
  EXPECT_TRUE(folder.names().empty());
}

const Usage usages[] = {
    {"no_surface", {"-o", "OUT.msh"}, "expected a SURFACE"},
    {"no_grid", {"sphere"}, "expected -o GRID"},
    {"two_cells",
     {"sphere", "-o", "OUT.msh", "--cells", "4,4"},
     "--cells: expected one positive number or three, as in 24 or 24,12,12, found '4,4'"},
    {"no_cells",
     {"sphere", "-o", "OUT.msh", "--cells", "0"},
     "--cells: expected one positive number or three"},
    {"cells_of_words", {"sphere", "-o", "OUT.msh", "--cells", "4,4,x"}, "found '4,4,x'"},
    {"trailing_comma", {"sphere", "-o", "OUT.msh", "--cells", "4,4,4,"}, "found '4,4,4,'"},
    {"huge_lattice", {"sphere", "-o", "OUT.msh", "--cells", "99999999"}, "too large: more than 4e8 vertices"},
    {"small_box", {"sphere", "-o", "OUT.msh", "--box-scale", "1"}, "the box scale must be more than 1"},
    {"nan_box", {"sphere", "-o", "OUT.msh", "--box-scale", "nan"}, "the box scale must be more than 1"},
    {"large_tolerance",
     {"sphere", "-o", "OUT.msh", "--on-surface", "0.2"},
     "the on-surface tolerance must be 0 to 0.15"},
    {"nan_tolerance",
     {"sphere", "-o", "OUT.msh", "--on-surface", "nan"},
     "the on-surface tolerance must be 0 to 0.15"},
    {"points",
     {"sphere", "-o", "OUT.msh", "--points", "many"},
     "--points: expected a number or auto, found 'many'"},
    {"negative_points", {"sphere", "-o", "OUT.msh", "--points=-1"}, "--points: expected a number or auto"},
    {"v0", {"sphere", "-o", "OUT.msh", "--v0", "0"}, "v0: expected a positive number, found 0"},
    {"v0_of_words",
     {"sphere", "-o", "OUT.msh", "--v0", "abs:"},
     "--v0: expected a number, as in 0.2, or abs:0.001"},
    {"v1", {"sphere", "-o", "OUT.msh", "--v1", "abs:-1"}, "v1: expected a positive number"},
    {"tiny_volumes",
     {"sphere", "-o", "OUT.msh", "--v0", "1e-9", "--v1", "1e-9"},
     "tetrahedra, more than 2e+08"},
    {"p", {"sphere", "-o", "OUT.msh", "--p", "nan"}, "p: expected a positive number"},
    {"d1", {"sphere", "-o", "OUT.msh", "--d1", "-2"}, "--d1"},
    {"improve", {"sphere", "-o", "OUT.msh", "--improve", "all"}, "--improve"},
    {"past_dilution", {"sphere", "-o", "OUT.msh", "--past-dilution"}, "expected a number of points with it"},
    {"follow_nothing", {"sphere", "--follow", "no-such-file.jsonl"}, "no-such-file.jsonl"},
    {"trace_nowhere",
     {"sphere", "-o", "OUT.msh", "--trace", "/no/such/folder/t.jsonl"},
     "/no/such/folder/t.jsonl"},
    {"region", {"sphere", "-o", "OUT.msh", "--region", "around"}, "--region"},
    {"unknown_ending", {"sphere", "-o", "OUT.xyz"}, ".xyz"},
    {"unknown_surface", {"spheer:r=1", "-o", "OUT.msh"}, "spheer"},
    {"bad_parameter", {"sphere:q=1", "-o", "OUT.msh"}, "q"},
};
INSTANTIATE_TEST_SUITE_P(Mesh, WrongUsage, testing::ValuesIn(usages),
                         [](const auto& each) { return each.param.name; });

TEST(Mesh, ListsItsSurfaces) {
  const Outcome run = mesh({"--list-surfaces"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* name : {"sphere", "torus", "wing", "random"}) EXPECT_THAT(run.out, HasSubstr(name));
}

}  // namespace
}  // namespace tetproof::test
