// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of round trips is judged: it sees every change that was made to a document, and no other.
#include "documents_compare.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <initializer_list>
#include <string>

#include "random_document.hpp"
#include "tests/support/document_in_order.hpp"

namespace tetproof::test {
namespace {

Recipe with_everything(std::uint64_t seed) {
  Recipe recipe{.seed = seed, .nodes = 13};
  recipe.with.fill(true);
  for (const Feature off :
       {Feature::no_tetrahedra, Feature::all_types, Feature::repeated, Feature::from_zero})
    recipe.with[static_cast<std::size_t>(off)] = false;
  return recipe;
}

std::string text_of(const std::vector<Difference>& differences) {
  std::string text;
  for (const Difference& d : differences) text += d.item + " " + std::to_string(d.count) + "; ";
  return text;
}

TEST(DocumentsCompare, ADocumentIsLikeItself) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Document document = random_document(with_everything(seed));
    ASSERT_NO_THROW(check_in_order(document)) << seed;
    ASSERT_EQ(text_of(differences(document, document)), "") << seed;
  }
}

// Divided blocks, reordered tag sets and consecutive numbers make no difference.
TEST(DocumentsCompare, SeesNoDifferenceInHowItIsKept) {
  const Document document = random_document(with_everything(1));
  Document other = document;
  std::swap(other.tag_sets[1], other.tag_sets[2]);
  const auto renamed = [](std::int32_t& set) { set = set == 1 ? 2 : set == 2 ? 1 : set; };
  for (ElementBlock& block : other.blocks) renamed(block.groups), renamed(block.partitions);
  for (Entity& entity : other.entities) renamed(entity.groups), renamed(entity.partitions);
  for (std::size_t b = 0; b < other.blocks.size(); ++b) {
    if (other.blocks[b].count < 2) continue;
    ElementBlock rest = other.blocks[b];
    other.blocks[b].count = 1;
    rest.first += 1, rest.count -= 1, rest.nodes += static_cast<std::size_t>(rest.nodes_each);
    other.blocks.insert(other.blocks.begin() + static_cast<std::ptrdiff_t>(b) + 1, rest);
  }
  ASSERT_NO_THROW(check_in_order(other));
  EXPECT_GT(other.blocks.size(), document.blocks.size());
  EXPECT_EQ(text_of(differences(document, other)), "");
}

TEST(DocumentsCompare, SeesWhatWasDone) {
  struct Deed {
    const char* what;
    std::function<void(Document&)> work;
  };
  const Deed deeds[]{
      {"changed coordinates 1; ",
       [](Document& d) { d.points[3].y() = std::nextafter(d.points[3].y() == 0, 7); }},
      {"numbers of nodes 13; ", [](Document& d) { d.node_tags[5] += 1; }},
      {"title 1; ", [](Document& d) { d.title.clear(); }},
      {"holes 1; ", [](Document& d) { d.holes.pop_back(); }},
      {"bounds of areas 1; gained bounds of areas 1; ", [](Document& d) { d.area_bounds[0].area = 3; }},
      {"periodic links 1; ", [](Document& d) { d.periodic.pop_back(); }},
      {"gained holes 1; ", [](Document& d) { d.holes.emplace_back(1, 2, 3); }},
  };
  const Document document = random_document(with_everything(7));
  for (const Deed& deed : deeds) {
    Document other = document;
    deed.work(other);
    EXPECT_EQ(text_of(differences(document, other)), deed.what);
  }
}

// A remnant of a lost part is not a gain. Anything else is.
TEST(DocumentsCompare, KnowsRemnants) {
  Document was;
  was.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  was.title = "a long title";
  was.node_values = {{.name = "v w", .integers = {1, 2}, .labels = {"x", "y", "z"}, .at = {2, 0}}};
  was.tables = {{.name = "t",
                 .rows = 1,
                 .columns = {{.name = "r", .type = "double", .reals = {1}},
                             {.name = "s", .type = "String", .texts = {"x"}}}}};
  Document is = was;
  is.title = "a long";
  is.node_values = {{.name = "v_w #2", .integers = {2, 0, 1}}};
  is.tables = {{.name = "t.r", .rows = 1, .columns = {{.name = "t.r", .type = "double", .reals = {1}}}}};
  EXPECT_EQ(text_of(differences(was, is)),
            "names of values of nodes 1; labels of values of nodes 1; gaps in values of nodes 1; "
            "table \"t\" 1; title 1; ");
  is.title = "longer";
  is.node_values[0].integers = {2, 3, 1};  // the second node had no value
  is.tables[0].columns[0].reals[0] = 2;
  EXPECT_EQ(text_of(differences(was, is)),
            "values \"v w\" of nodes 2; gained values \"v_w #2\" of nodes 3; "
            "table \"t\" 1; title 1; gained table \"t.r\" 1; gained title 1; ");
  is.node_values = {{.name = "v w", .integers = {2, 0, 1}}, {.name = "v w #2", .integers = {2, 0, 1}}};
  is.tables.clear(), is.title.clear();
  EXPECT_EQ(text_of(differences(was, is)),
            "labels of values of nodes 1; gaps in values of nodes 1; gained values \"v w #2\" of nodes 3; "
            "table \"t\" 1; title 1; ");
}

// Two tetrahedra and a line.
Document small() {
  Document d;
  for (int i = 0; i < 5; ++i) d.points.emplace_back(i, i * i, 0.1);
  d.tag_sets = {{}, {4, 5}};
  d.blocks = {{.type = 4, .entity = 1, .groups = 1, .nodes_each = 4, .count = 2},
              {.type = 1, .dim = 1, .entity = 9, .nodes_each = 2, .count = 1, .first = 2, .nodes = 8}};
  d.connectivity = {0, 1, 2, 3, 4, 3, 2, 1, 0, -1};
  d.unknown = {70};
  d.element_values = {{.name = "v", .reals = {1, 2, 3}}};
  return d;
}

TEST(DocumentsCompare, CountsElements) {
  Document d = small();
  d.blocks.pop_back(), d.connectivity.resize(8), d.element_values[0].reals.pop_back();
  EXPECT_EQ(text_of(differences(small(), d)), "lines of 2 nodes (type 1) 1; ");
  d = small();
  std::swap(d.connectivity[0], d.connectivity[4]);
  EXPECT_EQ(text_of(differences(small(), d)),
            "tetrahedra of 4 nodes (type 4) 2; gained elements 2; "
            "values \"v\" of elements 3; "
            "gained values \"v\" of elements 3; ");
  d = small();
  d.tag_sets[1] = {4};
  d.blocks[1].entity = 0;
  EXPECT_EQ(text_of(differences(small(), d)),
            "physical groups beyond an element's first 2; entities of elements 1; ");
  d = small();
  d.unknown = {71};
  EXPECT_EQ(text_of(differences(small(), d)), "numbers of nodes that do not exist 1; ");
  d = small();
  d.element_values[0].reals = {2, 1, 3};
  d.element_values[0].at = {1, 0, 2};
  EXPECT_EQ(text_of(differences(small(), d)), "");
  d.element_values[0].reals[1] = -1;
  EXPECT_EQ(text_of(differences(small(), d)),
            "values \"v\" of elements 3; gained values \"v\" of elements 3; ");
}

// Two second-order triangles, of which the first one names a mid-edge node that does not exist; and a
// quadrangle that names one corner twice.
Document alike() {
  Document d;
  for (int i = 0; i < 4; ++i) d.points.emplace_back(i, i * i, 0.1);
  d.tag_sets = {{}};
  d.unknown = {70};
  d.blocks = {{.type = 9, .dim = 2, .nodes_each = 6, .count = 2},
              {.type = 3, .dim = 2, .nodes_each = 4, .count = 1, .first = 2, .nodes = 12}};
  d.connectivity = {0, 1, 2, -1, 3, 3, 0, 1, 2, 3, 3, 3, 0, 1, 2, 1};
  return d;
}

Document triangles(std::initializer_list<std::array<Index, 3>> all) {
  Document d = alike();
  d.unknown.clear();
  d.connectivity.clear();
  for (const auto& nodes : all) d.connectivity.insert(d.connectivity.end(), nodes.begin(), nodes.end());
  d.blocks = {{.type = 2, .dim = 2, .nodes_each = 3, .count = all.size()}};
  return d;
}

TEST(DocumentsCompare, PairsElementsThatBecameAlike) {
  const std::string quadrangle = "quadrangles of 4 nodes (type 3) 1; ";
  EXPECT_EQ(text_of(differences(alike(), triangles({{0, 1, 2}, {0, 1, 2}}))),
            "nodes between the corners of triangles of 6 nodes (type 9) 2; " + quadrangle);
  EXPECT_EQ(text_of(differences(alike(), triangles({{0, 1, 2}}),
                                Holding::elements_of_nodes)),  // the second triangle is the first one now
            "elements that name nodes which do not exist 1; "
            "nodes between the corners of triangles of 6 nodes (type 9) 1; " +
                quadrangle + "numbers of elements 1; ");
}

TEST(DocumentsCompare, KnowsWhatWasCut) {
  const std::string missing =
      "elements that name nodes which do not exist 1; "
      "nodes between the corners of triangles of 6 nodes (type 9) 1; "
      "quadrangles of 4 nodes (type 3) ";
  EXPECT_EQ(text_of(differences(alike(), triangles({{0, 1, 2}, {0, 1, 2}, {0, 2, 1}}), Holding::triangles)),
            missing + "cut into triangles 1; numbers of elements 1; ");
  EXPECT_EQ(text_of(differences(alike(), triangles({{0, 1, 2}, {0, 2, 1}}), Holding::triangles)),
            missing + "1; gained elements 1; numbers of elements 1; ");
}

// A plate with a hole, and a triangle between a facet's triangles.
TEST(DocumentsCompare, KnowsFacetsThatWereCut) {
  Document plate;
  for (int i = 0; i < 9; ++i) plate.points.emplace_back(i / 16.0, 0, 0);
  constexpr double corners[][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {9, 9}};
  for (std::size_t i = 0; i < 9; ++i) plate.points[i] += Eigen::Vector3d(corners[i][0], corners[i][1], 0);
  plate.blocks = {{.type = 3, .dim = 2, .nodes_each = 4, .count = 2, .of_boundary = true},
                  {.type = 2, .dim = 2, .nodes_each = 3, .count = 1, .first = 2, .nodes = 8}};
  plate.connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 8};
  plate.facets = {{.first = 0, .polygons = 2, .holes = {{2, 2, 0}}}};
  Document stl = plate;
  stl.facets.clear();
  stl.blocks = {{.type = 2, .dim = 2, .nodes_each = 3, .count = 9}};
  stl.connectivity = {0, 1, 4, 1, 5, 4, 1, 2, 5, 2, 6, 5, 2, 3, 6, 3, 7, 6, 3, 0, 7, 0, 4, 7, 0, 1, 8};
  const std::string facets =
      "that faces are TetGen's facets, which have no direction and may lie inside of the body ";
  const std::string cut = "quadrangles of 4 nodes (type 3) cut into triangles 2; numbers of elements 1; " +
                          facets + "2; facets of several polygons or with holes 1; ";
  EXPECT_EQ(text_of(differences(plate, stl, Holding::triangles)), cut);
  stl.connectivity[3] = 8;  // a node that the facet has not
  EXPECT_NE(text_of(differences(plate, stl, Holding::triangles)), cut);
  stl.connectivity[3] = 2, stl.connectivity[5] = 4;  // the triangle 2 5 4 runs over another one
  EXPECT_NE(text_of(differences(plate, stl, Holding::triangles)), cut);
}

}  // namespace
}  // namespace tetproof::test
