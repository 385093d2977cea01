// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that other programs wrote: they are read with the known counts, or refused with a place.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

const std::filesystem::path formats_folder =
    std::filesystem::path(TETPROOF_SOURCE_DIR) / ".." / "shared" / "formats";

struct Sample {
  const char* file;
  int nodes, elements, tets;  // counted by Gmsh (gmsh FILE -0) or TetGen, or from the file's header lines

  friend void PrintTo(const Sample& test, std::ostream* out) { *out << test.file; }
};

const std::vector<Sample> samples{
    {"gmsh484_out/mem_1_0.msh", 5, 2, 2},
    {"gmsh484_out/mem_2.2_0.msh", 5, 2, 2},  // Gmsh counts an element once for each of its groups
    {"gmsh484_out/mem_2.2_1.msh", 5, 2, 2},
    {"gmsh484_out/mem_4.1_0.msh", 5, 2, 2},
    {"gmsh484_out/per_msh22.msh", 45, 128, 100},
    {"gmsh484_out/per_msh40.msh", 45, 128, 100},
    {"gmsh484_out/per_msh41.msh", 45, 128, 100},
    {"gmsh484_out/two1.msh", 62, 189, 158},
    {"gmsh484_out/two22.msh", 62, 189, 158},
    {"gmsh484_out/two22b.msh", 62, 189, 158},
    {"gmsh484_out/two22par.msh", 62, 189, 158},
    {"gmsh484_out/two40.msh", 62, 189, 158},
    {"gmsh484_out/two41.msh", 62, 189, 158},
    {"gmsh484_out/two41all.msh", 62, 332, 158},
    {"gmsh484_out/two41b.msh", 62, 189, 158},
    {"gmsh484_out/two41o2.msh", 337, 189, 158},
    {"gmsh484_out/two41o2b.msh", 337, 189, 158},
    {"gmsh484_out/two41par.msh", 62, 189, 158},
    {"gmsh484_out/two41part.msh", 62, 215, 158},  // Gmsh counts the ghosts too
    {"gmsh_src/CubeAniso2D.msh", 2540, 5364, 0},
    {"gmsh_src/MSubLine_input.msh", 3, 3, 0},
    {"gmsh_src/MSubPoint_input.msh", 3, 2, 0},
    {"gmsh_src/MSubTetrahedron_input.msh", 7, 5, 1},
    {"gmsh_src/MSubTriangle_input.msh", 5, 4, 0},
    {"gmsh_src/adaptive_tet10.msh", 27, 38, 6},
    {"gmsh_src/adaptive_tet20.msh", 172, 24, 24},
    {"gmsh_src/adaptive_tri6.msh", 67, 63, 0},
    {"gmsh_src/discrete.msh", 2785, 16512, 13059},
    {"gmsh_src/hybrid_part.msh", 426, 854, 0},
    {"gmsh_src/multimodel1.msh", 4, 1, 0},
    {"gmsh_src/multimodel23.msh", 6, 2, 0},
    {"gmsh_src/partitions.msh", 133, 264, 0},  // counts of the file itself
    {"gmsh_src/surf.msh", 84, 178, 0},
    {"gmsh_src/takeit_sur.msh", 937, 1874, 0},
    {"gmsh_src/view5.msh", 6, 2, 0},
    {"handmade/be41.msh", 62, 189, 158},
    {"handmade/crlf41.msh", 62, 189, 158},
    {"handmade/gmsh484_crashers/cnt_sig11_0.msh", 62, 189, 158},
    {"handmade/gmsh484_crashers/cnt_sig11_21.msh", 62, 189, 158},
    {"handmade/gmsh484_crashers/cnt_sig11_52.msh", 62, 189, 158},
    {"handmade/gmsh484_crashers/cnt_sig11_61.msh", 62, 189, 158},
    {"handmade/gmsh484_crashers/node_tag_2147483648_valid.msh", 4, 2, 1},
    {"handmade/gmsh484_crashers/two41b.msh.flip.CRASH_sig11.msh", 62, 189, 158},
    {"handmade/s.msh", 4, 2, 1},
    {"handmade/sparse.msh", 4, 2, 1},
    {"mshio/test_2.2_ascii.msh", 6, 2, 0},
    {"mshio/test_2.2_bin.msh", 6, 2, 0},
    {"mshio/test_4.1_ascii.msh", 6, 2, 0},
    {"mshio/test_4.1_bin.msh", 6, 2, 0},
    {"trimesh/insulated.msh", 67, 132, 0},
    {"handmade/c.ele", 4, 1, 1},
    {"handmade/c.node", 4, 1, 1},
    {"handmade/q1.ele", 4, 1, 1},
    {"handmade/q1.node", 4, 1, 1},
    {"handmade/q3.ele", 9, 2, 2},
    {"handmade/q3.node", 9, 2, 2},
    {"tetgen150_out/cube_attr.1.ele", 8, 6 + 12 + 12, 6},
    {"tetgen150_out/cube_attr.1.node", 8, 6 + 12 + 12, 6},
    {"tetgen150_out/example.1.ele", 303, 976 + 2233 + 1558, 976},
    {"tetgen150_out/example.1.node", 303, 976 + 2233 + 1558, 976},
    {"tetgen150_out/example_o2.1.ele", 1861, 976 + 596 + 165, 976},
    {"tetgen150_out/example_o2.1.node", 1861, 976 + 596 + 165, 976},
    {"tetgen150_out/nn2.1.ele", 20, 22 + 62 + 59, 22},
    {"tetgen150_out/nn2.1.node", 20, 22 + 62 + 59, 22},
    {"tetgen150_out/cube_attr.1.face", 8, 6 + 12 + 12, 6},
    {"tetgen150_out/cube_attr.1.edge", 8, 6 + 12 + 12, 6},
    {"tetgen150_out/example.1.face", 303, 976 + 2233 + 1558, 976},
    {"tetgen150_out/example.1.edge", 303, 976 + 2233 + 1558, 976},
    {"tetgen150_out/example.1.neigh", 303, 976 + 2233 + 1558, 976},
    {"tetgen150_out/example_o2.1.face", 1861, 976 + 596 + 165, 976},
    {"tetgen150_out/example_o2.1.edge", 1861, 976 + 596 + 165, 976},
    {"tetgen150_out/nn2.1.face", 20, 22 + 62 + 59, 22},
    {"tetgen150_out/nn2.1.edge", 20, 22 + 62 + 59, 22},
    {"tetgen150_out/nn2.1.neigh", 20, 22 + 62 + 59, 22},
    {"tetgen150_out/cube_attr.poly", 8, 6, 0},
    {"tetgen150/example.poly", 28, 24, 0},
    {"handmade/q2.node", 4, 0, 0},
};

class MeshSamples : public testing::TestWithParam<Sample> {};

TEST_P(MeshSamples, AreReadToTheirLastElement) {
  const std::string path = (formats_folder / GetParam().file).string();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const Document document = read_document(path);
  EXPECT_EQ(document.points.size(), static_cast<std::size_t>(GetParam().nodes));
  EXPECT_EQ(document.elements(), static_cast<std::size_t>(GetParam().elements));
  EXPECT_EQ(tet_mesh(document).tets.size(), static_cast<std::size_t>(GetParam().tets));
}

INSTANTIATE_TEST_SUITE_P(Files, MeshSamples, testing::ValuesIn(samples), [](const auto& test) {
  std::string name = test.param.file;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
});

TEST(MeshSamples, NoneIsForgotten) {
  if (!std::filesystem::exists(formats_folder)) GTEST_SKIP() << formats_folder << " is not here";
  std::set<std::string> listed;
  for (const Sample& sample : samples) listed.insert(sample.file);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(formats_folder)) {
    static const std::set<std::string> endings{".msh", ".node", ".ele", ".face", ".edge", ".neigh", ".poly"};
    if (!endings.count(entry.path().extension())) continue;
    EXPECT_TRUE(listed.count(std::filesystem::relative(entry.path(), formats_folder).string()))
        << entry.path();
  }
}

// Gmsh wrote the same mesh in several versions and encodings. Its text rounds coordinates to 16 digits.
TEST(MeshSamples, OneMeshInSeveralEncodings) {
  if (!std::filesystem::exists(formats_folder)) GTEST_SKIP() << formats_folder << " is not here";
  for (const auto& [a, b] : {std::pair{"gmsh484_out/two22.msh", "gmsh484_out/two22b.msh"},
                             {"gmsh484_out/mem_2.2_0.msh", "gmsh484_out/mem_2.2_1.msh"},
                             {"gmsh484_out/two41.msh", "handmade/crlf41.msh"},
                             {"gmsh484_out/two41b.msh", "handmade/be41.msh"},
                             {"gmsh484_out/two40.msh", "gmsh484_out/two41.msh"},
                             {"gmsh484_out/two1.msh", "gmsh484_out/two22.msh"}}) {
    Document first = read_document((formats_folder / a).string()),
             second = read_document((formats_folder / b).string());
    ASSERT_EQ(first.points.size(), second.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i)
      EXPECT_LE((first.points[i] - second.points[i]).norm(), 1e-15 * first.points[i].norm()) << a << " " << i;
    second.points = first.points;
    // The parts that only one version holds, or that it holds in another order.
    if (first.format == "msh1") first.node_tags.clear(), second.node_tags.clear(), second.group_names.clear();
    EXPECT_TRUE(test::text_of(first, first.format == second.format) ==
                test::text_of(second, first.format == second.format))
        << a << " and " << b << " differ:\n"
        << test::text_of(first).substr(0, 3000) << test::text_of(second).substr(0, 3000);
  }
}

// Second-order nodes are at the midpoints of their edges, no matter which program ordered them.
TEST(MeshSamples, MidEdgeNodesStandBetweenTheirCorners) {
  if (!std::filesystem::exists(formats_folder)) GTEST_SKIP() << formats_folder << " is not here";
  static constexpr int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};  // Gmsh's order
  for (const char* file :
       {"gmsh484_out/two41o2.msh", "gmsh484_out/two41o2b.msh", "tetgen150_out/example_o2.1.ele"}) {
    const Document document = read_document((formats_folder / file).string());
    std::size_t seen = 0;
    for (const ElementBlock& block : document.blocks) {
      if (block.type != 11) continue;
      for (std::size_t e = 0; e < block.count; ++e, ++seen) {
        const Index* nodes = document.connectivity.data() + block.nodes + e * 10;
        for (int k = 0; k < 6; ++k) {
          const Eigen::Vector3d &a = document.points[nodes[edges[k][0]]],
                                &b = document.points[nodes[edges[k][1]]];
          EXPECT_LT((document.points[nodes[4 + k]] - (a + b) / 2).norm(), 1e-6 * (a - b).norm())
              << file << " " << e;
        }
      }
    }
    EXPECT_GT(seen, 100u) << file;
  }
}

}  // namespace
}  // namespace tetproof
