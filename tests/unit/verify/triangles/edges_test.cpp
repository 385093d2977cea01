// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of so many triangles that several tasks match them.
#include "verify/triangles/edges.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace tetproof::verify {
namespace {

// Strip i is the square of the vertices 4 i .. 4 i + 3, cut along 4 i, 4 i + 2 into the triangles 2 i and 2 i
// + 1.
std::vector<Triangle> strips(Index count) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < count; ++i) {
    triangles.push_back({4 * i, 4 * i + 1, 4 * i + 2});
    triangles.push_back({4 * i, 4 * i + 2, 4 * i + 3});
  }
  return triangles;
}

TEST(MatchEdges, ListsAscendOverManyVertices) {
  constexpr Index count = 20'000;
  std::vector<Triangle> triangles = strips(count);
  // Two faults far apart: a triangle turned over, and a third one at an edge.
  constexpr Index turned = 15'000, third = 18'000;
  std::swap(triangles[2 * turned + 1][0], triangles[2 * turned + 1][1]);
  triangles.push_back({4 * third, 4 * third + 2, 4 * third + 1});
  for (const int threads : {1, 2, 7}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const EdgeMatching edges = match_edges(triangles, 4 * std::size_t{count});
    // By hand: four open sides a strip, in the order of their vertices 0-1, 0-3, 1-2, 2-3.
    std::vector<Side> open;
    for (Index i = 0; i < count; ++i) {
      const Side s = 6 * i;
      if (i == turned)
        open.insert(open.end(), {s, s + 4, s + 1, s + 5});
      else if (i == third)  // its third triangle matches the sides 0-1 and 1-2
        open.insert(open.end(), {s + 5, s + 4});
      else
        open.insert(open.end(), {s, s + 5, s + 1, s + 4});
    }
    EXPECT_EQ(edges.open, open);
    EXPECT_EQ(edges.same_direction, (std::vector<std::array<Side, 2>>{{6 * turned + 2, 6 * turned + 3}}));
    EXPECT_EQ(edges.nonmanifold, (std::vector<std::vector<Side>>{{6 * third + 2, 6 * third + 3, 6 * count}}));
    EXPECT_EQ(edges.mate[0], no_side);
    EXPECT_EQ(edges.mate[2], 3);
    EXPECT_EQ(edges.mate[6 * count - 4], 6 * count - 3);
    EXPECT_EQ(edges.mate[6 * third], 6 * count + 2);
  }
}

}  // namespace
}  // namespace tetproof::verify
