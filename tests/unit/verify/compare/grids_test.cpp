// SPDX-License-Identifier: GPL-3.0-or-later
// Comparing two grids: renumbered grids are equal, and differences planted into one grid are found, and
// nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "io/error.hpp"
#include "verify/compare_grids.hpp"

namespace tetproof::verify {
namespace {

// A block of n x n x n unit cubes, each cut into six tetrahedra around its diagonal.
NamedGrid block(int n, const Eigen::Vector3d& origin = {0, 0, 0}) {
  NamedGrid grid{"reference.msh", {}, {.first = 1}};
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) grid.mesh.points.push_back(origin + Eigen::Vector3d(i, j, k) / n);
  const int step[] = {1, n + 1, (n + 1) * (n + 1)};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          const int first = i + (n + 1) * (j + (n + 1) * k), second = first + step[axes[0]],
                    third = second + step[axes[1]];
          grid.mesh.tets.push_back({first, second, third, third + step[axes[2]]});
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return grid;
}

// The same grid with other numbers, other orders, and points moved by up to `off`.
NamedGrid renumbered(const NamedGrid& grid, double off = 0) {
  NamedGrid other{"other.msh", grid.mesh, grid.numbering};
  std::mt19937 random(3);
  std::vector<Index> order(grid.mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  std::uniform_real_distribution<double> by(-off / 2, off / 2);
  for (std::size_t i = 0; i < order.size(); ++i)
    other.mesh.points[order[i]] = grid.mesh.points[i] + Eigen::Vector3d(by(random), by(random), by(random));
  for (auto& tet : other.mesh.tets) {
    for (Index& corner : tet) corner = order[corner];
    std::shuffle(tet.begin(), tet.end(), random);
  }
  std::shuffle(other.mesh.tets.begin(), other.mesh.tets.end(), random);
  return other;
}

TEST(CompareGrids, RenumberedGridsAreEqual) {
  const NamedGrid grid = block(6);
  GridComparison result = compare_grids(renumbered(grid), grid);
  EXPECT_TRUE(result.equal());
  EXPECT_EQ(result.largest_distance, 0);
  EXPECT_EQ(result.reference.tets, 6 * 216);
  EXPECT_EQ(result.other.points, 343);
  result = compare_grids(renumbered(grid, 1e-10), grid);
  EXPECT_TRUE(result.equal());
  EXPECT_GT(result.largest_distance, 1e-11);
  EXPECT_LE(result.largest_distance, 1e-10);
  EXPECT_EQ(comparison_text(compare_grids(renumbered(grid), grid)),
            "equal up to numbering: 1296 tetrahedra, 343 points; matched points are at most 0 apart\n");
}

TEST(CompareGrids, TheToleranceIsInDiagonals) {
  const NamedGrid grid = block(3);
  NamedGrid other = grid;
  const double tolerance = 1e-6, length = tolerance * std::sqrt(3.0);
  other.mesh.points[5].x() += 0.99 * length;
  EXPECT_TRUE(compare_grids(other, grid, tolerance).equal());
  other.mesh.points[5].x() += 0.02 * length;
  const GridComparison result = compare_grids(other, grid, tolerance);
  EXPECT_EQ(result.other.points_only, 1);
  EXPECT_EQ(result.reference.points_only, 1);
  EXPECT_EQ(result.other.first_points.at(0).number, 6);
  EXPECT_EQ(result.other.tets_only, result.reference.tets_only);
  EXPECT_GT(result.other.tets_only, 0);
  EXPECT_DOUBLE_EQ(result.tolerance, length);
  other = grid;
  other.mesh.points[5].x() = std::nextafter(other.mesh.points[5].x(), 2);
  EXPECT_FALSE(compare_grids(other, grid, 0).equal());
  EXPECT_TRUE(compare_grids(grid, grid, 0).equal());
  // -0 is 0.
  other = grid;
  other.mesh.points[0] = -other.mesh.points[0];
  EXPECT_TRUE(compare_grids(other, grid, 0).equal());
}

// Points on different sides of a border of hashed cells are matched, also far from the origin.
TEST(CompareGrids, EveryPointFindsItsPartner) {
  for (const double far : {0.0, 1e6, -1e6}) {
    const NamedGrid grid = block(8, Eigen::Vector3d::Constant(far));
    EXPECT_TRUE(compare_grids(renumbered(grid, 1e-7), grid, 1e-7).equal()) << far;
  }
}

TEST(CompareGrids, WhatIsPlantedIsWhatIsFound) {
  const NamedGrid grid = block(3);
  NamedGrid other = grid;
  other.file = "other.msh";
  other.mesh.tets.erase(other.mesh.tets.begin() + 7);
  GridComparison result = compare_grids(other, grid);
  EXPECT_EQ(result.reference.tets_only, 1);
  EXPECT_EQ(result.other.tets_only, 0);
  ASSERT_EQ(result.reference.first_tets.size(), 1u);
  EXPECT_EQ(result.reference.first_tets[0].number, 8);
  EXPECT_EQ(result.reference.first_tets[0].corners[0].number, grid.mesh.tets[7][0] + 1);
  EXPECT_EQ(result.reference.first_tets[0].corners[0].at, grid.mesh.points[grid.mesh.tets[7][0]]);

  other.mesh.points.push_back({5, 5, 5});
  other.mesh.tets.push_back({0, 1, 5, 64});
  result = compare_grids(other, grid);
  EXPECT_EQ(comparison_text(result),
            "the grids differ:\n"
            "only in reference.msh: 1 of 162 tetrahedra, 0 of 64 points\n"
            "  tetrahedron 8: (0.3333333333333333, 0, 0) (0.6666666666666666, 0, 0) (0.6666666666666666, 0, "
            "0.3333333333333333) "
            "(0.6666666666666666, 0.3333333333333333, 0.3333333333333333)\n"
            "only in other.msh: 1 of 162 tetrahedra, 1 of 65 points\n"
            "  tetrahedron 162: (0, 0, 0) (0.3333333333333333, 0, 0) (0.3333333333333333, "
            "0.3333333333333333, 0) (5, 5, 5)\n"
            "  point 65: (5, 5, 5)\n");
  const nlohmann::json json = nlohmann::json::parse(comparison_json(result));
  EXPECT_EQ(json.at("compared"), "grids");
  EXPECT_EQ(json.at("verdict"), "diverges");
  EXPECT_EQ(json.at("other").at("tets_only_here"), 1);
  EXPECT_EQ(json.at("other").at("first_points"),
            nlohmann::json::parse(R"([{"number":65,"point":[5.0,5.0,5.0]}])"));
  EXPECT_EQ(json.at("reference").at("first_tets").at(0).at("number"), 8);
}

TEST(CompareGrids, MultiplicityIsKept) {
  const NamedGrid grid = block(2);
  NamedGrid twice = grid;
  twice.mesh.tets.push_back(
      {twice.mesh.tets[3][2], twice.mesh.tets[3][0], twice.mesh.tets[3][1], twice.mesh.tets[3][3]});
  GridComparison result = compare_grids(twice, grid);
  EXPECT_EQ(result.other.tets_only, 1);
  EXPECT_EQ(result.reference.tets_only, 0);
  EXPECT_TRUE(compare_grids(twice, twice).equal());
  EXPECT_EQ(compare_grids(grid, twice).reference.tets_only, 1);

  NamedGrid doubled = grid;  // one point occurs twice, as at a crack
  doubled.mesh.points.push_back(doubled.mesh.points[4]);
  doubled.mesh.tets[0][1] = doubled.mesh.tets[0][1] == 4 ? 27 : doubled.mesh.tets[0][1];
  result = compare_grids(doubled, grid);
  EXPECT_EQ(result.other.points_only, 1);
  EXPECT_EQ(result.other.first_points.at(0).number, 28);
  EXPECT_EQ(result.other.tets_only, 0);
  result = compare_grids(doubled, doubled);
  EXPECT_TRUE(result.equal());
  EXPECT_EQ(result.shared_places, 1);
}

TEST(CompareGrids, WhatIsNoPointMatchesNothing) {
  const NamedGrid grid = block(1);
  NamedGrid broken = grid;
  broken.numbering.unknown = {77};
  broken.mesh.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  broken.mesh.tets.push_back({0, 1, 2, -1});
  broken.mesh.tets.push_back({0, 1, 2, 100});
  const GridComparison result = compare_grids(broken, broken);
  EXPECT_EQ(result.other.points_only, 1);
  EXPECT_EQ(result.reference.points_only, 1);
  EXPECT_EQ(result.other.tets_only, result.reference.tets_only);
  EXPECT_EQ(result.other.tets_only,
            2 + std::count_if(grid.mesh.tets.begin(), grid.mesh.tets.end(), [](const auto& tet) {
              return std::find(tet.begin(), tet.end(), 3) != tet.end();
            }));
  EXPECT_NE(comparison_text(result).find("(0, 1, 0) 77 (no point)"), std::string::npos)
      << comparison_text(result);
  EXPECT_FALSE(nlohmann::json::parse(comparison_json(result)).empty());
  const NamedGrid nothing{"nothing", {}, {}};
  EXPECT_EQ(compare_grids(nothing, grid).reference.tets_only, 6);
  EXPECT_EQ(compare_grids(grid, nothing).other.tets_only, 6);
}

TEST(CompareGrids, ACrowdWithinTheToleranceIsRefused) {
  NamedGrid grid = block(1);
  for (int i = 0; i < 2000; ++i) grid.mesh.points.push_back({0.5, 0.5, 0.5 + i * 1e-9});
  EXPECT_TRUE(compare_grids(grid, grid, 1e-12).equal());
  EXPECT_THROW(compare_grids(grid, grid, 1e-3), InputError);
}

// A million tetrahedra take seconds. This test has 750,000, and a time limit that only a quadratic search
// would exceed.
TEST(CompareGrids, LargeGridsTakeSeconds) {
  const NamedGrid grid = block(50), other = renumbered(grid, 1e-10);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(compare_grids(other, grid).equal());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 30);
}

}  // namespace
}  // namespace tetproof::verify
