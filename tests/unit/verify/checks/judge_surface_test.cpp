// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of surfaces: the whole message for each fault, and real files against the values of their
// manifest.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "corpus/surfaces.hpp"
#include "io/surface_files.hpp"
#include "tests/support/meshes.hpp"
#include "verify/surface.hpp"

namespace tetproof::test {
namespace {

using verify::judge_surface;
using verify::SurfaceReport;

// A tetrahedron of vertices 0 to 3. All triangles are oriented outward.
TriangleSurface tetrahedron() {
  return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
          .parameters = {},
          .evaluate = {}};
}

TEST(SurfaceFaults, WholeMessages) {
  struct Case {
    std::string name;
    std::function<TriangleSurface()> make;
    std::string fault;
  };
  const std::vector<Case> cases{
      {"sound", tetrahedron, ""},
      {"empty", [] { return TriangleSurface{}; }, "the surface has no triangles"},
      {"index",
       [] {
         auto s = tetrahedron();
         s.triangles[2][1] = 4;
         return s;
       },
       "triangle 2 names vertex 4, expected one of 0..3"},
      {"NaN",
       [] {
         auto s = tetrahedron();
         s.vertices[3].y() = std::nan("");
         return s;
       },
       "vertex 3 of triangle 1 is not finite: (0, nan, 1)"},
      {"open",
       [] {
         auto s = tetrahedron();
         s.triangles.pop_back();
         return s;
       },
       "the surface is open: 3 edges have one triangle (first: 0-2 from (0, 0, 0) to (0, 1, 0), of triangle "
       "0)"},
      {"an edge of three",
       [] {
         auto s = tetrahedron();
         s.vertices.push_back({1, 1, 1});
         s.triangles.push_back({1, 2, 4});
         s.triangles.push_back({2, 1, 4});
         return s;
       },
       "the surface is not manifold: 1 edge has more than two triangles (first: 1-2 from (1, 0, 0) to (0, 1, "
       "0) has 4)"},
      {"two joined at a vertex",
       [] {
         auto s = together(tetrahedron(), tetrahedron());
         for (auto& v : s.vertices)
           if (&v - s.vertices.data() > 4) v = -v;
         for (std::size_t t = 4; t < 8; ++t) {
           for (Index& v : s.triangles[t])
             if (v == 4) v = 0;
           std::swap(s.triangles[t][1], s.triangles[t][2]);
         }
         return s;
       },
       "the surface is not manifold: 1 vertex has more than one fan of triangles (first: 0 at (0, 0, 0))"},
      {"one triangle turned",
       [] {
         auto s = tetrahedron();
         std::swap(s.triangles[2][0], s.triangles[2][1]);
         return s;
       },
       "the surface is not consistently oriented: 3 edges are run twice in the same direction (first: 1-2 "
       "from "
       "(1, 0, 0) to (0, 1, 0), by triangle 0 and triangle 2)"},
      {"no area",
       [] {
         auto s = tetrahedron();
         s.vertices[3] = {0.5, 0.5, 0};
         return s;
       },
       "1 triangle has no area (first: triangle 2 (1 2 3) at (1, 0, 0))"},
      {"a vertex twice",
       [] {
         auto s = tetrahedron();
         s.triangles.push_back({1, 1, 2});
         return s;
       },
       "1 triangle has no area (first: triangle 4 (1 1 2) at (1, 0, 0))"},
      {"a triangle twice",
       [] {
         auto s = tetrahedron();
         s.vertices.insert(s.vertices.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
         s.triangles.push_back({4, 5, 6});
         s.triangles.push_back({6, 5, 4});
         return s;
       },
       "1 triangle is listed twice (first: triangle 4 (4 5 6) at (5, 0, 0) and triangle 5)"},
      {"crossing itself",
       [] {
         return together(tetrahedron(), [] {
           auto s = tetrahedron();
           for (auto& v : s.vertices) v += Eigen::Vector3d(0.25, 0.25, -0.5);
           return s;
         }());
       },
       "the surface intersects itself: 6 pairs of triangles meet (first: triangle 0 (0 2 1) at (0, 0, 0) and "
       "triangle 5 (4 5 7) at (0.25, 0.25, -0.5))"},
      {"side by side, one inside out",
       [] {
         return together(tetrahedron(), flipped(box_surface({2, 2, 2}, 1)));
       },
       "the surface is not consistently oriented: component 1 (12 triangles from triangle 4 (4 6 5) at (2, "
       "2, 2), volume -1) is inward, "
       "but component 0 (4 triangles "
       "from triangle 0 (0 2 1) at (0, 0, 0), volume 0.166667) is outward, none of them in a cavity"},
      {"two in one, one inside out",
       [] {
         return together(box_surface({0, 0, 0}, 8),
                         together(box_surface({1, 1, 1}, 1), flipped(box_surface({4, 4, 4}, 1))));
       },
       "the surface is not consistently oriented: component 2 (12 triangles from triangle 24 (16 18 17) at "
       "(4, 4, "
       "4), volume -1) is inward, "
       "but component 1 (12 triangles "
       "from triangle 12 (8 9 10) at (1, 1, 1), volume 1) is outward, all of them inside others"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(judge_surface(c.make()).fault, c.fault);
  }
}

TEST(SurfaceFaults, InwardIsANote) {
  const SurfaceReport inward = judge_surface(flipped(tetrahedron()));
  EXPECT_EQ(inward.fault, "");
  ASSERT_EQ(inward.notes.size(), 1u);
  EXPECT_THAT(inward.notes[0], testing::HasSubstr("inward"));
  EXPECT_FALSE(inward.components[0].outward);
  EXPECT_DOUBLE_EQ(inward.volume, 1.0 / 6);
  EXPECT_TRUE(judge_surface(tetrahedron()).notes.empty());
}

TEST(SurfaceFaults, AShellThatPointsOutwardInsideAnotherIsANote) {
  const SurfaceReport same_way =
      judge_surface(together(box_surface({0, 0, 0}, 4), box_surface({1, 1, 1}, 1)));
  EXPECT_EQ(same_way.fault, "");
  EXPECT_EQ(same_way.notes.size(), 1u);
  EXPECT_EQ(same_way.volume, 63);
  EXPECT_EQ(same_way.components[1].depth, 1);
  const SurfaceReport as_usual =
      judge_surface(together(box_surface({0, 0, 0}, 4), flipped(box_surface({1, 1, 1}, 1))));
  EXPECT_TRUE(as_usual.notes.empty());
  EXPECT_EQ(as_usual.volume, 63);
}

TEST(Surface, GenusOfKnownShapes) {
  EXPECT_EQ(judge_surface(corpus::make_surface("sphere:r=1,n=500")).genus, 0);
  EXPECT_EQ(judge_surface(corpus::make_surface("torus:R=1,r=0.4,n=500")).genus, 1);
  const TetMesh sponge =
      lattice_mesh({3, 3, 3}, [](Cell c) { return (c[0] == 1) + (c[1] == 1) + (c[2] == 1) < 2; });
  EXPECT_EQ(judge_surface(boundary_surface(sponge)).genus, 5);
}

const std::filesystem::path shared = std::filesystem::path(TETPROOF_SOURCE_DIR) / "../shared/surfaces";

TEST(Surface, BadFilesAreRefused) {
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there";
  const std::map<std::string, std::string> faults{
      {"sphereWithHole.stl",
       "the surface is open: 9 edges have one triangle (first: from (1.5, 1.5, 0) to (1.5, 1.11177, "
       "0.05111), of facet 1)"},
      {"hat_skull.stl",
       "the surface is open: 84 edges have one triangle (first: from (0.035433001816272736, "
       "0.5061190128326416, -0.02480500005185604) to (0.004282000008970499, 0.5045790076255798, "
       "-0.03226200118660927), of facet 631)"},
      {"shared.STL",
       "the surface is not manifold: 1 edge has more than two triangles (first: from (0.5, 0.5, 0.5) to "
       "(0.5, 0.5, -0.5) has 4)"},
      {"self_intersectA.obj",
       "the surface intersects itself: 338 pairs of triangles meet (first: triangle 761 (376 391 392) at "
       "(0.230133593, 0.234162167, 0.521489263) and triangle 8124 (4057 5294 5293) at (0.225341529, "
       "0.236388803, 0.527618647))"},
      {"simpleCar.stl",
       "the surface is not consistently oriented: component 0 (3142 triangles from facet 1 at (-0.4, -1.5, "
       "2.4492936e-17), volume -2.44929) is inward, but component 1 (12 triangles from facet 3143 at (-1.45, "
       "-0.5, 2.5), volume 0.5) is outward, none of them in a cavity"}};
  for (const auto& [file, fault] : faults) {
    const SurfaceFile read = read_surface_file(shared / file);
    EXPECT_EQ(judge_surface(read.surface, read.numbering).fault, fault) << file;
  }
}

TEST(Surface, CleanFilesAreWhatTheirManifestSays) {
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there";
  int clean = 0;
  std::ifstream file_of_facts(shared / "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(file_of_facts);
  for (const auto& row : manifest["files"]) {
    const std::string file = row["file"];
    SCOPED_TRACE(file);
    const SurfaceReport report = judge_surface(read_surface(shared / file));
    EXPECT_EQ(report.fault.empty(), row["class"] == "clean") << report.fault;
    if (row["class"] != "clean") continue;
    ++clean;
    EXPECT_EQ(report.triangles, row["triangles"]);
    EXPECT_EQ(report.vertices, row["vertices_merged"]);
    EXPECT_EQ(static_cast<int>(report.components.size()), row["components"]);
    EXPECT_EQ(report.cavities(), row.value("nested_components", 0));
    EXPECT_EQ(report.genus, row["genus"]);
    EXPECT_NEAR(report.volume, row["volume"].get<double>(), 2e-9 * report.volume);
    if (row.contains("area")) {
      EXPECT_NEAR(report.area, row["area"].get<double>(), 1e-5 * report.area);
    }
    EXPECT_TRUE(report.notes.empty());
    std::vector<std::int64_t> genus;
    for (const auto& component : report.components) genus.push_back(component.genus);
    EXPECT_EQ(genus, row["genus_per_component"].get<std::vector<std::int64_t>>());
  }
  EXPECT_GE(clean, 10);
}

}  // namespace
}  // namespace tetproof::test
