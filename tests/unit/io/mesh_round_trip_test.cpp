// SPDX-License-Identifier: GPL-3.0-or-later
// Random meshes through every pair of formats that hold doubles: the result equals the input, bit by bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "io/bytes/scanner.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/msh/numbers.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

struct Target {
  const char* name;
  const char* file;
  WriteOptions options;
};
const std::vector<Target> targets{{"Msh41Text", "x.msh", {}},
                                  {"Msh41Binary", "x.msh", {.binary = true}},
                                  {"Msh22Text", "x.msh", {.format = "msh22"}},
                                  {"Msh22Binary", "x.msh", {.format = "msh22", .binary = true}},
                                  {"Tetgen", "x.node", {}}};

// Any bits except NaN, whose bits no text keeps.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (!std::isnan(value)) return value;
  }
}

TetMesh random_mesh(std::mt19937_64& random, int points, int tets) {
  static constexpr double corners[] = {0.0,
                                       -0.0,
                                       5e-324,
                                       -5e-324,
                                       2.2250738585072009e-308,
                                       2.2250738585072014e-308,
                                       1.7976931348623157e308,
                                       0.1,
                                       0.30000000000000004,
                                       1.0 / 3,
                                       1e22,
                                       1e23,
                                       9007199254740993.0,
                                       INFINITY,
                                       -INFINITY};
  TetMesh mesh;
  for (int i = 0; i < points; ++i) {
    Eigen::Vector3d& p = mesh.points.emplace_back();
    for (double& x : p) x = random() % 3 ? any_double(random) : corners[random() % std::size(corners)];
  }
  for (int i = 0; i < tets; ++i) {
    std::array<Index, 4>& tet = mesh.tets.emplace_back();
    for (Index& node : tet) node = static_cast<Index>(random() % (points + 2));  // the last two do not exist
  }
  return mesh;
}

void expect_same(const TetMesh& a, const TetMesh& b, const Numbering& names_a, const Numbering& names_b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    ASSERT_EQ(std::memcmp(a.points[i].data(), b.points[i].data(), 24), 0)
        << "node " << i << ": " << a.points[i].transpose() << " became " << b.points[i].transpose();
  ASSERT_EQ(a.tets.size(), b.tets.size());
  for (std::size_t t = 0; t < a.tets.size(); ++t)
    for (int k = 0; k < 4; ++k)
      ASSERT_EQ(names_a.point(a.tets[t][k]), names_b.point(b.tets[t][k])) << "tetrahedron " << t;
}

class RoundTrip : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(RoundTrip, IsTheIdentity) {
  const Target &first = targets[std::get<0>(GetParam())], &second = targets[std::get<1>(GetParam())];
  const test::TestFiles files;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937_64 random(seed);
    const Document start = document_of(random_mesh(random, seed == 1 ? 0 : 300, seed == 1 ? 0 : 500));
    EXPECT_TRUE(losses(files.path(first.file), start, first.options).empty());
    write_document(files.path(first.file), start, first.options);
    const Document middle = read_document(files.path(first.file));
    EXPECT_TRUE(losses(files.path(second.file), middle, second.options).empty());
    write_document(files.path(second.file), middle, second.options);
    const Document end = read_document(files.path(second.file));
    expect_same(tet_mesh(start), tet_mesh(end), numbering(start), numbering(end));
    // Writing what was read gives the same file again.
    const std::string bytes = test::TestFiles::read(files.path(second.file));
    write_document(files.path(second.file), end, second.options);
    EXPECT_EQ(test::TestFiles::read(files.path(second.file)), bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(AllPairs, RoundTrip,
                         testing::Combine(testing::Range<std::size_t>(0, 5),
                                          testing::Range<std::size_t>(0, 5)),
                         [](const auto& test) {
                           return std::string(targets[std::get<0>(test.param)].name) + "_" +
                                  targets[std::get<1>(test.param)].name;
                         });

// Documents with everything that .msh 4.1 holds, as text and as binary.
TEST(RoundTrip, RandomDocumentsThrough41) {
  const test::TestFiles files;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return static_cast<std::int64_t>(random() % n); };
    Document document;
    document.format = "msh41";
    document.tag_sets = {{}, {1}, {-2, 7}, {3, 4, 5}};
    for (int dim = 0; dim < 4; ++dim)
      for (int e = 0; e < 3; ++e) {
        Entity entity{
            .dim = dim, .groups = static_cast<std::int32_t>(below(4)), .tag = 10 * e + below(10) + 1};
        for (double& x : entity.box) x = static_cast<double>(below(1000)) / 7;
        if (dim == 0) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
        for (std::int64_t k = below(4); dim > 0 && k > 0; --k) entity.boundary.push_back(below(9) - 4);
        document.entities.push_back(entity);
      }
    for (const Entity& entity : document.entities) {
      NodeBlock nodes{.dim = entity.dim, .entity = entity.tag, .first = document.points.size()};
      nodes.count = static_cast<std::size_t>(below(30));
      nodes.parameters_each = below(2) ? entity.dim : 0;
      nodes.parameters = document.parameters.size();
      for (std::size_t i = 0; i < nodes.count; ++i) {
        document.points.emplace_back(any_double(random), any_double(random), any_double(random));
        document.node_tags.push_back(
            (below(1LL << 60) << 8 | static_cast<std::int64_t>(document.points.size() & 255)) + 1);
      }
      for (std::size_t k = 0; k < nodes.count * nodes.parameters_each; ++k)
        document.parameters.push_back(any_double(random));
      if (nodes.count > 0) document.node_blocks.push_back(nodes);
    }
    if (document.points.empty()) continue;
    static constexpr int types[4][2] = {{15, 1}, {8, 3}, {9, 6}, {11, 10}};
    for (const Entity& entity : document.entities) {
      ElementBlock block{.type = types[entity.dim][0],
                         .dim = entity.dim,
                         .entity = entity.tag,
                         .groups = entity.groups,
                         .nodes_each = types[entity.dim][1],
                         .count = static_cast<std::size_t>(below(20) + 1)};
      block.first = document.elements();
      block.nodes = document.connectivity.size();
      document.blocks.push_back(block);
      for (std::size_t k = 0; k < block.count * block.nodes_each; ++k)
        document.connectivity.push_back(static_cast<Index>(below(document.points.size())));
      for (std::size_t k = 0; k < block.count; ++k) document.element_tags.push_back(below(1LL << 62));
    }
    document.group_names = {{3, 7, "a name"}, {2, 1, "caf\xc3\xa9 \"x\""}};
    document.sections = {{.name = "Mine", .body = "1 2 3\n", .format = "msh41"}};
    const std::string text = test::text_of(document);
    for (bool binary : {false, true}) {
      EXPECT_TRUE(losses("x.msh", document, {.binary = binary}).empty());
      write_document(files.path("x.msh"), document, {.binary = binary});
      EXPECT_EQ(test::text_of(read_document(files.path("x.msh"))), text);
    }
  }
}

TEST(RoundTrip, SurfacesThroughMsh) {
  const test::TestFiles files;
  std::mt19937_64 random(4);
  TriangleSurface surface;
  for (int i = 0; i < 100; ++i)
    surface.vertices.emplace_back(any_double(random), any_double(random), any_double(random));
  for (int i = 0; i < 200; ++i)
    surface.triangles.push_back({static_cast<Index>(i % 100), static_cast<Index>(random() % 100),
                                 static_cast<Index>(random() % 100)});
  for (const char* name : {"a.off", "a.obj", "a.ply"})
    for (const char* format : {"msh41", "msh22"})
      for (bool binary : {false, true}) {
        SCOPED_TRACE(fmt::format("{} {} {}", name, format, binary));
        write_document(files.path("a.msh"), document_of(surface), {.format = format, .binary = binary});
        const Document middle = read_document(files.path("a.msh"));
        EXPECT_TRUE(losses(files.path(name), middle).empty());
        write_document(files.path(name), middle);
        const TriangleSurface end = surface_of(read_document(files.path(name)));
        ASSERT_EQ(end.vertices.size(), surface.vertices.size());
        for (std::size_t i = 0; i < end.vertices.size(); ++i)
          ASSERT_EQ(std::memcmp(end.vertices[i].data(), surface.vertices[i].data(), 24), 0) << i;
        EXPECT_EQ(end.triangles, surface.triangles);
      }
}

// The bytes are the same for any number of threads, and the fast paths for numbers agree with the slow one.
TEST(RoundTrip, NumbersReadFastAsSlow) {
  std::mt19937_64 random(9);
  std::vector<std::string> words{
      "0", "-0", "+5", "999999999999999999", "9223372036854775807", "-9223372036854775808", "00012"};
  for (int i = 0; i < 2000; ++i)
    words.push_back(std::to_string(static_cast<std::int64_t>(random()) >> random() % 60));
  const std::string path = "words";
  for (const std::string& word : words) {
    io::Numbers fast(path, word, 0, false, false);
    std::int64_t slow = 0;
    ASSERT_TRUE(parse_integer(word, slow)) << word;
    EXPECT_EQ(fast.integer("a number"), slow) << word;
  }
}

}  // namespace
}  // namespace tetproof
