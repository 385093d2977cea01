// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted later is nearer, wherever two triangles overlap: compared at random places with all
// triangles there, by brute force.
#include "reference/figure/painters_order.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include "reference/figure/cut_open.hpp"
#include "reference/figure/figure.hpp"
#include "tests/unit/reference/figure/sections.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangles = std::vector<SeenTriangle>;

// The places of triangles in the painting: its layer; and each triangle is painted once.
std::vector<std::size_t> layers_of(const Triangles& triangles, const PaintersOrder& order) {
  std::vector<std::size_t> layer(triangles.size(), order.layers.size());
  for (std::size_t l = 0; l < order.layers.size(); ++l) {
    EXPECT_FALSE(order.layers[l].empty());
    for (const std::size_t i : order.layers[l]) {
      EXPECT_EQ(layer.at(i), order.layers.size()) << "triangle " << i << " is painted twice";
      layer[i] = l;
      EXPECT_EQ(triangles[i].colour, triangles[order.layers[l][0]].colour);
    }
  }
  for (const std::size_t l : layer) EXPECT_LT(l, order.layers.size()) << "a triangle is not painted";
  return layer;
}

// Pairs that cover a common place and are painted in the wrong order, or in one layer. At each place, depths
// are solved from the triangle's equations, in another way than the order does it.
struct Faults {
  int pairs = 0, wrong = 0;
};
Faults faults(const Triangles& triangles, const std::vector<std::size_t>& layer, std::mt19937& random,
              int places) {
  Faults found;
  Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const SeenTriangle& t : triangles)
    for (const Vector3d& p : t.corners) {
      low = low.cwiseMin(p.head<2>());
      high = high.cwiseMax(p.head<2>());
    }
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < places; ++k) {
    // Most places are in a triangle, so that small ones are met too.
    const auto& [a, b, c] = triangles[random() % triangles.size()].corners;
    double u = part(random), v = part(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vector3d inner = a + u * (b - a) + v * (c - a);
    const Vector2d at =
        k % 4 == 0 ? Vector2d(low + Vector2d(u, v).cwiseProduct(high - low)) : Vector2d(inner.head<2>());
    struct Hit {
      double depth;
      std::size_t layer;
    };
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      Eigen::Matrix3d corners;
      for (int j = 0; j < 3; ++j) corners.col(j) << triangles[i].corners[j].head<2>(), 1;
      const Vector3d weights = corners.fullPivLu().solve(Vector3d(at.x(), at.y(), 1));
      if (weights.minCoeff() < 1e-3) continue;  // not near the border: the smallest overlaps do not count
      double depth = 0;
      for (int j = 0; j < 3; ++j) depth += weights[j] * triangles[i].corners[j].z();
      hits.push_back({depth, layer[i]});
    }
    for (std::size_t i = 0; i < hits.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        ++found.pairs;
        found.wrong +=
            hits[i].depth > hits[j].depth ? hits[i].layer <= hits[j].layer : hits[j].layer <= hits[i].layer;
      }
  }
  return found;
}

SeenTriangle turned_to_viewer(Vector3d a, Vector3d b, Vector3d c, int colour) {
  if ((b - a).cross(c - a).z() < 0) std::swap(b, c);
  return {{a, b, c}, colour};
}

TEST(PaintersOrder, IsRightForMeshesCutOpen) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  int pairs = 0;
  for (int round = 0; round < 12; ++round) {
    // A cube of cells, bent at random, of which random tetrahedra are missing: cavities, overhangs, islands.
    TetMesh mesh = test::block(4);
    for (Vector3d& p : mesh.points) p += 0.03 * Vector3d(place(random), place(random), place(random));
    std::erase_if(mesh.tets, [&](const auto&) { return random() % 3 == 0; });
    const Vector3d view(place(random), place(random), place(random));
    const auto [right, up] = axes_seen_from(view);
    Triangles triangles;
    for (const OpenFace& face : cut_open(mesh, {view, 0.5 * view.sum()}).faces) {
      SeenTriangle seen;
      for (int i = 0; i < 3; ++i) {
        const Vector3d& p = mesh.points[face.corners[i]];
        seen.corners[i] = {right.dot(p), up.dot(p), view.normalized().dot(p)};
      }
      seen.colour = static_cast<int>(random() % 5);
      if ((seen.corners[1] - seen.corners[0]).cross(seen.corners[2] - seen.corners[0]).z() > 0)
        triangles.push_back(seen);
    }
    ASSERT_GT(triangles.size(), 50u);
    const PaintersOrder order = painters_order(triangles);
    EXPECT_EQ(order.wrong_pairs, 0);
    const auto layer = layers_of(triangles, order);
    const Faults found = faults(triangles, layer, random, 600);
    EXPECT_EQ(found.wrong, 0) << "round " << round;
    pairs += found.pairs;
  }
  EXPECT_GT(pairs, 5000);
}

// Long thin triangles, one above the other: most centroids say nothing about who covers whom.
TEST(PaintersOrder, IsRightForSlantedTrianglesWhereCentroidsAreWrong) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 1);
  Triangles triangles;
  for (int i = 0; i < 120; ++i) {  // each in a slanted layer of its own
    const auto point = [&] {
      const double x = place(random), y = place(random);
      return Vector3d(x, y, 40 * x + 0.01 * i);
    };
    triangles.push_back(turned_to_viewer(point(), point(), point(), i % 3));
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  const PaintersOrder order = painters_order(triangles);
  EXPECT_EQ(order.wrong_pairs, 0);
  const Faults found = faults(triangles, layers_of(triangles, order), random, 500);
  EXPECT_GT(found.pairs, 1000);
  EXPECT_EQ(found.wrong, 0);

  // The comparison can fail: by centroids the same triangles are painted wrongly.
  std::vector<std::size_t> by_centroid(triangles.size()), layer(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) by_centroid[i] = i;
  const auto depth = [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i].corners;
    return a.z() + b.z() + c.z();
  };
  std::sort(by_centroid.begin(), by_centroid.end(), [&](auto i, auto j) { return depth(i) < depth(j); });
  for (std::size_t l = 0; l < by_centroid.size(); ++l) layer[by_centroid[l]] = l;
  EXPECT_GT(faults(triangles, layer, random, 500).wrong, 100);
}

TEST(PaintersOrder, TrianglesOfOneColourThatDoNotOverlapAreOneLayer) {
  Triangles triangles;
  for (int i = 0; i < 20; ++i)
    triangles.push_back({{Vector3d(i, 0, i), Vector3d(i + 1, 0, -i), Vector3d(i, 1, 3)}, 4});
  EXPECT_EQ(painters_order(triangles).layers.size(), 1u);
  EXPECT_TRUE(painters_order({}).layers.empty());
  // Two that have an edge in common do not overlap; one behind another does.
  triangles = {{{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}, 0},
               {{Vector3d(1, 0, 0), Vector3d(1, 1, 0), Vector3d(0, 1, 0)}, 0}};
  EXPECT_EQ(painters_order(triangles).layers.size(), 1u);
  triangles.push_back({{Vector3d(0, 0, -1), Vector3d(1, 0, -1), Vector3d(0, 1, -1)}, 0});
  EXPECT_EQ(painters_order(triangles).layers, (std::vector<std::vector<std::size_t>>{{1, 2}, {0}}));
  // Triangles seen from behind or from the edge hide nothing, and are there.
  triangles = {{{Vector3d(0, 0, 5), Vector3d(0, 1, 5), Vector3d(1, 0, 5)}, 0},
               {{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}, 0},
               {{Vector3d(0, 0, 9), Vector3d(1, 1, 9), Vector3d(0.5, 0.5, 8)}, 0}};
  EXPECT_EQ(painters_order(triangles).layers.size(), 1u);
}

TEST(PaintersOrder, ACircleIsSaid) {
  // Three long triangles, each over the next one.
  Triangles triangles;
  for (int i = 0; i < 3; ++i) {
    const Eigen::AngleAxisd turn(i * 2 * 3.14159265358979 / 3, Vector3d::UnitZ());
    triangles.push_back(turned_to_viewer(turn * Vector3d(-2, -0.9, -1), turn * Vector3d(2, -1, 1),
                                         turn * Vector3d(2, -0.8, 1), i));
  }
  // And one behind all of them, which must still come first; and one before them, which must come last.
  triangles.push_back({{Vector3d(-9, -9, -9), Vector3d(9, -9, -9), Vector3d(0, 9, -9)}, 3});
  triangles.push_back({{Vector3d(-9, -9, 9), Vector3d(9, -9, 9), Vector3d(0, 9, 9)}, 3});
  const PaintersOrder order = painters_order(triangles);
  EXPECT_EQ(order.wrong_pairs, 1);
  const auto layer = layers_of(triangles, order);
  EXPECT_EQ(*std::min_element(layer.begin(), layer.end()), layer[3]);
  EXPECT_EQ(*std::max_element(layer.begin(), layer.end()), layer[4]);
  EXPECT_EQ(order.layers.size(), 5u);
}

}  // namespace
}  // namespace tetproof::reference
