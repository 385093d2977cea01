// SPDX-License-Identifier: GPL-3.0-or-later
// The writers of TetGen's mesh files (.node, .ele, .face, ...): where each part is written, and that it comes
// back.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/tetgen/tetgen.hpp"
#include "tests/support/tetgen_text.hpp"
#include "tests/unit/io/tetgen/tetgen_documents.hpp"

namespace tetproof {
namespace {

using test::integers;
using test::reals;
using test::tetgen_document;

TEST(TetgenWrite, TheWholeSet) {
  const test::TestFiles files;
  const Document document = tetgen_document();
  write_document(files.path("a.1.face"), document);
  const auto text = [&](const char* ending) {
    return test::TestFiles::read(files.path(std::string("a.1") + ending));
  };
  EXPECT_EQ(text(".node"),
            "4 3 2 1\n0 0 0 0 1 2 1\n1 0.1 0 0 3 4 -1\n2 -0 1 0 5 6 0\n3 0 0 5e-324 7 0.1 9\n");
  EXPECT_EQ(text(".ele"), "1 4 1\n0 0 1 2 3 2.25\n");
  EXPECT_EQ(text(".face"), "2 1\n0 0 1 2 -7 0 -1\n1 0 1 3 7 -1 0\n");
  EXPECT_EQ(text(".edge"), "1 1\n0 2 3 5 0\n");
  EXPECT_EQ(text(".neigh"), "1 4\n0 -1 -1 -1 -1\n");
  EXPECT_EQ(text(".t2f"), "0 3 2 1 0\n");
  EXPECT_EQ(text(".t2e"), "0 0 1 2 3 4 5\n");
  EXPECT_EQ(text(".f2e"), "0 0 1 2\n1 2 1 0\n");
  EXPECT_EQ(text(".vol"), "1\n0 0.125\n");
  EXPECT_EQ(text(".mtr"), "4 1\n1\n2\n3\n4\n");
  EXPECT_EQ(text(".var"), "1\n0 -7 0.5\n1\n0 2 3 0.25\n");
  EXPECT_EQ(text(".v.node"), "1 3 0 0\n0 1 2 3\n");
  EXPECT_EQ(text(".v.edge"), "1 0\n0 0 -1 0 0 -1\n");
  EXPECT_EQ(text(".v.face"), "1 0\n0 0 1 2 0 -1\n");
  EXPECT_EQ(text(".v.cell"), "1\n0 2 0 -1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.1.neigh"))), test::tetgen_text(document));
}

// `Holds` says what comes back.
TEST(TetgenWrite, HoldsAllOfItsOwn) {
  const Document document = tetgen_document();
  const io::Holds holds = io::plan_tetgen(document, false)->holds();
  EXPECT_TRUE(holds.element_tags && holds.unknown_nodes && holds.bounds && holds.voronoi);
  EXPECT_FALSE(holds.facets || holds.holes || holds.regions);
  for (const Values& values : document.node_values)
    EXPECT_TRUE(holds.values(values, io::Of::node)) << values.name;
  for (const Values& values : document.element_values)
    EXPECT_TRUE(holds.values(values, io::Of::element)) << values.name;
  EXPECT_EQ(holds.groups, io::Holds::Groups::first);
  for (const ElementBlock& block : document.blocks) {
    EXPECT_EQ(holds.nodes_each(block), block.nodes_each);
    EXPECT_EQ(holds.kind(block), 3 - block.dim);
    EXPECT_TRUE(holds.groups_of(block));
  }
}

TEST(TetgenWrite, HoldsNoValuesOfOtherElementsOrKinds) {
  Document document = tetgen_document();
  document.node_values = {reals("attributes", 1, {1, 2}), integers("attributes", 1, 0, {1, 2, 3, 4}),
                          reals("markers", 1, {1, 2, 3, 4}), reals("sizes", 2, {1, 2, 3, 4, 5, 6, 7, 8}),
                          reals("temperature", 1, {1, 2, 3, 4})};
  document.node_values.push_back(reals("sizes", 1, {1, 2}));
  document.node_values.back().at = {0, 3};
  document.element_values = {integers("markers", 1, 1, {1}), integers("markers", 1, 0, {1, 2, 3, 4}),
                             integers("neighbours", 3, 0, {1, 2, 3}), reals("attributes", 1, {1, 2})};
  const io::Holds holds = io::plan_tetgen(document, false)->holds();
  for (const Values& values : document.node_values)
    EXPECT_FALSE(holds.values(values, io::Of::node)) << values.name;
  for (const Values& values : document.element_values)
    EXPECT_FALSE(holds.values(values, io::Of::element)) << values.name;
  // None of them is written; they are kept aside. The groups stand in the columns of markers.
  const test::TestFiles files;
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.node")).substr(0, 8), "4 3 0 0\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "2 1\n0 0 1 2 0\n1 0 1 3 7\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.node"))), test::tetgen_text(document));
}

TEST(TetgenWrite, VoronoiThatItsFilesCannotSay) {
  Document document = tetgen_document();
  document.voronoi.cells = {{-1, 0}};
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().voronoi);
  document.voronoi.cells.clear();
  document.voronoi.first = 7;
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().voronoi);
}

TEST(TetgenWrite, KindByKind) {
  const test::TestFiles files;
  Document document = tetgen_document();
  std::swap(document.blocks[0], document.blocks[3]);  // an edge, two faces, a tetrahedron
  for (std::size_t b = 0; b < 4; ++b) document.blocks[b].first = b;
  document.element_values.clear();
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().element_tags);
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 4 0\n0 0 1 2 3\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n0 2 3 5\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// Values with the same name come back in their places, even if the files have them in another order.
TEST(TetgenWrite, ValuesInAnotherOrder) {
  const test::TestFiles files;
  Document document = tetgen_document();
  std::reverse(document.node_values.begin(), document.node_values.end());
  std::reverse(document.element_values.begin(), document.element_values.end());
  document.title = "kept aside";
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// If a document has no attributes and markers, the first physical group is written in their place, and is
// read as a group again.
TEST(TetgenWrite, GroupsAreTetgensAttributesAndMarkers) {
  const test::TestFiles files;
  Document document;
  document.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  document.tag_sets = {{}, {7, 8}, {-6}};
  document.blocks = {
      {.type = 4, .dim = 3, .entity = 1, .groups = 1, .nodes_each = 4, .count = 1},
      {.type = 2, .dim = 2, .entity = 1, .groups = 2, .nodes_each = 3, .count = 1, .first = 1, .nodes = 4},
      {.type = 2, .dim = 2, .entity = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 7}};
  document.connectivity = {0, 1, 2, 3, 0, 2, 1, 0, 1, 3};
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 4 1\n1 1 2 3 4 7\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "2 1\n1 1 3 2 -6\n2 1 2 4 0\n");
  const Document again = read_document(files.path("a.node"));
  EXPECT_TRUE(again.element_values.empty());
  ASSERT_EQ(again.blocks.size(), 3u);
  EXPECT_EQ(again.tag_sets[static_cast<std::size_t>(again.blocks[0].groups)],
            (std::vector<std::int64_t>{7, 8}));

  const auto lines_of = [&](const char* name) { return test::TestFiles::read(files.path(name)); };
  write_document(files.path("b.poly"), document);
  EXPECT_NE(lines_of("b.poly").find("\n2 1\n1 0 -6\n3 1 3 2\n1 0 0\n3 1 2 4\n0\n0\n"), std::string::npos)
      << lines_of("b.poly");
  write_document(files.path("c.smesh"), document);
  EXPECT_NE(lines_of("c.smesh").find("\n2 1\n3 1 3 2 -6\n3 1 2 4 0\n0\n0\n"), std::string::npos)
      << lines_of("c.smesh");

  document.element_values = {{.name = "attributes", .reals = {0.5}}};  // attributes win over groups
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 4 1\n1 1 2 3 4 0.5\n");
}

// Negative markers of triangles without groups, as other formats give them back: for all elements, with 0 for
// none; as reals; of some. They never take the column from the groups.
TEST(TetgenWrite, NegativeMarkersBesideGroups) {
  const test::TestFiles files;
  Document document;
  document.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  document.tag_sets = {{}, {5}};
  document.blocks = {{.type = 4, .dim = 3, .nodes_each = 4, .count = 1},
                     {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 1, .nodes = 4},
                     {.type = 2, .dim = 2, .groups = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 7},
                     {.type = 1, .dim = 1, .groups = 1, .nodes_each = 2, .count = 1, .first = 3, .nodes = 10},
                     {.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 4, .nodes = 12}};
  document.connectivity = {0, 1, 2, 3, 0, 2, 1, 0, 1, 3, 0, 1, 1, 2};
  const auto written = [&](const Values& values) {
    document.element_values = {values};
    std::string text;
    for (const Loss& loss : kept_aside(files.path("a.ele"), document).items) text += loss.item + "; ";
    write_document(files.path("a.ele"), document);
    for (const char* name : {"a.face", "a.edge"}) text += test::TestFiles::read(files.path(name));
    return text;
  };
  const std::string columns = "2 1\n1 1 3 2 -1\n2 1 2 4 5\n2 1\n1 1 2 5\n2 2 3 -2\n";
  EXPECT_EQ(written(integers("markers", 1, 0, {0, -1, 0, 0, -2})), columns);
  EXPECT_EQ(written(reals("markers", 1, {0, -1, 0, 0, -2})), columns);
  Values some = reals("markers", 1, {-2, -1});
  some.at = {4, 1};
  EXPECT_EQ(written(some), columns);
  const Document back = read_document(files.path("a.ele"));
  EXPECT_EQ(back.element_values.size(), 2u);  // those of triangles and those of lines

  EXPECT_EQ(written(integers("markers", 1, 0, {0, -3000000000, 0, 0, -2})),
            "values \"markers\" of elements; 2 1\n1 1 3 2 0\n2 1 2 4 5\n2 1\n1 1 2 5\n2 2 3 -2\n");

  // What the column cannot say stays in the comments.
  const std::string groups = "2 1\n1 1 3 2 0\n2 1 2 4 5\n2 1\n1 1 2 5\n2 2 3 0\n";
  for (const auto& numbers : {std::vector<double>{0, -1.5, 0, 0, -2.5}, {0, -1, -1, -2, 0}, {0, 4, 0, 0, 4}})
    EXPECT_EQ(written(reals("markers", 1, numbers)), "values \"markers\" of elements; " + groups);
}

// Words of other tools for the one number of a node.
TEST(TetgenWrite, ReferencesOfNodesAreMarkers) {
  for (const Values& values :
       {integers("references", 1, 0, {7, 0, -3, 1}), reals("medit:ref", 1, {7, 0, -3, 1}),
        integers("tetgen:ref", 1, 0, {7, 0, -3, 1})}) {
    const test::TestFiles files;
    Document document = tetgen_document();
    document.node_values = {values};
    EXPECT_TRUE(kept_aside(files.path("a.node"), document).items.empty()) << values.name;
    write_document(files.path("a.node"), document);
    EXPECT_EQ(test::TestFiles::read(files.path("a.node")),
              "4 3 0 1\n0 0 0 0 7\n1 0.1 0 0 0\n2 -0 1 0 -3\n3 0 0 5e-324 1\n");
    document.node_values = {integers("markers", 1, 0, {7, 0, -3, 1})};
    EXPECT_EQ(test::tetgen_text(read_document(files.path("a.node"))), test::tetgen_text(document));
  }
}

TEST(TetgenWrite, SaysWhichFilesAreLeftOver) {
  const test::TestFiles files;
  Document document = tetgen_document();
  EXPECT_EQ(write_warning(files.path("a.node"), document), "");
  for (const char* name : {"a.vol", "a.edge", "a.poly", "a.off"}) files.write(name, "");
  EXPECT_EQ(write_warning(files.path("a.node"), document), "");
  document.element_values.clear();
  const std::string folder = files.path("");
  EXPECT_EQ(write_warning(files.path("a.node"), document),
            folder + "a.vol: is there already and is not written, but will be read together with it");
  document.blocks.pop_back();
  EXPECT_EQ(write_warning(files.path("a.smesh"), document),
            folder + "a.edge, " + folder +
                "a.poly: are there already and are not written, but will be read together with it");
}

TEST(TetgenWrite, RefusesAFileWithNothingInIt) {
  const test::TestFiles files;
  Document document = tetgen_document();
  document.element_values.clear();
  EXPECT_EQ(files.message([&] { write_document(files.path("a.neigh"), document); }),
            "a.neigh: cannot write it: there is nothing in the mesh to stand in it");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
}

}  // namespace
}  // namespace tetproof
