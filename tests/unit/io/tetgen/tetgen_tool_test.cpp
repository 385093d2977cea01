// SPDX-License-Identifier: GPL-3.0-or-later
// TetGen itself: it gives the same result for our files as for the original ones, and we read its files
// correctly.
#include <map>

#include "io/mesh_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/tetgen_text.hpp"

namespace tetproof {
namespace {

namespace fs = std::filesystem;

class TetgenTool : public testing::Test {
 protected:
  void SetUp() override {
    if (test::run_program({"tetgen", "-h"}).exit_code == 127) GTEST_SKIP() << "tetgen is not installed";
    if (!fs::exists(sample)) GTEST_SKIP() << sample << " is not here";
    fs::create_directory(files.path("a"));
    fs::create_directory(files.path("b"));
    for (const char* folder : {"a/", "b/"}) fs::copy_file(sample, files.path(folder + std::string("x.poly")));
  }

  // Runs TetGen in a folder. Returns the files that it wrote, without their comments.
  std::map<std::string, std::string> run(const std::string& folder, const std::string& switches,
                                         const std::string& name, const std::string& made) {
    const test::Outcome outcome =
        test::run_program({"tetgen", switches, name}, {.directory = files.path(folder)});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    std::map<std::string, std::string> written;
    for (const auto& entry : fs::directory_iterator(files.path(folder))) {
      const std::string file = entry.path().filename();
      if (file.substr(0, made.size()) != made) continue;
      std::istringstream lines(test::TestFiles::read(entry.path()));
      for (std::string line; std::getline(lines, line);)
        if (line.empty() || line[0] != '#') written[file] += line + "\n";
    }
    EXPECT_FALSE(written.empty()) << outcome.out;
    return written;
  }

  const fs::path sample = fs::path(TETPROOF_SOURCE_DIR) / "../shared/formats/tetgen150/example.poly";
  test::TestFiles files;
};

// TetGen meshes facets with holes and regions, the size field and the bounds.
TEST_F(TetgenTool, MeshesWhatWeWriteLikewise) {
  files.write("a/x.var", "2\n1 1 0.05\n2 9 0.1\n1\n1 1 2 0.125\n");
  std::string sizes = "28 1\n";
  for (int i = 0; i < 28; ++i) sizes += fmt::format("{}\n", 0.3 + 0.01 * i);
  files.write("a/x.mtr", sizes);
  write_document(files.path("b/x.poly"), read_document(files.path("a/x.poly")));
  for (const char* switches : {"-pQ", "-pqAaQ", "-pqmAafeQ"})
    EXPECT_EQ(run("a", switches, "x.poly", "x.1") == run("b", switches, "x.poly", "x.1"), true) << switches;
}

// TetGen refines a mesh from our files as it does from its own.
TEST_F(TetgenTool, RefinesWhatWeWriteLikewise) {
  for (const char* second_order : {"", "o2"}) {
    fs::remove(files.path("a/x.1.vol"));
    run("a", std::string("-pqAfennQ") + second_order, "x.poly", "x.1");
    Document document = read_document(files.path("a/x.1.ele"));
    Values bounds{.name = "volume bounds", .reals = {}, .integers = {}};
    std::size_t tets = 0;
    for (const ElementBlock& block : document.blocks) tets += block.dim == 3 ? block.count : 0;
    bounds.reals.assign(tets, 0.05);
    document.element_values.push_back(bounds);
    std::string vol = fmt::format("{}\n", bounds.reals.size());
    for (std::size_t i = 0; i < bounds.reals.size(); ++i) vol += fmt::format("{} 0.05\n", i + 1);
    files.write("a/x.1.vol", vol);
    write_document(files.path("b/x.1.ele"), document);
    EXPECT_EQ(test::tetgen_text(read_document(files.path("b/x.1.ele"))) == test::tetgen_text(document), true);
    const auto original = run("a", "-rqaQ", "x.1", "x.2");
    EXPECT_EQ(original == run("b", "-rqaQ", "x.1", "x.2"), true) << second_order;
    EXPECT_GT(original.at("x.2.ele").size(), test::TestFiles::read(files.path("a/x.1.ele")).size());
  }
}

TEST_F(TetgenTool, SmeshLikewise) {
  files.write("a/y.smesh",
              "8 3 0 0\n0 0 0 0\n1 1 0 0\n2 1 1 0\n3 0 1 0\n4 0 0 1\n5 1 0 1\n6 1 1 1\n7 0 1 1\n"
              "6 1\n4 0 1 2 3 -1\n4 4 5 6 7 2\n4 0 1 5 4 3\n4 1 2 6 5 4\n4 2 3 7 6 5\n4 3 0 4 7 6\n0\n1\n0 "
              ".5 .5 .5 7 .01\n");
  write_document(files.path("b/y.smesh"), read_document(files.path("a/y.smesh")));
  EXPECT_EQ(run("a", "-pqAafeQ", "y.smesh", "y.1") == run("b", "-pqAafeQ", "y.smesh", "y.1"), true);
}

// TetGen's order of the nodes between corners depends on -f. In a document they are at the midpoints of their
// edges.
TEST_F(TetgenTool, NodesBetweenCorners) {
  for (const char* switches : {"-pqo2Q", "-pqo2feQ", "-pqo2fennQ"}) {
    run("a", switches, "x.poly", "x.1");
    const Document document = read_document(files.path("a/x.1.ele"));
    ASSERT_GE(document.blocks.size(), 3u);
    constexpr int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
    for (const ElementBlock& block : document.blocks) {
      const int corners = block.dim + 1, between = block.nodes_each - corners;
      EXPECT_EQ(between, block.dim == 3 ? 6 : block.dim == 2 ? 3 : 1);
      for (std::size_t e = 0; e < block.count; ++e) {
        const Index* node =
            document.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
        for (int k = 0; k < between; ++k) {
          const Eigen::Vector3d &a = document.points[node[edges[k][0]]],
                                &b = document.points[node[edges[k][1]]];
          ASSERT_LT((document.points[node[corners + k]] - (a + b) / 2).norm(), 1e-9)
              << switches << " " << block.dim;
        }
      }
    }
  }
}

// Both cells of a Voronoi face list it, and the points of a bounded edge have the same distance from the
// nodes of both cells.
TEST_F(TetgenTool, VoronoiDiagram) {
  std::string nodes = "30 3\n";
  for (int i = 0; i < 30; ++i)
    nodes +=
        fmt::format("{} {} {} {}\n", i, (i * 37 % 101) / 101.0, (i * 53 % 97) / 97.0, (i * 71 % 89) / 89.0);
  files.write("a/v.node", nodes);
  run("a", "-vQ", "v.node", "v.1");
  const Document document = read_document(files.path("a/v.1.v.cell"));
  const Voronoi& v = document.voronoi;
  ASSERT_EQ(v.cells.size(), 30u);
  ASSERT_GT(v.faces.size(), 60u);
  for (std::size_t f = 0; f < v.faces.size(); ++f) {
    const Eigen::Vector3d &a = document.points[v.faces[f].cells[0]],
                          &b = document.points[v.faces[f].cells[1]];
    for (const Index cell : v.faces[f].cells) {
      const std::vector<Index>& faces = v.cells[cell];
      EXPECT_NE(std::find(faces.begin(), faces.end(), static_cast<Index>(f)), faces.end());
    }
    for (const Index e : v.faces[f].edges) {
      if (e < 0) continue;
      const Eigen::Vector3d& p = v.points[v.edges[e].points[0]];
      EXPECT_NEAR((p - a).norm(), (p - b).norm(), 1e-6 * (1 + p.norm()));
    }
  }
  write_document(files.path("b/v.1.ele"), document);
  EXPECT_EQ(test::tetgen_text(read_document(files.path("b/v.1.v.cell"))), test::tetgen_text(document));
}

}  // namespace
}  // namespace tetproof
