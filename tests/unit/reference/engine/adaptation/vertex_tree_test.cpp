// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (3.2): the k-d tree finds the same vertex as a search through all vertices.
#include "reference/engine/adaptation/vertex_tree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

// Searches all vertices. Ties go to the smallest coordinates.
std::pair<Index, double> by_brute_force(const std::vector<Vector3d>& vertices, const Vector3d& p) {
  const auto key = [&](Index v) {
    const Vector3d d = p - vertices[v];
    return std::tuple(d.x() * d.x() + d.y() * d.y() + d.z() * d.z(), vertices[v].x(), vertices[v].y(),
                      vertices[v].z());
  };
  Index best = 0;
  for (Index v = 1; v < static_cast<Index>(vertices.size()); ++v)
    if (key(v) < key(best)) best = v;
  return {best, std::sqrt(std::get<0>(key(best)))};
}

TEST(VertexTree, FindsWhatGoingThroughAllVerticesFinds) {
  std::mt19937_64 random(3);
  const auto coordinate = [&] { return static_cast<double>(random() % 4096) / 512 - 4; };
  std::vector<Vector3d> vertices;
  for (int i = 0; i < 3000; ++i) vertices.emplace_back(coordinate(), coordinate(), coordinate());
  const VertexTree tree(vertices);
  for (int i = 0; i < 3000; ++i) {
    const Vector3d p(coordinate(), coordinate(), coordinate());
    const auto [vertex, distance] = by_brute_force(vertices, p);
    ASSERT_EQ(tree.distance(p), distance);
    ASSERT_EQ(tree.distance(p, distance), distance) << "a bound that is reached";
    ASSERT_EQ(tree.distance(p, 2 * distance), distance);
    ASSERT_EQ(tree.nearest(p, distance), vertex);
  }
}

TEST(VertexTree, TiesGoToTheLexicographicallySmallest) {
  std::vector<Vector3d> grid;  // every point of the dual grid has eight closest vertices
  for (int z = 5; z >= 0; --z)
    for (int x = 0; x < 6; ++x)
      for (int y = 5; y >= 0; --y) grid.emplace_back(x, y, z);
  const VertexTree tree(grid);
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z) {
        const Vector3d p(x + 0.5, y + 0.5, z + 0.5);
        EXPECT_EQ(tree.distance(p), std::sqrt(0.75));
        EXPECT_EQ(grid[tree.nearest(p, tree.distance(p))], Vector3d(x, y, z));
        // Differences within rounding count as ties.
        const Vector3d off = p + Vector3d(1e-14, 2e-14, 1e-14);
        EXPECT_EQ(grid[tree.nearest(off, tree.distance(off))], Vector3d(x, y, z));
      }
}

TEST(VertexTree, AWrongPromiseIsOurOwnFault) {
  const VertexTree tree({{0, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(tree.distance({5, 0, 0}, 3), std::logic_error);
  EXPECT_THROW(tree.nearest({5, 0, 0}, 3), std::logic_error);
}

}  // namespace
}  // namespace tetproof::reference
