// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that other programs wrote: they are read with the known counts, or refused with a place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const std::filesystem::path shared = std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared";

struct Sample {
  const char* file;
  int vertices, triangles;  // distinct points and triangles, counted by a script of a few lines that shares
                            // no code with us
  const char* refused = nullptr;  // or the message after the file's name

  friend void PrintTo(const Sample& test, std::ostream* out) { *out << test.file; }
};

const std::vector<Sample> samples{
    {"gmsh484_out/a.stl", 24, 28},
    {"gmsh484_out/b.stl", 24, 28},
    {"gmsh_src/lever.stl", 377, 774},
    {"gmsh_src/object.stl", 359, 710},
    {"gmsh_src/sphere.stl", 305, 606},
    {"gmsh_src/surface1.stl", 52, 80},
    {"gmsh_src/surface2.stl", 55, 86},
    {"handmade/asc.ply", 4, 4},
    {"handmade/asc.stl", 4, 4},
    {"handmade/asc_D.stl", 4, 4},
    {"handmade/asc_noend.stl", 4, 4},
    {"handmade/asc_noname.stl", 4, 4},
    {"handmade/asc_obj.ply", 4, 4},
    {"handmade/asc_two.stl", 4, 4},
    {"handmade/asc_upper.stl", 4, 4},
    {"handmade/bin_cnt0.stl", 4, 4},
    {"handmade/bin_facet.stl", 4, 4},
    {"handmade/color.off", 4, 4},
    {"handmade/comment.off", 4, 4},
    {"handmade/crlf.obj", 4, 4},
    {"handmade/dbl.off", 3, 1},
    {"handmade/groups.obj", 4, 4},
    {"handmade/le.ply", 4, 4},
    {"handmade/le_crlf.ply", 4, 4},
    {"handmade/le_float.ply", 4, 4},
    {"handmade/nohead.off", 4, 4},
    {"handmade/plain.obj", 4, 4},
    {"handmade/plain.off", 4, 4},
    {"handmade/vcol.obj", 4, 4},
    {"handmade/vtvn.obj", 4, 4},
    {"handmade/zeroedges.off", 4, 4},
    {"trimesh/20mm-xyz-cube.stl", 132, 260},
    {"trimesh/BoxTextured.ply", 8, 12},
    {"trimesh/box.obj", 8, 12},
    {"trimesh/comments.off", 8, 12},
    {"trimesh/cube.OBJ", 8, 12},
    {"trimesh/cube_blender_uv_meshlab.ply", 8, 12},
    {"trimesh/cube_compressed.obj", 8, 12},
    {"trimesh/cylinder.stl", 210, 416},
    {"trimesh/empty.obj", 0, 0},
    {"trimesh/empty.ply", 0, 0},
    {"trimesh/empty.stl", 0, 0},
    {"trimesh/face_in_group_name.obj", 1, 0},
    {"trimesh/face_in_group_name_mid_file.obj", 5, 2},
    {"trimesh/fuze.ply", 502, 1000},
    {"trimesh/jacked.obj", 8, 12},
    {"trimesh/joined_tetrahedra.obj", 5, 8},
    {"trimesh/large_block.STL", 8, 12},
    {"trimesh/metadata.ply", 4, 2},
    {"trimesh/mirror.ply", 143, 286},
    {"trimesh/multi.ply", 4, 2},
    {"trimesh/multibody.stl", 20, 32},
    {"trimesh/nancolor.obj", 8, 12},
    {"trimesh/negative_indices.obj", 8, 12},
    {"trimesh/notenoughindices.obj", 0, 0, ":9: face has 2 corners, expected at least 3"},
    {"trimesh/obj_empty.obj", 0, 0},
    {"trimesh/obj_points.obj", 8, 0},
    {"trimesh/obj_with_no_face_in_chunk.obj", 3, 1},
    {"trimesh/origin_inside.STL", 16, 28},
    {"trimesh/plane.ply", 4, 2},
    {"trimesh/plane_tri.ply", 4, 2},
    {"trimesh/ply_empty_ascii.ply", 0, 0},
    {"trimesh/ply_empty_bin.ply", 0, 0},
    {"trimesh/ply_empty_header.ply", 0, 0, ": expected an element 'vertex' in the header, found none"},
    {"trimesh/points_ascii_with_lists.ply", 0, 0,
     ": expected an element 'face' with a list 'vertex_indices' or 'vertex_index' in the header, found none"},
    {"trimesh/polygonfaces.obj", 0, 0, ":11: face with 5 corners crosses itself"},
    {"trimesh/round.stl", 560, 1120},
    {"trimesh/soup.stl", 300, 100},
    {"trimesh/stl_empty_ascii.stl", 0, 0},
    {"trimesh/stl_empty_bin.stl", 0, 0},
    {"trimesh/tet.ply", 4, 4},
    {"trimesh/two_objects.obj", 8, 16},
    {"trimesh/two_objects_mixed_case_names.stl", 16, 24},
    {"trimesh/unit_cube.STL", 8, 12},
    {"trimesh/whitespace.off", 8, 12},
};

class SurfaceSamples : public testing::TestWithParam<Sample> {};

TEST_P(SurfaceSamples, ReadOrRefused) {
  const Sample& sample = GetParam();
  const std::filesystem::path path = shared / "formats" / sample.file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  if (sample.refused) {
    try {
      read_surface(path);
      FAIL() << "not refused";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), path.string() + sample.refused);
    }
    return;
  }
  if (sample.triangles == 0) {
    const test::TestFiles files;
    EXPECT_EQ(files.message([&] { read_surface(path); }),
              path.string() + ": expected a surface, found no triangles or polygons");
    EXPECT_EQ(read_document(path).points.size(), static_cast<std::size_t>(sample.vertices));
    return;
  }
  const TriangleSurface surface = read_surface(path);
  EXPECT_EQ(surface.vertices.size(), static_cast<std::size_t>(sample.vertices));
  EXPECT_EQ(surface.triangles.size(), static_cast<std::size_t>(sample.triangles));
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceSamples, testing::ValuesIn(samples), [](const auto& test) {
  std::string name = test.param.file;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST(SurfaceSamples, EveryFileIsInTheTable) {
  if (!std::filesystem::exists(shared / "formats"))
    GTEST_SKIP() << shared / "formats"
                 << " is not here";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "formats")) {
    if (!is_surface_file(entry.path().string())) continue;
    const std::string file = std::filesystem::relative(entry.path(), shared / "formats").string();
    EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [&](const Sample& s) { return s.file == file; }))
        << file;
  }
}

TEST(SurfaceSamples, RealSurfacesMatchTheirManifest) {
  const std::filesystem::path folder = shared / "surfaces";
  if (!std::filesystem::exists(folder / "manifest.json")) GTEST_SKIP() << folder << " is not here";
  const auto manifest = nlohmann::json::parse(std::ifstream(folder / "manifest.json"));
  ASSERT_GE(manifest.at("files").size(), 15u);
  for (const auto& entry : manifest.at("files")) {
    const std::string file = entry.at("file");
    const TriangleSurface surface = read_surface(folder / file);
    EXPECT_EQ(surface.triangles.size(), entry.at("triangles").get<std::size_t>()) << file;
    EXPECT_EQ(surface.vertices.size(), entry.at("vertices_merged").get<std::size_t>()) << file;
  }
}

}  // namespace
}  // namespace tetproof
