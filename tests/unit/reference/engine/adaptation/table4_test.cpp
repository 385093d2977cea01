// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4 and the splits that it makes: each row on a cluster of tetrahedra built by hand.
#include "reference/engine/adaptation/table4.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "reference/engine/first_grid/exact.hpp"
#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// The tetrahedron v1 v2 v3 v4 of the table has the numbers 0 to 3. It has a neighbour across each face in
// `shared` (a face is named by the opposite corner). Each edge in `touched` belongs to a further tetrahedron
// that shares no face with it.
struct Cluster {
  std::vector<Index> surface;
  std::vector<int> shared;
  std::vector<std::array<Index, 2>> touched;
};

// From long to short the edges are 1 2, 1 3, 0 1, 2 3, 0 2, 0 3. From large to small the faces are 1 2 3, 0 1
// 2, 0 1 3, 0 2 3.
const std::vector<Vector3d> corners{{0, 0, 0}, {10, 0, 0}, {0, 8, 0}, {1, 1, 6}};

Triangulation build(const Cluster& cluster) {
  TetMesh mesh{corners, {{0, 1, 2, 3}}};
  const Vector3d centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  const auto add_positive = [&](Corners tet) {
    const auto& x = mesh.points;
    if (orientation(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) < 0) std::swap(tet[2], tet[3]);
    mesh.tets.push_back(tet);
  };
  for (const int f : cluster.shared) {
    const auto& [i, j, k] = tet_faces[f];
    const Vector3d face = (corners[i] + corners[j] + corners[k]) / 3;
    mesh.points.push_back(face + 2 * (face - centre));
    add_positive({i, j, k, static_cast<Index>(mesh.points.size()) - 1});
  }
  for (const auto& [i, j] : cluster.touched) {
    const Vector3d out = (corners[i] + corners[j]) / 2 - centre;
    const Vector3d across = (corners[j] - corners[i]).cross(out).normalized();
    mesh.points.push_back((corners[i] + corners[j]) / 2 + 2 * out + 0.1 * across);
    mesh.points.push_back((corners[i] + corners[j]) / 2 + 2 * out - 0.1 * across);
    const auto n = static_cast<Index>(mesh.points.size());
    add_positive({i, j, n - 2, n - 1});
  }
  std::vector<std::uint8_t> on_surface(mesh.points.size(), 0);
  for (const Index p : cluster.surface) on_surface[p] = 1;
  return Triangulation(std::move(mesh), std::move(on_surface));
}

struct Row {
  const char* title;
  Cluster cluster;
  std::string_view row;
  std::vector<int> replaced;
  bool on_surface;
};

class Table4 : public testing::TestWithParam<Row> {};

TEST_P(Table4, PutsThePointWhereTheRowSays) {
  const Row& row = GetParam();
  const Triangulation grid = build(row.cluster);
  const Split split = split_by_table4(grid, 0);
  EXPECT_EQ(tables::table4[split.row].name, row.row);
  EXPECT_EQ(std::vector(split.replaced.begin(), split.replaced.begin() + split.pieces), row.replaced);
  EXPECT_EQ(split.on_surface, row.on_surface);
  Vector3d mean = Vector3d::Zero();
  for (const int i : row.replaced) mean += corners[i] / static_cast<double>(row.replaced.size());
  EXPECT_LT((split.point - mean).norm(), 1e-14);
}

TEST_P(Table4, LeavesAConformingTriangulationOfTheSameVolume) {
  Triangulation grid = build(GetParam().cluster);
  const auto before = exact_mesh::volume6(grid.mesh());
  const Split split = split_by_table4(grid, 0);
  const Index point = grid.add_point(split.point, split.on_surface);
  const auto pieces = pieces_of(grid.corners(0), split, point);
  const std::int64_t tets = grid.tets();
  const Index first = grid.replace(std::array<Index, 1>{0}, std::span(pieces).first(split.pieces));
  EXPECT_EQ(grid.tets(), tets + split.pieces - 1);
  EXPECT_FALSE(grid.alive(0));
  EXPECT_TRUE(grid.alive(first));
  EXPECT_EQ(exact_mesh::fault(grid.mesh()), "");
  const double ratio = static_cast<double>(exact_mesh::volume6(grid.mesh()) / before);
  EXPECT_NEAR(ratio, 1, 1e-15);
  // Every neighbour is now the neighbour of a piece.
  for (Index t = 1; t < grid.numbers(); ++t)
    for (int f = 0; grid.alive(t) && f < 4; ++f)
      EXPECT_TRUE(grid.neighbour(t, f) < 0 || grid.alive(grid.neighbour(t, f)));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, Table4,
    testing::Values(
        Row{"NoSurfacePoint", {{}, {0, 1, 2, 3}, {}}, "0", {0, 1, 2, 3}, false},
        Row{"NoSurfacePointOnTheOuterBoundary", {{}, {0}, {}}, "0", {0, 1, 2, 3}, false},
        Row{"One", {{2}, {0, 1, 2, 3}, {}}, "1", {0, 1, 2, 3}, false},
        Row{"OneAlone", {{2}, {}, {}}, "1", {0, 1, 2, 3}, false},
        Row{"TwoEdgeSharedThroughAFace", {{0, 1}, {2}, {}}, "2a", {0, 1, 2, 3}, false},
        Row{"TwoEdgeTouchedOnly", {{0, 1}, {0, 1}, {{0, 1}}}, "2a", {0, 1, 2, 3}, false},
        Row{"TwoEdgeUnshared", {{0, 3}, {0, 3}, {}}, "2b", {0, 3}, true},
        Row{"ThreeFaceShared", {{0, 1, 3}, {2}, {}}, "3a", {0, 1, 2, 3}, false},
        Row{"ThreeFaceUnshared", {{0, 1, 3}, {0, 1, 3}, {}}, "3b", {0, 1, 3}, true},
        Row{"FourAllShared", {{0, 1, 2, 3}, {0, 1, 2, 3}, {}}, "4a", {0, 1, 2, 3}, false},
        Row{"FourOneFaceUnshared", {{0, 1, 2, 3}, {1, 2, 3}, {}}, "4b", {1, 2, 3}, true},
        Row{"FourTwoFacesUnshared", {{0, 1, 2, 3}, {2, 3}, {}}, "4c", {2, 3}, true},
        Row{"FourTwoFacesUnsharedEdgeTouched",
            {{0, 1, 2, 3}, {2, 3}, {{2, 3}}},
            "4c",
            {1, 2, 3},
            true},  // face 1 2 3 is larger than 0 2 3
        Row{"FourThreeFacesUnshared", {{0, 1, 2, 3}, {3}, {}}, "4d", {1, 3}, true},
        Row{"FourThreeFacesUnsharedLongestTouched", {{0, 1, 2, 3}, {2}, {{1, 2}}}, "4d", {2, 3}, true},
        Row{"FourAlone", {{0, 1, 2, 3}, {}, {}}, "4e", {1, 2}, true},
        Row{"FourAloneLongestTouched", {{0, 1, 2, 3}, {}, {{1, 2}}}, "4e", {1, 3}, true},
        Row{"FourAloneAllEdgesTouched",
            {{0, 1, 2, 3}, {}, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}},
            "4e",
            {1, 2, 3},
            true}),
    [](const auto& tested) { return tested.param.title; });

TEST(Table4Ties, GoToTheLowestNumbers) {
  // A regular tetrahedron without neighbours: its six edges have the same length.
  const TetMesh regular{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{3, 2, 0, 1}}};
  const auto& x = regular.points;
  ASSERT_GT(orientation(x[3], x[2], x[0], x[1]), 0);
  const Triangulation grid(regular, {1, 1, 1, 1});
  const Split split = split_by_table4(grid, 0);
  EXPECT_EQ(split.replaced[0], 2);  // the positions of points 0 and 1
  EXPECT_EQ(split.replaced[1], 3);
  EXPECT_EQ(splits_by_table4(grid, 0, 1e-12).size(), 6u);
}

TEST(Triangulation, RefusesWhatWouldNotConform) {
  Triangulation grid = build({{}, {0, 1, 2, 3}, {}});
  const std::array<Index, 1> old{0};
  EXPECT_THROW(grid.replace(old, std::array<Corners, 1>{Corners{0, 1, 2, 5}}), std::logic_error);
  EXPECT_THROW(Triangulation({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}},
                              {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}},
                             std::vector<std::uint8_t>(6, 0)),
               std::logic_error);
}

}  // namespace
}  // namespace tetproof::reference
