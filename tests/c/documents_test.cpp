// SPDX-License-Identifier: GPL-3.0-or-later
// Documents of the C interface: from arrays, files and memory; their arrays, losses and files.
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/c/handles.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;

FileDocument read(const std::string& path, const char* format = nullptr) {
  return made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_document_read(path.c_str(), format, out, error); });
}

FileDocument read_memory(const std::string& bytes, const char* format = nullptr) {
  return made<tetproof_document>([&](auto** out, auto* error) {
    return tetproof_document_read_memory(bytes.data(), bytes.size(), format, out, error);
  });
}

const tetproof_document_arrays& view(const FileDocument& document) {
  const tetproof_document_arrays* arrays = nullptr;
  EXPECT_EQ(tetproof_document_view(document.get(), &arrays, nullptr), TETPROOF_OK);
  return *arrays;
}

json losses(const FileDocument& document, const std::string& path) {
  const auto text = made<char>([&](char** out, auto* error) {
    return tetproof_document_losses(document.get(), path.c_str(), nullptr, out, error);
  });
  return json::parse(text.get());
}

void write(const FileDocument& document, const std::string& path, int encoding = TETPROOF_ENCODING_DEFAULT) {
  tetproof_write_options options;
  ASSERT_EQ(tetproof_write_options_init(&options, sizeof options, nullptr), TETPROOF_OK);
  options.encoding = encoding;
  tetproof_error error;
  EXPECT_EQ(tetproof_document_write(document.get(), path.c_str(), &options, &error), TETPROOF_OK)
      << error.message;
}

// Two cubes in the groups 7 ("steel") and none, and the boundary of the first in the group 2.
FileDocument two_cubes() {
  const TetMesh mesh = lattice_mesh({2, 1, 1});
  const Arrays arrays(mesh, 1);
  const std::int32_t groups[12] = {7, 7, 7, 7, 7, 7};
  const std::int64_t triangle[3] = {1, 3, 5};
  const std::int64_t two = 2;
  const tetproof_integers tet_groups{groups, 12, 0, 0, 0, 32}, triangles{triangle, 1, 0, 0, 1, 64},
      triangle_groups{&two, 1, 0, 0, 0, 64};
  FileDocument document = made<tetproof_document>([&](auto** out, auto* error) {
    return tetproof_document_from_arrays(&arrays.points, &arrays.tets, &tet_groups, &triangles,
                                         &triangle_groups, out, error);
  });
  EXPECT_EQ(tetproof_document_name_group(document.get(), 3, 7, "iron", nullptr), TETPROOF_OK);
  EXPECT_EQ(tetproof_document_name_group(document.get(), 3, 7, "steel", nullptr), TETPROOF_OK);
  return document;
}

TEST(CDocuments, ComeBackFromFiles) {
  const TestFiles files;
  const FileDocument document = two_cubes();
  for (const char* name : {"two.msh", "two.vtu", "two.mesh", "two.1.node"}) {
    SCOPED_TRACE(name);
    for (const int encoding : {TETPROOF_ENCODING_TEXT, TETPROOF_ENCODING_BINARY}) {
      if (encoding == TETPROOF_ENCODING_BINARY && std::strcmp(name, "two.msh") != 0) continue;
      write(document, files.path(name), encoding);
      const FileDocument back = read(files.path(name));
      const tetproof_document_arrays &a = view(document), &b = view(back);
      ASSERT_EQ(b.point_count, 12);
      ASSERT_EQ(b.tet_count, 12);
      ASSERT_EQ(b.triangle_count, 1);
      EXPECT_EQ(b.element_count, 13);
      EXPECT_EQ(std::memcmp(a.points, b.points, 12 * 24), 0);
      EXPECT_EQ(std::memcmp(a.tets, b.tets, 12 * 16), 0);
      EXPECT_EQ(std::memcmp(a.triangles, b.triangles, 12), 0);
      EXPECT_EQ(std::memcmp(a.tet_groups, b.tet_groups, 12 * 8), 0);
      EXPECT_EQ(b.tet_groups[0], 7);
      EXPECT_EQ(b.tet_groups[6], 0);
      EXPECT_EQ(b.triangle_groups[0], 2);
      EXPECT_EQ(b.point_numbers[0], std::strcmp(name, "two.vtu") == 0 ? 0 : 1);  // VTK numbers no points
      const bool has_names = std::strcmp(name, "two.mesh") != 0;
      ASSERT_EQ(b.group_count, has_names ? 1 : 0);
      if (!has_names) continue;
      EXPECT_EQ(b.groups[0]->dimension, 3);
      EXPECT_EQ(b.groups[0]->tag, 7);
      EXPECT_STREQ(b.groups[0]->name, "steel");
    }
  }
}

TEST(CDocuments, TakeNamesOfAnyBytes) {
  const TestFiles files;
  const FileDocument document = two_cubes();
  for (const char* name : {"two\nlines", "a \"b\" c", "\xff\xfe", "$EndPhysicalNames", " ", ""}) {
    SCOPED_TRACE(name);
    ASSERT_EQ(tetproof_document_name_group(document.get(), 3, 7, name, nullptr), TETPROOF_OK);
    for (const char* format : {"msh41", "msh22"}) {
      tetproof_write_options options;
      ASSERT_EQ(tetproof_write_options_init(&options, sizeof options, nullptr), TETPROOF_OK);
      options.format = format;
      options.strict = TETPROOF_STRICT_ON;
      tetproof_error error;
      ASSERT_EQ(tetproof_document_write(document.get(), files.path("a.msh").c_str(), &options, &error),
                TETPROOF_OK)
          << error.message;
      const FileDocument back = read(files.path("a.msh"));
      ASSERT_EQ(view(back).group_count, 1);
      EXPECT_STREQ(view(back).groups[0]->name, name);
      EXPECT_EQ(view(back).tet_groups[0], 7);
    }
  }
}

TEST(CDocuments, AreReadFromMemory) {
  const TestFiles files;
  write(two_cubes(), files.path("two.msh"), TETPROOF_ENCODING_BINARY);
  const FileDocument msh = read_memory(TestFiles::read(files.path("two.msh")));
  EXPECT_STREQ(view(msh).format, "msh41");
  EXPECT_EQ(view(msh).tet_count, 12);
  const FileDocument stl = read_memory(
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid s\n");
  EXPECT_EQ(view(stl).triangle_count, 1);
  EXPECT_EQ(
      refused<tetproof_document>(TETPROOF_BAD_INPUT,
                                 [](auto** out, auto* error) {
                                   return tetproof_document_read_memory("1 3 0 0\n0 0 0 0\n", 16, "tetgen",
                                                                        out, error);
                                 }),
      "memory: TetGen's mesh is several files, of which memory can be only one; name the .node or .ele");
  EXPECT_EQ(refused<tetproof_document>(TETPROOF_BAD_INPUT,
                                       [](auto** out, auto* error) {
                                         return tetproof_document_read_memory("OFF\n3 1 0\n0 0 0\n", 16,
                                                                              nullptr, out, error);
                                       })
                .substr(0, 9),
            "memory:2:");
  EXPECT_NE(refused<tetproof_document>(TETPROOF_BAD_INPUT,
                                       [](auto** out, auto* error) {
                                         return tetproof_document_read_memory("", 0, nullptr, out, error);
                                       })
                .find("tells no format"),
            std::string::npos);
}

TEST(CDocuments, SayWhatIsLost) {
  const FileDocument document = two_cubes();
  const json in_stl = losses(document, "two.stl");
  EXPECT_EQ(in_stl["losses"][0]["item"], "tetrahedra of 4 nodes (type 4)");
  EXPECT_EQ(in_stl["losses"][0]["count"], 12);
  EXPECT_EQ(losses(document, "two.msh")["losses"], json::array());
  EXPECT_EQ(losses(document, "two.1.node")["kept_aside"].empty(), false);

  const TestFiles files;
  tetproof_write_options options;
  ASSERT_EQ(tetproof_write_options_init(&options, sizeof options, nullptr), TETPROOF_OK);
  const auto strictly = [&](int strict, const char* name) {
    options.strict = strict;
    tetproof_error error;
    tetproof_document_write(document.get(), files.path(name).c_str(), &options, &error);
    EXPECT_EQ(std::filesystem::exists(files.path(name)), error.status == TETPROOF_OK);
    return std::string(tetproof_status_name(error.status)) + " " + error.message;
  };
  EXPECT_EQ(strictly(TETPROOF_STRICT_ON, "two.stl").substr(0, 76),
            "TETPROOF_LOSSY not written, since the format has no place for: tetrahedra of");
  EXPECT_EQ(strictly(TETPROOF_STRICT_NATIVE, "strict.1.node").substr(0, 15), "TETPROOF_LOSSY ");
  EXPECT_EQ(strictly(TETPROOF_STRICT_ON, "two.msh"), "TETPROOF_OK ");
  EXPECT_EQ(strictly(TETPROOF_STRICT_NATIVE, "native.msh"), "TETPROOF_OK ");
  EXPECT_EQ(strictly(3, "never.msh"), "TETPROOF_BAD_ARGUMENT strict is 3, expected 0 to 2");
  EXPECT_NE(strictly(0, "two.nonsense").find("unknown ending"), std::string::npos);
  EXPECT_NE(strictly(0, "no/such/folder.msh").find("TETPROOF_BAD_INPUT"), std::string::npos);
}

TEST(CDocuments, KeepIndicesThatNameNoPoint) {
  TetMesh mesh = lattice_mesh({1, 1, 1});
  mesh.tets[2][1] = 98;
  const Arrays arrays(mesh, 1);
  const FileDocument document = made<tetproof_document>([&](auto** out, auto* error) {
    return tetproof_document_from_arrays(&arrays.points, &arrays.tets, nullptr, nullptr, nullptr, out, error);
  });
  const tetproof_document_arrays& a = view(document);
  EXPECT_EQ(a.tets[9], -1);
  ASSERT_EQ(a.unknown_count, 1);
  EXPECT_EQ(a.unknown[0], 99);
  const Report of_document = made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge_document(document.get(), nullptr, nullptr, out, error);
  });
  EXPECT_EQ(json_of(of_document), json_of(judged(arrays.points, arrays.tets)));
}

TEST(CDocuments, AreDescribed) {
  const FileDocument document = two_cubes();
  const auto text =
      made<char>([&](char** out, auto* error) { return tetproof_document_json(document.get(), out, error); });
  const json described = json::parse(text.get());
  EXPECT_EQ(described["nodes"]["count"], 12);
  EXPECT_EQ(described["elements"]["count"], 13);
  EXPECT_EQ(described["dropped"], json::array());
  EXPECT_EQ(described["warnings"], json::array());
}

TEST(CDocuments, AreMeshedBySurfaces) {
  const Surface wing = opened("wing:naca=0012");
  ASSERT_TRUE(wing);
  const tetproof_surface_arrays& arrays = *tetproof_surface_view(wing.get());
  EXPECT_GT(arrays.vertex_count, 100);
  EXPECT_NE(arrays.parameters, nullptr);
  tetproof_mesh_options options = mesh_options();
  options.cells[0] = 1;  // no cell is inside
  const FileDocument empty = made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_mesh(wing.get(), &options, out, error); });
  EXPECT_EQ(view(empty).tet_count, 0);
}

}  // namespace
}  // namespace tetproof::test
