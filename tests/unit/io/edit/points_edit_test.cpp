// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are merged, left out, numbered, scaled and moved.
#include "edited.hpp"

namespace tetproof::test {
namespace {

TEST(Prune, KeepsNumbersAndValues) {
  Document document = two_tets();
  EXPECT_EQ(said(io::prune(document)), "1 unused point left out");
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 2 9 bottom\ne1 g5: 10 20\ne2 g9: 10 20 30\ne4 g1: 10 20 30 40\n"
            "e4 g2: 20 30 40 50\nnode t x1: 1 2 3 4 5\nelement q x1: 70 80 90 from 1\n");
  EXPECT_EQ(said(io::prune(document)), "0 unused points left out");
}

TEST(Prune, EntitiesParametersAndPairs) {
  Document document = document_of(
      TetMesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 8, 8}, {0, 0, 1}}, {{1, 2, 3, 5}}});
  document.node_blocks = {{.dim = 2, .entity = 4, .first = 0, .count = 3, .parameters_each = 2},
                          {.dim = 3, .entity = 5, .first = 4, .count = 1},
                          {.dim = 3, .entity = 6, .first = 5, .count = 1}};
  document.parameters = {0, 1, 2, 3, 4, 5};
  document.periodic = {{.dim = 2, .entity = 4, .master = 5, .affine = {}, .nodes = {{1, 2}, {0, 2}}}};
  document.length_bounds = {{.nodes = {1, 5}, .length = 2}};
  EXPECT_EQ(said(io::prune(document)),
            "2 unused points left out | pairs of periodic nodes 1 (a node of the first is left out)");
  EXPECT_EQ(io::misplaced(document), nullptr);
  ASSERT_EQ(document.node_blocks.size(), 2u);
  EXPECT_EQ(document.node_blocks[0].count, 2u);
  EXPECT_EQ(document.node_blocks[1].entity, 6);
  EXPECT_EQ(document.node_blocks[1].first, 3u);
  EXPECT_EQ(document.parameters, (std::vector<double>{2, 3, 4, 5}));
  EXPECT_EQ(document.periodic[0].nodes, (std::vector<std::array<Index, 2>>{{0, 1}}));
  EXPECT_EQ(document.length_bounds[0].nodes, (std::array<Index, 2>{0, 3}));
}

TEST(Renumber, FromOneOn) {
  Document document = two_tets();
  EXPECT_EQ(said(io::renumber(document)), "6 nodes and 4 elements numbered anew, from 1 on");
  EXPECT_EQ(document.node_tag(5), 6);
  EXPECT_EQ(document.element_tag(3), 4);
  document.sections = {{.name = "Mine", .body = "1\n", .format = "msh22"}};
  EXPECT_EQ(said(io::renumber(document)), "0 nodes and 0 elements numbered anew, from 1 on");
  document.first_node = 7;
  EXPECT_EQ(said(io::renumber(document)),
            "6 nodes and 0 elements numbered anew, from 1 on | sections 1 ($Mine may name numbers that are "
            "no longer "
            "the same)");
}

// Node 4 does not exist, before and after; 10 was the largest number of all.
TEST(Renumber, WhatNamesNothingGoesOnNamingNothing) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 0 1 0\n10 0 0 1\n", "1 4 2 0 1 1 2 3 10\n2 4 2 0 1 1 2 3 4\n"));
  EXPECT_EQ(said(io::renumber(document)),
            "1 node and 0 elements numbered anew, from 1 on; 1 number that names nothing moved behind all "
            "others");
  EXPECT_EQ(left_of(document), "e4: 1 2 3 4\ne4: 1 2 3 5\n");
}

// Data of an element that does not exist stays so, also where new elements are numbered; no number is beyond
// the largest.
TEST(Renumber, NumbersOfElementsThatDoNotExist) {
  Document document = document_of_text(
      "a.msh", msh22("1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n", "9223372036854775807 3 2 0 1 1 2 3 4\n") +
                   "$ElementData\n1\n\"q\"\n1\n0\n3\n0\n1\n1\n1 70\n$EndElementData\n");
  ASSERT_EQ(document.unknown, (std::vector<std::int64_t>{1}));
  io::triangulate(document);
  EXPECT_EQ(document.element_tags, (std::vector<std::int64_t>{9223372036854775807, 1}));
  EXPECT_EQ(document.unknown, (std::vector<std::int64_t>{5}));  // behind the nodes, too
}

// Two triangles with points of their own, of which two pairs meet; -0 is 0, NaN is nothing.
const char* const two_triangles =
    "OFF 8 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 -0\n1 1 0\n0 1 1e-9\nnan 0 0\nnan 0 0\n3 0 1 2\n3 3 4 5\n";

TEST(MergePoints, Exactly) {
  Document document = document_of_text("a.off", two_triangles);
  EXPECT_EQ(said(io::merge_points(document)), "1 point merged into others at the same place");
  EXPECT_EQ(left_of(document), "e2: 0 1 2\ne2: 1 3 4\n");
}

TEST(MergePoints, WithinATolerance) {
  Document document = document_of_text("a.off", two_triangles);
  EXPECT_EQ(said(io::merge_points(document, 1e-9)), "2 points merged into others within 1e-09");
  EXPECT_EQ(left_of(document), "e2: 0 1 2\ne2: 1 3 2\n");
  EXPECT_EQ(document.points[2][2], 0);
}

// A chain of points: each is near the next, but only those near a point that stays are merged into it.
TEST(MergePoints, ChainsDoNotCollapse) {
  Document document;
  for (int i = 0; i < 9; ++i) document.points.emplace_back(0.75 * i - 3, 0, 0);
  EXPECT_EQ(said(io::merge_points(document, 1.0)), "4 points merged into others within 1");
  EXPECT_EQ(document.points.size(), 5u);
  EXPECT_EQ(document.points[1][0], -1.5);
}

TEST(MergePoints, CollapsedElementsAndDifferingValues) {
  Document document = two_tets();
  document.points[4] = document.points[1];
  document.node_values[0].integers.clear();
  EXPECT_EQ(said(io::merge_points(document)),
            "1 point merged into others at the same place; 1 element has a node twice now | values of merged "
            "points 1 "
            "(they differ from those of the point that stays)");
  EXPECT_EQ(left_of(document),
            "group 3 1 steel\ngroup 2 9 bottom\ne1 g5: 10 20\ne2 g9: 10 20 30\ne4 g1: 10 20 30 40\n"
            "e4 g2: 20 30 40 20\nnode t x1: 1 2 3 4 6\nelement q x1: 70 80 90 from 1\n");
}

// Coordinates that are more tolerances than a number can say: equal ones are near, whatever the others are.
TEST(MergePoints, WithinATinyTolerance) {
  Document document;
  for (int i = 0; i < 3000; ++i) document.points.emplace_back(1 + i, 2, -3);
  document.points.emplace_back(1, 2, -3);
  document.points.emplace_back(1, 0, 0);
  document.points.emplace_back(1, 0, 5e-308);
  document.points.emplace_back(1, 0, 3e-307);
  EXPECT_EQ(said(io::merge_points(document, 1e-307)), "2 points merged into others within 1e-307");
  EXPECT_EQ(document.points.size(), 3002u);
}

// Nodes 2 and 3 are on curve 7 and node 4 on curve 8, with parameters.
TEST(MergePoints, ListsEntitiesAndParameters) {
  Document document;
  for (int i = 0; i < 4; ++i) document.points.emplace_back(0, 0, 0);
  document.node_blocks = {{.dim = 1, .entity = 7, .first = 1, .count = 2, .parameters_each = 1},
                          {.dim = 1, .entity = 8, .first = 3, .count = 1, .parameters_each = 1}};
  document.parameters = {0.5, 0.5, 0.5};
  document.points[0] = {1, 0, 0};
  EXPECT_EQ(
      said(io::merge_points(document)),
      "2 points merged into others at the same place | entities and parameters of merged points 1 (node "
      "4, of entity 8 of dimension 1)");
  ASSERT_EQ(document.node_blocks.size(), 1u);
  EXPECT_EQ(document.parameters, (std::vector<double>{0.5}));
}

// A reader's numbers count up again once a point is gone: sections may mean others.
TEST(Prune, SectionsOfCountedNodes) {
  Document document = document_of_text("a.off", "OFF 4 1 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n");
  document.sections = {{.name = "Corners", .body = "1\n2\n", .format = "medit"}};
  EXPECT_EQ(said(io::prune(document)),
            "1 unused point left out | sections 1 ($Corners may name numbers that are no longer the same)");
  EXPECT_TRUE(document.sections.empty());
}

// By brute force: the rule itself, on points of a lattice with noise.
TEST(MergePoints, FollowsItsRule) {
  std::uint64_t seed = 7;
  const auto random = [&] {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed >> 33) / 2147483648.0;
  };
  for (const double tolerance : {0.05, 0.3, 1.0}) {
    Document document;
    for (int i = 0; i < 500; ++i)
      document.points.emplace_back(std::floor(random() * 4) + 0.2 * random(), random() - 0.5, random());
    std::vector<Eigen::Vector3d> stay;
    for (const Eigen::Vector3d& point : document.points)
      if (std::none_of(stay.begin(), stay.end(),
                       [&](const auto& one) { return (one - point).stableNorm() <= tolerance; }))
        stay.push_back(point);
    io::merge_points(document, tolerance);
    EXPECT_EQ(document.points, stay) << tolerance;
  }
}

TEST(Scale, LengthsAreasAndVolumes) {
  Document document = two_tets();
  document.holes = {{1, 2, 3}};
  document.regions = {{.point = {1, 1, 1}, .attribute = 5, .max_volume = 2}, {.point = {0, 0, 0}}};
  document.area_bounds = {{1, 2}};
  document.length_bounds = {{{0, 1}, 3}};
  document.entities = {{.dim = 3, .tag = 3, .box = {0, 0, 0, 1, 1, 1}}};
  document.periodic = {{.dim = 0,
                        .entity = 1,
                        .master = 2,
                        .affine = {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                        .nodes = {}}};
  EXPECT_EQ(said(io::scale(document, 10)), "6 points scaled by 10");
  EXPECT_EQ(document.points[5], Eigen::Vector3d(90, 90, 90));
  EXPECT_EQ(document.holes[0], Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(document.regions[0].max_volume, 2000);
  EXPECT_EQ(document.regions[1].max_volume, -1);
  EXPECT_EQ(document.regions[0].attribute, 5);
  EXPECT_EQ(document.area_bounds[0].area, 200);
  EXPECT_EQ(document.length_bounds[0].length, 30);
  EXPECT_EQ(document.entities[0].box[5], 10);
  EXPECT_EQ(document.periodic[0].affine[3], 50);
  EXPECT_EQ(document.node_values[0].reals[0], 1);
}

// TetGen's sizes and bounds grow also after a join, and what others call by the same name does not.
TEST(Scale, SizesOfAJoin) {
  const auto made = [](const char* format, double size) {
    Document document;
    document.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    document.format = format;
    document.blocks = {{.count = 1}};
    document.connectivity = {0, 1, 2, 3};
    document.node_values.resize(1);
    document.node_values[0].name = "sizes";
    document.node_values[0].reals = std::vector<double>(4, size);
    document.element_values.resize(1);
    document.element_values[0].name = "volume bounds";
    document.element_values[0].reals = {size};
    return document;
  };
  Document document = made("tetgen", 0.5);
  io::join(document, made("vtu", 7));
  EXPECT_EQ(document.format, "");
  io::scale(document, 2);
  ASSERT_EQ(document.node_values.size(), 2u);
  EXPECT_EQ(document.node_values[0].reals, std::vector<double>(4, 1));
  EXPECT_EQ(document.element_values[0].reals, std::vector<double>{4});
  EXPECT_EQ(document.node_values[1].reals, std::vector<double>(4, 7));
  EXPECT_EQ(document.element_values[1].reals, std::vector<double>{7});
}

TEST(Translate, MovesEverything) {
  Document document = two_tets();
  document.holes = {{1, 2, 3}};
  // x -> -x + 5, about the plane x = 2.5; moved by 1 about x = 3.5: x -> -x + 7
  document.periodic = {{.dim = 0,
                        .entity = 1,
                        .master = 2,
                        .affine = {-1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                        .nodes = {}}};
  EXPECT_EQ(said(io::translate(document, {1, -2, 0.5})), "6 points moved by (1, -2, 0.5)");
  EXPECT_EQ(document.points[0], Eigen::Vector3d(1, -2, 0.5));
  EXPECT_EQ(document.holes[0], Eigen::Vector3d(2, 0, 3.5));
  EXPECT_EQ(document.periodic[0].affine[3], 7);
  EXPECT_EQ(document.periodic[0].affine[7], 0);
}

// What a .msh gives instead of a map is nobody's place or length.
TEST(Placing, NumbersThatAreNoMapStay) {
  for (const bool moved : {false, true}) {
    Document document = two_tets();
    document.periodic = {{.dim = 2, .entity = 7, .master = 8, .affine = {1, 2, 3, 4}, .nodes = {}}};
    const io::Edit edit = moved ? io::translate(document, {1, 0, 0}) : io::scale(document, 10);
    EXPECT_EQ(document.periodic[0].affine, (std::vector<double>{1, 2, 3, 4}));
    ASSERT_EQ(edit.lost.size(), 1u);
    EXPECT_EQ(edit.lost[0].item, "affine transformations without 16 numbers, left as they were");
    EXPECT_EQ(edit.lost[0].count, 1);
    EXPECT_EQ(edit.lost[0].example, "entity 7 of dimension 2: 4 numbers");
  }
}

// A box of no points, as Gmsh writes it, stays inside the range of numbers.
TEST(Scale, BoxesWithoutPoints) {
  constexpr double most = std::numeric_limits<double>::max();
  Document document = two_tets();
  document.entities = {{.dim = 3, .tag = 3, .box = {most, most, most, -most, -most, -most}}};
  io::scale(document, 10);
  EXPECT_EQ(document.entities[0].box, (std::array<double, 6>{most, most, most, -most, -most, -most}));
}

// Behind 2^53 every second whole number is none: 1 falls on 0, 2 does not.
TEST(Translate, ListsWhatRoundingMoves) {
  Document document;
  document.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  document.first_node = 10;
  EXPECT_EQ(
      said(io::translate(document, {9007199254740992, 0, 0})),
      "3 points moved by (9007199254740992, 0, 0) | points that rounding puts beside their place 1 (node "
      "11 by 1)");
  document.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(said(io::translate(document, {5e6, 0.1, 0})), "3 points moved by (5000000, 0.1, 0)");
  document.points = {{0.7, 0, 0}};
  EXPECT_EQ(said(io::translate(document, {0.1, 0, 0})), "1 point moved by (0.1, 0, 0)");
}

TEST(Place, RefusesWhatLeavesTheRange) {
  const TestFiles files;
  const auto message = [&](double factor, const auto& change) {
    Document document = two_tets();
    change(document);
    return files.message([&] { io::scale(document, factor); });
  };
  EXPECT_EQ(message(1e-200,
                    [](Document& d) {
                      d.points[1] = {1e-200, 0, 0};
                    }),
            "a.msh: node 20 would leave the range of numbers");
  EXPECT_EQ(message(1e10,
                    [](Document& d) {
                      d.holes = {{0, 0, 0}, {0, 1e300, 0}};
                    }),
            "a.msh: hole 2 would leave the range of numbers");
  EXPECT_EQ(message(1e10,
                    [](Document& d) {
                      d.regions = {{.point = {0, 1e300, 0}}};
                    }),
            "a.msh: region 1 would leave the range of numbers");
  EXPECT_EQ(message(1e100, [](Document& d) { d.regions = {{.max_volume = 1e100}}; }),
            "a.msh: the bound of a region's volume would leave the range of numbers");
  EXPECT_EQ(message(1e-100,
                    [](Document& d) {
                      d.area_bounds = {{1, 1e-200}};
                    }),
            "a.msh: the bound of an area would leave the range of numbers");
  Document document = two_tets();  // digits that are gone already are no reason
  document.points[0] = {1e-310, 1, 1};
  io::scale(document, 0.5);
  EXPECT_EQ(document.points[0], Eigen::Vector3d(5e-311, 0.5, 0.5));
  document = two_tets();  // and a sum may be 0
  io::translate(document, {-1, 0, 0});
  EXPECT_EQ(document.points[1], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(files.message([&] {
    document.holes = {{1.7e308, 0, 0}};
    io::translate(document, {1.7e308, 0, 0});
  }),
            "a.msh: hole 1 would leave the range of numbers");
}

TEST(Place, Refuses) {
  const TestFiles files;
  Document document = two_tets();
  EXPECT_EQ(files.message([&] { io::scale(document, -1); }), "expected a factor above 0, found -1");
  EXPECT_EQ(files.message([&] { io::scale(document, 1e308); }),
            "a.msh: node 60 would leave the range of numbers");
  EXPECT_EQ(files.message([&] { io::merge_points(document, -1); }),
            "expected a tolerance of at least 0, found -1");
}

}  // namespace
}  // namespace tetproof::test
