// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/meshing/mesher.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "corpus/meshing/nesting.hpp"
#include "corpus/meshing/surface_input.hpp"
#include "corpus/meshing/text_digits.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/run_program.hpp"

namespace tetproof::corpus {
namespace {

using Eigen::Vector3d;
using test::ScratchFolder;

/// Adds a box; `inwards`: its triangles' normals point into it.
void add_box(TriangleSurface& surface, const Vector3d& low, const Vector3d& high, bool inwards = false) {
  const auto first = static_cast<Index>(surface.vertices.size());
  for (int i = 0; i < 8; ++i)
    surface.vertices.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(),
                                  (i & 4 ? high : low).z());
  for (const std::array<Index, 4>& q : std::vector<std::array<Index, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    for (std::array<Index, 3> t : {std::array<Index, 3>{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}) {
      if (inwards) std::swap(t[1], t[2]);
      surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
}

/// A box with a cavity in which another box lies, and a box beside.
TriangleSurface boxes() {
  TriangleSurface s;
  add_box(s, Vector3d::Constant(1), Vector3d::Constant(3), true);
  add_box(s, Vector3d::Constant(0), Vector3d::Constant(4));
  add_box(s, Vector3d::Constant(1.5), Vector3d::Constant(2.5));
  add_box(s, {6, 0, 0}, {7, 1, 1});
  return s;
}

TEST(Nesting, OfBoxesInBoxes) {
  const Nesting parts = nesting(boxes());
  EXPECT_EQ(parts.parent, (std::vector<int>{1, -1, 0, -1}));
  EXPECT_EQ(parts.depth, (std::vector<int>{1, 0, 2, 0}));
}

TEST(Nesting, PointsLieBetweenTheParts) {
  const TriangleSurface s = boxes();
  const Nesting parts = nesting(s);
  const auto in = [](const Vector3d& p, double low, double high) {
    return (p.array() > low).all() && (p.array() < high).all();
  };
  const Vector3d cavity = point_in(s, parts, 0).value(), solid = point_in(s, parts, 1).value();
  EXPECT_TRUE(in(cavity, 1, 3) && !in(cavity, 1.5, 2.5)) << cavity.transpose();
  EXPECT_TRUE(in(solid, 0, 4) && !in(solid, 1 - 1e-15, 3 + 1e-15)) << solid.transpose();
  EXPECT_TRUE(in(point_in(s, parts, 2).value(), 1.5, 2.5));
}

TEST(Nesting, OfAShellThatIsOneUnitInTheLastPlaceAway) {
  TriangleSurface s;
  add_box(s, Vector3d::Constant(0), Vector3d::Constant(1));
  const double low = std::nextafter(0.0, 1.0), high = std::nextafter(1.0, 0.0);
  add_box(s, Vector3d::Constant(low), Vector3d::Constant(high), true);
  const Nesting parts = nesting(s);
  EXPECT_EQ(parts.parent, (std::vector<int>{-1, 0}));
  EXPECT_FALSE(point_in(s, parts, 0));  // no double lies between them
  EXPECT_TRUE(point_in(s, parts, 1));
}

TEST(SurfaceInput, TetGenGetsAPointInEachCavity) {
  const ScratchFolder folder;
  write_surface_input(folder / "s", ".smesh", boxes());
  const Document document = read_document(folder / "s.smesh");
  EXPECT_EQ(document.points.size(), 32u);
  EXPECT_EQ(document.elements(), 48u);
  ASSERT_EQ(document.holes.size(), 1u);
}

TEST(SurfaceInput, GmshGetsVolumesWithTheirCavities) {
  const ScratchFolder folder;
  const SurfaceInput input = write_surface_input(folder / "s", ".geo", boxes());
  EXPECT_EQ(input.files.size(), 2u);
  const std::string geo = folder.read("s.geo");
  EXPECT_NE(geo.find("Volume(2) = {2, 1};"), std::string::npos) << geo;
  EXPECT_NE(geo.find("Volume(3) = {3};"), std::string::npos);
  EXPECT_NE(geo.find("Volume(4) = {4};"), std::string::npos);
  EXPECT_EQ(geo.find("Volume(1)"), std::string::npos);
  EXPECT_EQ(read_surface(folder / "s.surface.msh").triangles.size(), 48u);
}

TEST(SurfaceInput, StlSaysWhatTheMesherGets) {
  const ScratchFolder folder;
  TriangleSurface s;
  add_box(s, Vector3d::Constant(0.1), Vector3d::Constant(1));
  const SurfaceInput input = write_surface_input(folder / "s", ".stl", s);
  ASSERT_TRUE(input.given);
  EXPECT_EQ(input.given->vertices[0].x(), static_cast<double>(0.1F));
  EXPECT_FALSE(write_surface_input(folder / "s", ".off", s).given);
  EXPECT_THROW(write_surface_input(folder / "s", ".nonsense", s), InputError);
}

TEST(TextDigits, OfNumbers) {
  EXPECT_EQ(most_digits("1 0 3\n"), 0);
  EXPECT_EQ(most_digits("0.5 1.25 -0.00312"), 3);
  EXPECT_EQ(most_digits("1.234567e-05"), 7);
  EXPECT_EQ(most_digits("0.10000000000000001"), 17);
  EXPECT_EQ(most_digits("x1.23456 1.2.3456 1.5e"), 0);
}

TEST(TextDigits, OfAFile) {
  const ScratchFolder folder;
  TriangleSurface s;
  add_box(s, Vector3d::Constant(0), Vector3d::Constant(1));
  TetMesh mesh;
  mesh.points = s.vertices;
  const std::string path = folder.write("m.mesh", "0.3333333 0.5 0");
  EXPECT_EQ(coordinate_digits(path, mesh, s), 0);  // every point is a vertex
  mesh.points.emplace_back(0.3333333, 0.5, 0);
  EXPECT_EQ(coordinate_digits(path, mesh, s), 7);
  EXPECT_EQ(coordinate_digits(folder.write("m.mesh", "0.25"), mesh, s), 6);
  EXPECT_EQ(coordinate_digits(folder.write("m.mesh", "0.12345678901234567"), mesh, s), 0);
  EXPECT_EQ(coordinate_digits(folder.write("m.mesh", std::string("0.333\0", 6)), mesh, s), 0);
}

TEST(CommandMesher, CopiesAMeshThatIsReadWithItsOutput) {
  const ScratchFolder folder;
  folder.write("ready.mesh",
               "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
               "Tetrahedra 1\n1 2 3 4 0\nEnd\n");
  CommandMesher command;
  command.words = {"sh", "-c", "echo \"Warning: $0 $1\"; cp ready.mesh {mesh}; test -s {surface}", "{size}",
                   "{box}"};
  command.mesh_ending = ".mesh";
  command.name = "copy";
  const auto mesher = command_mesher(command);
  TriangleSurface s;
  add_box(s, Vector3d::Constant(0), Vector3d(3, 4, 12));
  const MesherRun run = mesher->run(s, folder.path(), {});
  EXPECT_FALSE(run.failure) << run.message;
  EXPECT_EQ(run.mesh.tets.size(), 1u);
  EXPECT_EQ(run.warnings, std::vector<std::string>{"Warning: 1.08333 13"});
  EXPECT_EQ(mesher->command(),
            "sh -c 'echo \"Warning: $0 $1\"; cp ready.mesh {mesh}; test -s {surface}' {size} {box}");
  // The mesh of this run must not be taken for the next one's.
  command.words = {"true", "{surface}", "{mesh}"};
  EXPECT_EQ(command_mesher(command)->run(s, folder.path(), {}).failure, Outcome::no_output);
  command.words = {"sh", "-c", "echo nonsense > {mesh}; : {surface}"};
  EXPECT_EQ(command_mesher(command)->run(s, folder.path(), {}).failure, Outcome::unreadable);
}

TEST(CommandMesher, RefusesWhatCannotRun) {
  CommandMesher command;
  EXPECT_THROW(command_mesher(command), InputError);
  command.words = {"true", "{mesh}"};
  EXPECT_THROW(command_mesher(command), InputError);
  command.words = {"no-such-program", "{surface}"};
  EXPECT_THROW(command_mesher(command), InputError);
}

TEST(FunctionMesher, ItsExceptionsAreRefusals) {
  const ScratchFolder folder;
  const auto run = [&folder](MeshFunction f) {
    return function_mesher(std::move(f))->run({}, folder.path(), {});
  };
  EXPECT_EQ(run([](const TriangleSurface&) -> TetMesh { throw std::runtime_error("no 7"); }).signature,
            "no #");
  EXPECT_EQ(run([](const TriangleSurface&) -> TetMesh { throw 3; }).failure, Outcome::refused);
  EXPECT_EQ(run([](const TriangleSurface&) -> TetMesh { throw std::bad_alloc(); }).failure,
            Outcome::out_of_memory);
  EXPECT_EQ(run([](const TriangleSurface&) { return TetMesh{}; }).failure, Outcome::no_tetrahedra);
  const MesherRun good = run([](const TriangleSurface&) {
    return TetMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  });
  EXPECT_FALSE(good.failure);
  EXPECT_TRUE(folder.has("mesh.msh"));
}

TEST(Presets, NamesAndTheirErrors) {
  const auto variants = preset_variants("tetgen");
  EXPECT_EQ(variants.at(0), "tetgen,pY");
  EXPECT_NE(std::find(variants.begin(), variants.end(), "tetgen,pqa"), variants.end());
  EXPECT_EQ(preset_variants("hxt,2"), std::vector<std::string>{"hxt,2"});
  EXPECT_THROW(preset_variants("nonsense"), InputError);
  EXPECT_THROW(preset_mesher("hxt,nonsense", "/bin/true"), InputError);
  EXPECT_THROW(preset_mesher("tetgen", "/no/such/tetgen"), InputError);
  EXPECT_NE(list_presets().find("tetgen -pqa{volume} {surface}"), std::string::npos);
}

/// Boxes in boxes, by every mesher that is here: 4^3 - 2^3 + 1 + 1 = 58 of volume.
TEST(Presets, FillSolidsAndLeaveCavities) {
  TriangleSurface s = boxes();
  int run_of_them = 0;
  for (const char* name : {"tetgen,pY", "tetgen,pqa", "gmsh,delaunay", "hxt,1-fine", "netgen"}) {
    std::unique_ptr<Mesher> mesher;
    try {
      mesher = preset_mesher(name);
    } catch (const InputError&) {
      continue;  // not installed here
    }
    const ScratchFolder folder;
    const MesherRun run = mesher->run(s, folder.path(), {20, 60, 2000});
    ASSERT_FALSE(run.failure) << name << ": " << run.output;
    double six = 0;
    for (const auto& t : run.mesh.tets) {
      const auto at = [&](int k) {
        return run.mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
      };
      six += (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0));
    }
    EXPECT_NEAR(six / 6, 58, 1e-9) << name;
    EXPECT_FALSE(mesher->version().empty()) << name;
    ++run_of_them;
  }
  if (run_of_them == 0) GTEST_SKIP() << "no mesher is installed";
}

TEST(Outcomes, NamesAndBack) {
  for (int i = 0; i < outcome_count; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    EXPECT_EQ(outcome_of_name(name_of(outcome)), outcome);
  }
  EXPECT_FALSE(outcome_of_name("nonsense"));
  EXPECT_TRUE(is_finding(Outcome::refused_valid));
  EXPECT_FALSE(is_finding(Outcome::slow));
}

}  // namespace
}  // namespace tetproof::corpus
