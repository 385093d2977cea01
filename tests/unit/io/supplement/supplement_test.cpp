// SPDX-License-Identifier: GPL-3.0-or-later
// What .msh and TetGen files keep aside comes back, unless the file was changed in the meantime.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/supplement/supplement.hpp"
#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof {
namespace {

// A document with something in each of its parts.
Document everything() {
  Document d;
  d.path = "everything";
  d.title = "a title\nof two lines, with $ and # and \\ and caf\xc3\xa9";
  d.points = {{0, 0, 0}, {0.1, 0, -0.0}, {0, 5e-324, 0}, {0, 0, 1e300}, {1, 1, 1}};
  d.node_tags = {7, 1LL << 61, 3, 5, 11};
  d.node_blocks = {{.dim = 2, .entity = 9, .first = 1, .count = 2, .parameters_each = 2}};
  d.parameters = {0.5, -0.0, 1, 2};
  d.tag_sets = {{}, {7, -8}, {9}, {2, -3}};
  d.blocks = {
      {.type = 2, .dim = 2, .entity = 9, .groups = 1, .nodes_each = 3, .count = 2},
      {.type = 4,
       .dim = 3,
       .entity = 4,
       .partitions = 3,
       .nodes_each = 4,
       .count = 2,
       .first = 2,
       .nodes = 6},
      {.type = 34, .dim = 2, .nodes_each = 5, .count = 1, .first = 4, .nodes = 14, .of_boundary = true},
      {.type = 4, .dim = 3, .entity = 4, .groups = 2, .nodes_each = 4, .count = 1, .first = 5, .nodes = 19}};
  d.connectivity = {0, 1, 2, 0, 2, -1, 0, 1, 2, 3, 1, 2, -2, 3, 0, 1, 2, 3, 4, 4, 3, 2, 1};
  d.unknown = {99, 2};
  d.element_tags = {5, 6, 1LL << 40, 3, 8, 2};
  d.entities = {
      {.dim = 3, .tag = 4, .box = {0, 0, 0, 1, 1, 1}, .boundary = {9, -10}},
      {.dim = 3, .tag = 44, .box = {}, .boundary = {}, .parent_dim = 3, .parent = 4, .partitions = 3}};
  d.group_names = {{3, 9, "a \"name\" with blanks"}, {2, 7, std::string(300, 'x')}};
  d.partitions = 3;
  d.ghosts = {{12, 2}};
  d.ghost_elements = {{.element = 3, .partition = 1, .ghosts = {2, 3}}, {.element = -1, .partition = 2}};
  d.periodic = {{.dim = 2, .entity = 9, .master = 8, .affine = {1, 0.1, 0}, .nodes = {{0, 1}, {2, -2}}}};
  d.node_values = {
      {.name = "attributes", .components = 2, .reals = {1, 2, 3, 4, 5, 6, 7, 8, 9, -0.0}},
      {.name = "T", .reals = {0.1, 0.2}, .at = {2, -1}, .of_view = true, .time = 0.5, .step = 3}};
  d.element_values = {
      {.name = "material", .integers = {0, 1, 1}, .labels = {"steel", "hot air"}, .first = 2}};
  d.element_node_values = {
      {.name = "s", .components = 1, .reals = {1, 2, 3, 4, 5}, .first = 0, .nodes = {3, 2}}};
  d.facets = {{.first = 4, .polygons = 1, .holes = {{0.25, 0.5, 0.125}}}};
  d.holes = {{1, 2, 3}};
  d.regions = {{.point = {4, 5, 6}, .attribute = 2.25, .max_volume = 0.1}};
  d.area_bounds = {{-1, 0.3}};
  d.length_bounds = {{{0, -2}, 0.7}};
  d.voronoi.points = {{1, 2, 3}};
  d.voronoi.edges = {{{0, -1}, {0, 0, 1}}};
  d.voronoi.faces = {{{0, 1}, {0, -1}}};
  d.voronoi.cells = {{0, -1}};
  d.tables = {{.name = "edge", .rows = 2, .columns = {{.name = "v", .type = "int", .integers = {1, 2}}}}};
  d.sections = {{.name = "Mine", .body = "x\n", .format = "msh41"},
                {.name = "Periodic", .body = std::string("\0\1\2", 3), .format = "msh22", .binary = true}};
  return d;
}

// Unknown numbers may come back in another order, and twice: once for nodes and once for elements. Sorts them
// and removes duplicates.
Document with_sorted_unknown(Document d) {
  std::vector<std::int64_t> sorted = d.unknown;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const auto rename = [&](Index& i) {
    if (i >= 0) return;
    const std::int64_t number = d.unknown.at(static_cast<std::size_t>(-1 - i));
    i = -1 - static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
  };
  for (Index& i : d.connectivity) rename(i);
  for (auto* all : {&d.node_values, &d.element_values, &d.element_node_values})
    for (Values& v : *all)
      for (Index& i : v.at) rename(i);
  for (auto& g : d.ghost_elements) rename(g.element);
  for (auto& l : d.periodic)
    for (auto& pair : l.nodes) rename(pair[0]), rename(pair[1]);
  for (auto& b : d.length_bounds) rename(b.nodes[0]), rename(b.nodes[1]);
  d.unknown = sorted;
  return d;
}

// Whether it is the warning of .msh 2.2 that elements in several groups are listed once for each, or that
// of 4.1 about the three numbers of an affine transformation.
bool is_of_the_document(const std::string& warning) {
  return warning.find("further physical group") != warning.npos ||
         warning.find("an affine transformation has not 16 numbers") != warning.npos;
}

// The whole document as text: its supplement, which has everything but the points, and the points.
std::string told(Document document) {
  if (!document.node_tags.empty()) document.first_node = 0;
  if (!document.element_tags.empty()) document.first_element = 0;
  io::Holds nothing;
  nothing.kept_in = "here";
  std::string text = io::supplement_of(document, nothing);
  for (const Eigen::Vector3d& p : document.points) text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
  return text;
}

struct Target {
  std::string file;
  WriteOptions options;
  friend void PrintTo(const Target& target, std::ostream* out) {
    *out << target.file << target.options.format;
  }
};

class Supplement : public testing::TestWithParam<Target> {};

TEST_P(Supplement, BringsEverythingBack) {
  const test::TestFiles files;
  const std::string path = files.path(GetParam().file);
  Document document = everything();
  if (GetParam().options.binary.value_or(false)) document.tag_sets[1] = {7, -8};
  EXPECT_TRUE(losses(path, document, GetParam().options).empty());
  EXPECT_FALSE(kept_aside(path, document, GetParam().options).items.empty());
  write_document(path, document, GetParam().options);
  Document again = read_document(path);
  std::erase_if(again.warnings, is_of_the_document);
  EXPECT_EQ(again.warnings.size(), 0u) << again.warnings[0];
  EXPECT_EQ(test::text_of(again, false), test::text_of(document, false));
  EXPECT_EQ(told(with_sorted_unknown(again)), told(with_sorted_unknown(document)));
}

TEST_P(Supplement, IsIgnoredWhenTheFileWasChanged) {
  const test::TestFiles files;
  const std::string path = files.path(GetParam().file);
  write_document(path, everything(), GetParam().options);
  std::string bytes = test::TestFiles::read(path);
  const std::size_t supplement = bytes.find("tetproof 1");
  ASSERT_NE(supplement, bytes.npos);
  bytes.insert(bytes.rfind('\n', supplement - (GetParam().file == "a.node" ? 4 : 22)), 1, ' ');
  files.write(GetParam().file, bytes);
  Document again = read_document(path);
  std::erase_if(again.warnings, is_of_the_document);
  ASSERT_EQ(again.warnings.size(), 1u);
  EXPECT_NE(again.warnings[0].find("the supplement is ignored"), std::string::npos) << again.warnings[0];
  EXPECT_TRUE(again.group_names.size() < 2 || again.title.empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, Supplement,
                         testing::Values(Target{"a.msh", {}}, Target{"a.msh", {.binary = true}},
                                         Target{"a.msh", {.format = "msh22"}},
                                         Target{"a.msh", {.format = "msh22", .binary = true}},
                                         Target{"a.node", {}}));

// A format that lists tetrahedra first and triangles last, with few and with many changes between the two.
TEST(SupplementOrder, OfBlocksByKindIsTakenBack) {
  for (const int blocks : {1, 2, 3, 5, 12, 60}) {
    std::mt19937 random(static_cast<unsigned>(blocks));
    Document document, native;
    document.points.assign(1000, {0.5, 0.25, 0.125});
    native.points = document.points;
    for (int b = 0; b < blocks; ++b) {
      const bool tetrahedra = blocks < 4 ? b == blocks - 1 : random() % 2 == 0;
      document.blocks.push_back({.type = tetrahedra ? 4 : 2,
                                 .dim = tetrahedra ? 3 : 2,
                                 .entity = 7 + b,
                                 .nodes_each = tetrahedra ? 4 : 3,
                                 .count = random() % 30,
                                 .first = document.elements(),
                                 .nodes = document.connectivity.size()});
      for (std::size_t k = document.blocks.back().count * (tetrahedra ? 4 : 3); k > 0; --k)
        document.connectivity.push_back(static_cast<Index>(random() % 1000));
    }
    for (const int type : {4, 2}) {  // a reader makes one block of each kind
      ElementBlock all{.type = type, .dim = type == 4 ? 3 : 2, .nodes_each = type == 4 ? 4 : 3};
      all.first = native.elements(), all.nodes = native.connectivity.size();
      for (const ElementBlock& block : document.blocks) {
        if (block.type != type) continue;
        const auto from = document.connectivity.begin() + static_cast<std::ptrdiff_t>(block.nodes);
        native.connectivity.insert(native.connectivity.end(), from,
                                   from + static_cast<std::ptrdiff_t>(block.count) * block.nodes_each);
        all.count += block.count;
      }
      if (all.count > 0) native.blocks.push_back(all);
    }
    io::Holds holds;
    holds.kept_in = "here";
    holds.nodes_each = [](const ElementBlock& block) { return block.nodes_each; };
    holds.kind = [](const ElementBlock& block) { return -block.dim; };
    io::take_back(io::supplement_head({}) + io::supplement_of(document, holds), "here", native);
    EXPECT_EQ(native.connectivity, document.connectivity) << blocks;
    EXPECT_EQ(told(native), told(document)) << blocks;
  }
}

TEST(SupplementErrors, ArePlain) {
  const test::TestFiles files;
  write_document(files.path("a.node"), everything());
  const std::string bytes = test::TestFiles::read(files.path("a.node"));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = bytes;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, changed.npos) << from;
    changed.replace(at, from.size(), to);
    files.write("a.node", changed);
    return files.message([&] { read_document(files.path("a.node")); });
  };
  EXPECT_NE(with("blocks 4", "blocks 999999999").find("999999999 things announced, more than the"),
            std::string::npos);
  EXPECT_NE(with("blocks 4", "blocks 9").find("supplement"), std::string::npos);
  EXPECT_NE(with("tag_sets 4 0", "tag_sets 4 1").find("supplement"), std::string::npos);
  EXPECT_NE(with("facets 1 4 1", "facets 1 6 1").find("facets do not fit the file"), std::string::npos);
  EXPECT_NE(with("facets 1 4 1", "facts 1 4 1").find("expected the name of a field, found 'facts'"),
            std::string::npos);
  files.write("a.node", bytes.substr(0, bytes.size() - 40));
  EXPECT_NE(files.message([&] { read_document(files.path("a.node")); }), "no error");
  std::string newer = bytes;
  newer.replace(newer.find("tetproof 1"), 10, "tetproof 2");
  files.write("a.node", newer);
  EXPECT_EQ(read_document(files.path("a.node")).warnings.size(), 1u);
}

}  // namespace
}  // namespace tetproof
