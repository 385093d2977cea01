// SPDX-License-Identifier: GPL-3.0-or-later
// Step (iv) on lattices with random indicators and cuts, whether or not a surface could give them: neighbours
// match, tetrahedra are positive, and numbers follow reading D3.
#include "reference/engine/first_grid/extract.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <random>
#include <set>

#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

using exact_mesh::Rational;

Lattice unit_lattice(std::array<int, 3> cells) {
  Lattice lattice{cells, {}, 1};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= cells[axis]; ++i) lattice.planes[axis].push_back(i);
  return lattice;
}

struct Draw {
  bool zeros = false;          // settled vertices on the surface
  bool zeros_changed = false;  // vertices that were 0 and that Table 3 changed (reading D7)
};

// Any signs. Each edge between -1 and +1 has a cut at a random multiple of 1/64, so that arithmetic with cuts
// is exact.
Indicators random_indicators(const Lattice& lattice, std::mt19937_64& random, Draw draw) {
  Indicators indicators;
  for (Vertex v = 0; v < lattice.vertices(); ++v) {
    const auto kind = random() % 8;
    std::int8_t sign = random() % 2 ? 1 : -1, initial = sign;
    if (draw.zeros && kind == 0) sign = initial = 0;
    if (draw.zeros_changed && kind >= 5) initial = 0;
    indicators.initial.push_back(initial);
    indicators.sign.push_back(sign);
  }
  Cuts& cuts = indicators.cuts;
  for (Vertex low = 0; low < lattice.vertices(); ++low) {
    cuts.directions.push_back(0);
    cuts.first.push_back(static_cast<std::uint32_t>(cuts.points.size()));
    const auto at = lattice.position(low);
    for (int direction = 1; direction < 8; ++direction) {
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
        inside = inside && at[axis] + (direction >> axis & 1) <= lattice.cells[axis];
      if (!inside) continue;
      const Vertex high = low + lattice.offset(direction);
      if (indicators.sign[low] * indicators.sign[high] >= 0) continue;
      const Vertex exterior = indicators.sign[low] < 0 ? low : high, interior = low + high - exterior;
      if (indicators.initial[exterior] == 0 || indicators.initial[interior] == 0) continue;
      const double t = static_cast<double>(1 + random() % 63) / 64;
      cuts.directions.back() |= static_cast<std::uint8_t>(1 << direction);
      cuts.points.push_back(lattice.point(low) + t * (lattice.point(high) - lattice.point(low)));
      cuts.edges.push_back(Edge{low} * 8 + direction);
    }
  }
  return indicators;
}

Indicators flipped(Indicators indicators) {
  for (auto* signs : {&indicators.initial, &indicators.sign})
    for (std::int8_t& s : *signs) s = static_cast<std::int8_t>(-s);
  return indicators;
}

Grid extract_all(const Lattice& lattice, const Indicators& indicators, Diagonals diagonals,
                 bool keep_case_5 = true) {
  return extract(lattice, indicators, {}, diagonals, [=](const Eigen::Vector3d&) { return keep_case_5; });
}

// Whether a face lies on the box. A boundary face must lie on the box or on the surface.
bool on_box(const Lattice& lattice, const TetMesh& mesh, const std::array<Index, 3>& face) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, static_cast<double>(lattice.cells[axis])})
      if (std::all_of(face.begin(), face.end(), [&](Index p) { return mesh.points[p][axis] == side; }))
        return true;
  return false;
}

class RandomIndicators : public testing::TestWithParam<std::tuple<Diagonals, bool, bool>> {};

TEST_P(RandomIndicators, PositiveConformingBoundaryOnBoxOrSurface) {
  const auto [diagonals, zeros, changed] = GetParam();
  std::array<std::int64_t, tables::table2.size()> rows{};
  std::int64_t collapsed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const Lattice lattice = unit_lattice({2, 3, 2});
    const Indicators indicators = random_indicators(lattice, random, {zeros, changed});
    const Grid grid = extract_all(lattice, indicators, diagonals);
    std::vector<std::array<Index, 3>> boundary;
    ASSERT_EQ(exact_mesh::fault(grid.mesh, &boundary), "") << "seed " << seed;
    for (const auto& face : boundary)
      EXPECT_TRUE(on_box(lattice, grid.mesh, face) ||
                  std::all_of(face.begin(), face.end(), [&](Index p) { return grid.on_surface[p]; }))
          << "seed " << seed;
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r] += grid.rows[r];
    collapsed += grid.collapsed;
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& row = tables::table2[r];
    const bool has_zero = std::count(row.indicators.begin(), row.indicators.end(), 0) > 0;
    const bool by_lowest = row.name == "10d" || row.name == "11b" || row.name == "12f";
    const bool one_of_many = row.name.size() > 2 && row.name != "E8";
    const bool possible =
        (!has_zero || zeros) && (diagonals == Diagonals::shortest || !one_of_many || by_lowest);
    EXPECT_EQ(rows[r] > 0, possible) << row.name;
  }
  EXPECT_EQ(collapsed > 0, changed);
}

INSTANTIATE_TEST_SUITE_P(All, RandomIndicators,
                         testing::Combine(testing::Values(Diagonals::lowest, Diagonals::shortest),
                                          testing::Bool(), testing::Bool()));

TEST(Extract, InsideAndOutsideTogetherAreTheBox) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const Lattice lattice = unit_lattice({3, 2, 2});
    const Indicators indicators = random_indicators(lattice, random, {.zeros = true});
    const Grid inside = extract_all(lattice, indicators, Diagonals::lowest, true);
    const Grid outside = extract_all(lattice, flipped(indicators), Diagonals::lowest, false);
    // Joins both into one mesh. Points are the same if they were made from the same vertex, edge or
    // tetrahedron.
    TetMesh both = inside.mesh;
    std::map<std::pair<Origin, std::int64_t>, Index> known;
    for (std::size_t p = 0; p < inside.mesh.points.size(); ++p)
      known[{inside.origins[p], inside.sources[p]}] = static_cast<Index>(p);
    std::vector<Index> joined;
    for (std::size_t p = 0; p < outside.mesh.points.size(); ++p) {
      const auto [at, isnew] =
          known.try_emplace({outside.origins[p], outside.sources[p]}, static_cast<Index>(both.points.size()));
      if (isnew) both.points.push_back(outside.mesh.points[p]);
      ASSERT_EQ(both.points[at->second], outside.mesh.points[p]);
      joined.push_back(at->second);
    }
    for (auto tet : outside.mesh.tets) {
      for (Index& p : tet) p = joined[p];
      both.tets.push_back(tet);
    }
    std::vector<std::array<Index, 3>> boundary;
    ASSERT_EQ(exact_mesh::fault(both, &boundary), "") << "seed " << seed;
    EXPECT_EQ(exact_mesh::volume6(both), 6 * 3 * 2 * 2) << "seed " << seed;
    for (const auto& face : boundary) EXPECT_TRUE(on_box(lattice, both, face)) << "seed " << seed;
  }
}

// One cell whose vertex 7 is inside, by hand: each lattice tetrahedron gives one tetrahedron of case 6.
TEST(Extract, OneInteriorCornerByHand) {
  const Lattice lattice = unit_lattice({1, 1, 1});
  Indicators indicators;
  indicators.sign = {-1, -1, -1, -1, -1, -1, -1, 1};
  indicators.initial = indicators.sign;
  // The edges to vertex 7 come from 0 (direction 7), 1 (6), 2 (5), 3 (4), 4 (3), 5 (2) and 6 (1). Each is cut
  // at its midpoint.
  indicators.cuts.directions = {1 << 7, 1 << 6, 1 << 5, 1 << 4, 1 << 3, 1 << 2, 1 << 1, 0};
  for (Vertex v = 0; v < 8; ++v) {
    indicators.cuts.first.push_back(static_cast<std::uint32_t>(v));
    if (v < 7) {
      indicators.cuts.points.push_back(0.5 * (lattice.point(v) + Eigen::Vector3d(1, 1, 1)));
      indicators.cuts.edges.push_back(Edge{v} * 8 + (7 ^ v));
    }
  }
  const Grid grid = extract_all(lattice, indicators, Diagonals::lowest);
  // Point 0 is vertex 7. Point 1 + v is the cut on the edge from v. Row 6 is (v1, p12, p13, p14) with v1 = 7
  // and v2 < v3 < v4.
  const std::vector<std::array<Index, 4>> expected{{0, 1, 2, 4}, {0, 1, 6, 2}, {0, 1, 4, 3},
                                                   {0, 1, 3, 7}, {0, 1, 5, 6}, {0, 1, 7, 5}};
  std::vector<std::array<Index, 4>> sorted_found, sorted_expected;
  for (auto tet : grid.mesh.tets) {
    std::sort(tet.begin(), tet.end());
    sorted_found.push_back(tet);
  }
  for (auto tet : expected) {
    std::sort(tet.begin(), tet.end());
    sorted_expected.push_back(tet);
  }
  EXPECT_EQ(sorted_found, sorted_expected);  // xyz, xzy, yxz, yzx, zxy, zyx
  EXPECT_EQ(exact_mesh::fault(grid.mesh), "");
  EXPECT_EQ(exact_mesh::volume6(grid.mesh), Rational(6, 8));
  EXPECT_EQ(grid.mesh.points[0], Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(grid.mesh.points[1], Eigen::Vector3d(0.5, 0.5, 0.5));
}

TEST(Extract, NumbersAscendAsReadingD3) {
  std::mt19937_64 random(7);
  const Lattice lattice = unit_lattice({12, 12, 12});
  const Grid grid = extract_all(lattice, random_indicators(lattice, random, {}), Diagonals::shortest);
  for (std::size_t p = 1; p < grid.mesh.points.size(); ++p)
    EXPECT_LT(std::pair(grid.origins[p - 1], grid.sources[p - 1]),
              std::pair(grid.origins[p], grid.sources[p]));
  EXPECT_TRUE(std::is_sorted(grid.lattice_tet.begin(), grid.lattice_tet.end()));
  EXPECT_GT(std::count(grid.origins.begin(), grid.origins.end(), Origin::centroid), 0);
  std::set<Index> named;
  for (const auto& tet : grid.mesh.tets) named.insert(tet.begin(), tet.end());
  EXPECT_EQ(named.size(), grid.mesh.points.size()) << "a point that no tetrahedron uses";
}

TEST(Extract, SameForAnyNumberOfThreads) {
  std::mt19937_64 random(8);
  const Lattice lattice = unit_lattice({6, 7, 9});
  const Indicators indicators = random_indicators(lattice, random, {.zeros = true, .zeros_changed = true});
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return extract_all(lattice, indicators, Diagonals::shortest);
  };
  const Grid one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.mesh.points, four.mesh.points);
  EXPECT_EQ(one.mesh.tets, four.mesh.tets);
  EXPECT_EQ(one.rows, four.rows);
}

TEST(Extract, AMissingIntersectionIsOurOwnFault) {
  const Lattice lattice = unit_lattice({1, 1, 1});
  Indicators indicators;
  indicators.sign = {-1, 1, 1, 1, 1, 1, 1, 1};
  indicators.initial = indicators.sign;
  indicators.cuts.directions.assign(8, 0);
  indicators.cuts.first.assign(8, 0);
  EXPECT_THROW(extract_all(lattice, indicators, Diagonals::lowest), std::logic_error);
}

}  // namespace
}  // namespace tetproof::reference
