// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of TetGen's files put where, and that it comes back.
#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen.hpp"
#include "tests/support/tetgen_text.hpp"

namespace tetproof {
namespace {

const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {0.1, 0, 0}, {-0.0, 1, 0}, {0, 0, 5e-324}};

Values integers(const char* name, int components, std::size_t first, std::vector<std::int64_t> numbers) {
  return {.name = name,
          .components = components,
          .reals = {},
          .integers = std::move(numbers),
          .labels = {},
          .first = first};
}
Values reals(const char* name, int components, std::vector<double> numbers) {
  return {.name = name, .components = components, .reals = std::move(numbers), .integers = {}};
}

// A tetrahedron, two of its faces and an edge, with everything that TetGen says of them.
Document full() {
  Document document;
  document.points = points;
  document.first_node = document.first_element = 0;
  document.blocks = {{.type = 4, .dim = 3, .nodes_each = 4, .count = 1},
                     {.type = 2, .dim = 2, .nodes_each = 3, .count = 2, .first = 1, .nodes = 4},
                     {.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 3, .nodes = 10}};
  document.connectivity = {0, 1, 2, 3, 0, 1, 2, 0, 1, 3, 2, 3};
  document.node_values = {reals("attributes", 2, {1, 2, 3, 4, 5, 6, 7, 0.1}),
                          integers("markers", 1, 0, {1, -1, 0, 9}), reals("sizes", 1, {1, 2, 3, 4})};
  document.element_values = {reals("attributes", 1, {2.25}),
                             integers("markers", 1, 1, {-7, 7}),
                             integers("neighbours", 2, 1, {0, -1, -1, 0}),
                             integers("markers", 1, 3, {5}),
                             integers("neighbours", 1, 3, {0}),
                             integers("neighbours", 4, 0, {-1, -1, -1, -1}),
                             integers("faces", 4, 0, {3, 2, 1, 0}),
                             integers("edges", 6, 0, {0, 1, 2, 3, 4, 5}),
                             integers("edges", 3, 1, {0, 1, 2, 2, 1, 0}),
                             reals("volume bounds", 1, {0.125})};
  document.area_bounds = {{-7, 0.5}};
  document.length_bounds = {{{2, 3}, 0.25}};
  document.voronoi.points = {{1, 2, 3}};
  document.voronoi.edges = {{.points = {0, -1}, .direction = {0, 0, -1}}};
  document.voronoi.faces = {{.cells = {0, 1}, .edges = {0, -1}}};
  document.voronoi.cells = {{0, -1}};
  document.voronoi.first = 0;
  return document;
}

TEST(TetgenWrite, TheWholeSet) {
  const test::TestFiles files;
  const Document document = full();
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

// Whatever is written comes back as `Holds` says.
TEST(TetgenWrite, HoldsAllOfItsOwn) {
  const Document document = full();
  const io::Holds holds = io::plan_tetgen(document, false)->holds();
  EXPECT_TRUE(holds.element_tags && holds.unknown_nodes && holds.bounds && holds.voronoi);
  EXPECT_FALSE(holds.facets || holds.holes || holds.regions);
  for (const Values& values : document.node_values)
    EXPECT_TRUE(holds.values(values, io::Of::node)) << values.name;
  for (const Values& values : document.element_values)
    EXPECT_TRUE(holds.values(values, io::Of::element)) << values.name;
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(holds.nodes_each(document.blocks[b]), document.blocks[b].nodes_each);
    EXPECT_EQ(holds.kind(document.blocks[b]), static_cast<int>(b));
  }
}

TEST(TetgenWrite, HoldsNoValuesOfOtherElementsOrKinds) {
  Document document = full();
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
  // It writes none of them, but keeps them aside.
  const test::TestFiles files;
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.node")).substr(0, 8), "4 3 0 0\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")).substr(0, 4), "2 0\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.node"))), test::tetgen_text(document));
}

TEST(TetgenWrite, VoronoiThatItsFilesCannotSay) {
  Document document = full();
  document.voronoi.cells = {{-1, 0}};
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().voronoi);
  document.voronoi.cells.clear();
  document.voronoi.first = 7;
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().voronoi);
}

Document second_order(bool first_order_faces) {
  Document document;
  document.points = {{0, 0, 0},    {1, 0, 0},  {0, 1, 0},  {0, 0, 1},   {.5, 0, 0},
                     {.5, .5, .3}, {0, .5, 0}, {0, 0, .5}, {0, .5, .5}, {.5, 0, .5}};
  document.blocks = {{.type = 11, .dim = 3, .nodes_each = 10, .count = 1}};
  document.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  if (first_order_faces) {
    document.blocks.push_back({.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 1, .nodes = 10});
    document.blocks.push_back({.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 2, .nodes = 13});
    document.connectivity.insert(document.connectivity.end(), {0, 1, 2, 0, 1});
  } else {
    document.blocks.push_back({.type = 9, .dim = 2, .nodes_each = 6, .count = 1, .first = 1, .nodes = 10});
    document.blocks.push_back({.type = 8, .dim = 1, .nodes_each = 3, .count = 1, .first = 2, .nodes = 16});
    document.connectivity.insert(document.connectivity.end(), {0, 1, 2, 4, 5, 6, 0, 1, 4});
  }
  document.element_values = {integers("markers", 1, 1, {3}), integers("neighbours", 2, 1, {1, -1}),
                             integers("markers", 1, 2, {4}), integers("neighbours", 1, 2, {1})};
  return document;
}

TEST(TetgenWrite, SecondOrder) {
  const test::TestFiles files;
  const Document document = second_order(false);
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 10 0\n1 1 2 3 4 9 8 5 6 10 7\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "1 1\n1 1 2 3 5 6 7 3 1 -1\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n1 1 2 5 4 1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// Nodes between corners in an order that the reader would take for that of one of TetGen's switches, and
// change, are not written but come back from the comments.
TEST(TetgenWrite, SecondOrderInAnotherOrder) {
  const test::TestFiles files;
  Document straight = second_order(false);
  straight.points[5] = {.5, .5, 0};
  Document turned = straight, opposite = straight;
  std::swap(turned.connectivity[5], turned.connectivity[6]);
  std::swap(turned.connectivity[7], turned.connectivity[9]);
  std::rotate(opposite.connectivity.begin() + 13, opposite.connectivity.begin() + 14,
              opposite.connectivity.begin() + 16);
  for (const auto& [document, ele, face] : {std::tuple(straight, 10, 6), {turned, 4, 3}, {opposite, 10, 3}}) {
    write_document(files.path("a.ele"), document);
    const Document back = read_document(files.path("a.ele"));
    EXPECT_EQ(back.connectivity, document.connectivity);
    EXPECT_EQ(test::tetgen_text(back), test::tetgen_text(document));
    const auto words = [&](const char* file) {  // of the second line
      std::istringstream text(test::TestFiles::read(files.path(file)));
      std::string line;
      std::getline(text, line), std::getline(text, line);
      std::istringstream of_line(line);
      return std::distance(std::istream_iterator<std::string>(of_line), {});
    };
    EXPECT_EQ(words("a.ele"), 1 + ele);
    EXPECT_EQ(words("a.face"), 1 + face + 1 + (face == 6 || ele == 4 ? 2 : 0));
    std::vector<std::string> aside;
    for (const Loss& loss : kept_aside(files.path("a.ele"), document).items)
      if (loss.item.starts_with("nodes between")) aside.push_back(loss.item);
    EXPECT_EQ(aside.size(), ele == 10 ? face == 6 ? 0 : 1 : 3);
  }
}

// Tetrahedra behind bare corners would be taken for nodes between them.
TEST(TetgenWrite, FirstOrderBesideSecondOrder) {
  const test::TestFiles files;
  const Document document = second_order(true);
  const io::Holds holds = io::plan_tetgen(document, false)->holds();
  EXPECT_TRUE(holds.values(document.element_values[0], io::Of::element));
  EXPECT_FALSE(holds.values(document.element_values[1], io::Of::element));
  EXPECT_FALSE(holds.values(document.element_values[3], io::Of::element));
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.face")), "1 1\n1 1 2 3 3\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n1 1 2 4\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

TEST(TetgenWrite, KindByKind) {
  const test::TestFiles files;
  Document document = full();
  std::swap(document.blocks[0], document.blocks[2]);  // an edge, two faces, a tetrahedron
  document.blocks[0].first = 0, document.blocks[1].first = 1, document.blocks[2].first = 3;
  document.element_values.clear();
  EXPECT_FALSE(io::plan_tetgen(document, false)->holds().element_tags);
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 4 0\n0 0 1 2 3\n");
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 0\n0 2 3\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// Values of the same name that stand in another order than their files come back where they were.
TEST(TetgenWrite, ValuesInAnotherOrder) {
  const test::TestFiles files;
  Document document = full();
  std::reverse(document.node_values.begin(), document.node_values.end());
  std::reverse(document.element_values.begin(), document.element_values.end());
  document.title = "kept aside";
  write_document(files.path("a.ele"), document);
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.ele"))), test::tetgen_text(document));
}

// A square with a hole and an edge in it, a triangle, a hexagon.
Document boundary() {
  Document document;
  document.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  document.blocks = {
      {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .of_boundary = true},
      {.type = 3, .dim = 2, .nodes_each = 4, .count = 1, .first = 1, .nodes = 3, .of_boundary = true},
      {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 2, .nodes = 7, .of_boundary = true},
      {.type = 1, .dim = 1, .nodes_each = 2, .count = 1, .first = 3, .nodes = 10, .of_boundary = true},
      {.type = 34, .dim = 2, .nodes_each = 6, .count = 1, .first = 4, .nodes = 12, .of_boundary = true}};
  document.connectivity = {0, 1, 2, 0, 1, 2, 3, 4, 5, 6, 0, 4, 0, 1, 2, 3, 4, 5};
  document.element_values = {integers("markers", 1, 0, {1, -2, -2, -2, 3})};
  document.facets = {{.first = 1, .polygons = 3, .holes = {{1.25, 1.25, 0}}}};
  document.holes = {{1, 2, 3}};
  document.regions = {{{1, 1, 1}, 2.25, -1}};
  return document;
}

TEST(TetgenWrite, Poly) {
  const test::TestFiles files;
  const Document document = boundary();
  write_document(files.path("a.poly"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.poly")),
            "7 3 0 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 1 1 0\n6 2 1 0\n7 1 2 0\n"
            "3 1\n1 0 1\n3 1 2 3\n3 1 -2\n4 1 2 3 4\n3 5 6 7\n2 1 5\n1 1.25 1.25 0\n1 0 3\n6 1 2 3 4 5 6\n"
            "1\n1 1 2 3\n1\n1 1 1 1 2.25 -1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.poly"))), test::tetgen_text(document));
  const io::Holds holds = io::plan_poly(document, false)->holds();
  EXPECT_TRUE(holds.facets && holds.holes && holds.regions && holds.element_tags);
  EXPECT_TRUE(holds.values(document.element_values[0], io::Of::element));
  for (const ElementBlock& block : document.blocks) EXPECT_EQ(holds.nodes_each(block), block.nodes_each);
}

TEST(TetgenWrite, Smesh) {
  const test::TestFiles files;
  Document document = boundary();
  EXPECT_EQ(files.message([&] { write_document(files.path("a.smesh"), document); }),
            "a.smesh: cannot write it: a facet of 3 polygons and 1 hole (element 2) has no place in a "
            ".smesh; write a .poly");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
  document.facets.clear();
  write_document(files.path("a.smesh"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.smesh")).substr(64),
            "5 1\n3 1 2 3 1\n4 1 2 3 4 -2\n3 5 6 7 -2\n2 1 5 -2\n6 1 2 3 4 5 6 3\n1\n1 1 2 3\n1\n1 1 1 1 "
            "2.25 -1\n");
  EXPECT_EQ(test::tetgen_text(read_document(files.path("a.smesh"))), test::tetgen_text(document));
}

TEST(TetgenWrite, AFacetHasOneMarker) {
  Document document = boundary();
  document.element_values[0].integers[2] = 8;
  const io::Holds holds = io::plan_poly(document, false)->holds();
  EXPECT_TRUE(holds.facets);
  EXPECT_FALSE(holds.values(document.element_values[0], io::Of::element));
  document.facets[0].polygons = 9;  // more than there are
  EXPECT_FALSE(io::plan_poly(document, false)->holds().facets);
}

// TetGen cuts lines at 2047 bytes.
TEST(TetgenWrite, LongPolygonsOverLines) {
  const test::TestFiles files;
  Document document;
  document.points.assign(1000, {1, 2, 3});
  document.blocks = {{.type = io::polygon, .dim = 2, .nodes_each = 1000, .count = 2, .of_boundary = true}};
  for (Index i = 0; i < 2000; ++i) document.connectivity.push_back(i % 1000);
  document.element_values = {integers("markers", 1, 0, {4, 5})};
  for (const char* name : {"a.poly", "a.smesh"}) {
    write_document(files.path(name), document);
    std::istringstream lines(test::TestFiles::read(files.path(name)));
    for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 2000u);
    EXPECT_EQ(test::tetgen_text(read_document(files.path(name))), test::tetgen_text(document));
  }
}

// Of a mesh that says nothing else, all faces are the boundary to be meshed.
TEST(TetgenWrite, FacesOfAMeshAsFacets) {
  const test::TestFiles files;
  Document document = full();
  document.node_values.clear(), document.area_bounds.clear(), document.length_bounds.clear();
  write_document(files.path("a.smesh"), document);
  const std::string expected =
      "4 3 0 0\n0 0 0 0\n1 0.1 0 0\n2 -0 1 0\n3 0 0 5e-324\n2 1\n3 0 1 2 -7\n3 0 1 3 7\n0\n0\n";
  EXPECT_EQ(test::TestFiles::read(files.path("a.smesh")).substr(0, expected.size()), expected);
  EXPECT_EQ(test::TestFiles::read(files.path("a.edge")), "1 1\n0 2 3 5 0\n");
}

// Where a document has no attributes and markers of its own, TetGen is told the first physical group; and
// what is read back are groups again.
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

  document.element_values = {{.name = "attributes", .reals = {0.5}}};  // which come first
  write_document(files.path("a.node"), document);
  EXPECT_EQ(test::TestFiles::read(files.path("a.ele")), "1 4 1\n1 1 2 3 4 0.5\n");
}

TEST(TetgenWrite, SaysWhichFilesAreLeftOver) {
  const test::TestFiles files;
  Document document = full();
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
  Document document = full();
  document.element_values.clear();
  EXPECT_EQ(files.message([&] { write_document(files.path("a.neigh"), document); }),
            "a.neigh: cannot write it: there is nothing in the mesh to stand in it");
  EXPECT_TRUE(std::filesystem::is_empty(files.path("")));
}

}  // namespace
}  // namespace tetproof
