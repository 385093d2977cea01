// SPDX-License-Identifier: GPL-3.0-or-later
// The brute-force test that decides what is true of a mesh with planted defects, on pairs of tetrahedra whose
// answer can be seen from a drawing.
#include "corpus/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/block_mesh.hpp"

namespace tetproof::test {
namespace {

using corpus::Truth;
using corpus::truth;
using Points = std::vector<Eigen::Vector3d>;

// A corner of a cube: vertex 0 is the origin, vertices 1 to 3 are on the axes at distance 4.
TetMesh corner(const Points& more, const std::vector<std::array<Index, 4>>& tets) {
  TetMesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 1, 2, 3}}};
  mesh.points.insert(mesh.points.end(), more.begin(), more.end());
  mesh.tets.insert(mesh.tets.end(), tets.begin(), tets.end());
  return mesh;
}

TEST(Truth, PairsOfTetrahedra) {
  struct Case {
    const char* name;
    TetMesh mesh;
    std::size_t overlaps, touches, crossings, faces = 0;  // pairs whose faces touch
  };
  const double below = std::nextafter(1.0, 0.0), tiny = 0x1p-60;
  const std::vector<Case> cases{
      {"apart", corner({{5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}}, {{4, 5, 6, 7}}), 0, 0, 0},
      {"inside", corner({{1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1}, {1, 1, 1.25}}, {{4, 5, 6, 7}}), 1, 0, 0},
      {"inside at a common vertex", corner({{1, .5, .5}, {.5, 1, .5}, {.5, .5, 1}}, {{0, 4, 5, 6}}), 1, 0, 0},
      {"inside at a common edge", corner({{1, 1, .5}, {1, .5, 1}}, {{0, 1, 4, 5}}), 1, 0, 0},
      {"inside at a common face", corner({{1, 1, 1}}, {{0, 1, 2, 4}}), 1, 0, 0},
      {"sharing a face", corner({{4, 4, 4}}, {{1, 2, 3, 4}}), 0, 0, 0},
      {"sharing an edge", corner({{5, 5, 1}, {5, 5, 2}}, {{1, 2, 4, 5}}), 0, 0, 0},
      {"sharing a vertex", corner({{5, 1, 0}, {5, -1, 0}, {5, 0, 1}}, {{1, 4, 5, 6}}), 0, 0, 0},
      {"tip on a face", corner({{1, 1, 0}, {1, 1, -1}, {2, 1, -1}, {1, 2, -1}}, {{4, 5, 6, 7}}), 0, 1, 0},
      {"tip short of a face", corner({{1, 1, -tiny}, {1, 1, -1}, {2, 1, -1}, {1, 2, -1}}, {{4, 5, 6, 7}}), 0,
       0, 0},
      {"tip through a face", corner({{1, 1, tiny}, {1, 1, -1}, {2, 1, -1}, {1, 2, -1}}, {{4, 5, 6, 7}}), 1, 0,
       0},
      {"tip on an edge", corner({{1, 0, 0}, {1, -1, -1}, {2, -1, -1}, {1, -2, -1}}, {{4, 5, 6, 7}}), 0, 1, 0},
      {"edge across an edge", corner({{1, 1, -1}, {1, -1, 1}, {1, -2, -2}, {2, -2, -2}}, {{4, 5, 6, 7}}), 0,
       0, 1},
      {"edge short of an edge",
       corner({{1, 1, -1 - tiny}, {1, -1, below}, {1, -2, -2}, {2, -2, -2}}, {{4, 5, 6, 7}}), 0, 0, 0},
      {"face in a face", corner({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {1, 1, -1}}, {{4, 5, 6, 7}}), 0, 3, 0, 1},
      {"face over a face", corner({{-1, 1, 0}, {1, -1, 0}, {1, 1, 0}, {1, 1, -1}}, {{4, 5, 6, 7}}), 0, 2, 1,
       1},
      {"faces of equal places", corner({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -4}}, {{4, 5, 6, 7}}), 0, 6,
       0},
      {"common vertex, and its edge on a face", corner({{2, 2, 0}, {2, 0, -1}, {2, 1, -1}}, {{0, 4, 5, 6}}),
       0, 1, 0},
      {"one of them negative", corner({{1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1}, {1, 1, 1.25}}, {{5, 4, 6, 7}}), 1,
       0, 0},
  };
  for (const Case& c : cases)
    for (const bool turned : {false, true})
      for (const double scale : {1.0, 0x1p-900, 0x1p900}) {
        SCOPED_TRACE(testing::Message() << c.name << ' ' << turned << ' ' << scale);
        TetMesh mesh = c.mesh;
        if (turned) std::swap(mesh.tets[0], mesh.tets[1]);
        for (Eigen::Vector3d& p : mesh.points) p *= scale;
        if (scale < 1 && std::string_view(c.name).find("short") != std::string_view::npos) continue;
        const Truth found = truth(mesh);
        EXPECT_EQ(found.overlaps.size(), c.overlaps);
        EXPECT_EQ(found.touches.size(), c.touches);
        EXPECT_EQ(found.crossings.size(), c.crossings);
        EXPECT_EQ(found.touching_faces.size(), c.faces);
      }
}

TEST(Truth, OfCopiesAndShiftedNumbers) {
  TetMesh mesh = corpus::block_mesh({2, 2, 1});
  EXPECT_TRUE(truth(mesh).copies.empty());
  EXPECT_EQ(truth(mesh).shift, 0);
  const auto points = static_cast<Index>(mesh.points.size());
  for (Index v = 0; v < points; ++v) mesh.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  const auto& [a, b, c, d] = mesh.tets[3];
  mesh.tets.push_back({c + points, b + points, a + points, d});
  EXPECT_EQ(truth(mesh).copies, (std::vector<std::vector<Index>>{{3, 24}}));
  EXPECT_TRUE(truth(mesh).duplicates.empty());
  mesh.tets.pop_back();
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v += 2;
  EXPECT_EQ(truth(mesh).shift, 2);
}

TEST(Truth, OfSoundMeshes) {
  for (const TetMesh& mesh :
       {corpus::block_mesh({3, 2, 2}), corpus::block_mesh({2, 3, 2}, 0.1, 5), corpus::ball_mesh(3, 0.1, 2),
        corpus::moved(corpus::ball_mesh(3), 1e-9, {0, 0, 0}),
        corpus::moved(corpus::block_mesh({2, 2, 2}), 1, {1e6, 1e6, -1e6})}) {
    const Truth found = truth(mesh);
    EXPECT_TRUE(found.valid());
    EXPECT_TRUE(found.all);
    EXPECT_TRUE(found.nonmanifold_edges.empty());
    EXPECT_TRUE(found.nonmanifold_vertices.empty());
    EXPECT_TRUE(found.unused.empty());
    for (const char* id : {"inverted", "flat", "overlap", "crack", "duplicate-point"})
      EXPECT_FALSE(found.confirms(id)) << id;
  }
}

TEST(Truth, NumbersFacesAndOrientation) {
  TetMesh mesh = corpus::block_mesh({2, 1, 1});
  const auto changed = [&](auto change) {
    TetMesh bad = mesh;
    change(bad);
    const Truth found = truth(bad);
    EXPECT_FALSE(found.valid());
    return found;
  };
  EXPECT_EQ(changed([](TetMesh& m) { m.tets[3][1] = -1; }).out_of_range, std::vector<Index>{3});
  EXPECT_EQ(changed([](TetMesh& m) { m.tets[3][1] = 12; }).out_of_range, std::vector<Index>{3});
  EXPECT_FALSE(changed([](TetMesh& m) { m.points[2].y() = std::nan(""); }).not_finite.empty());
  EXPECT_EQ(changed([](TetMesh& m) { m.tets[3][1] = m.tets[3][0]; }).repeating, std::vector<Index>{3});
  EXPECT_EQ(changed([](TetMesh& m) { std::swap(m.tets[3][1], m.tets[3][0]); }).negative,
            std::vector<Index>{3});
  const Truth twice = changed([](TetMesh& m) {
    m.tets.push_back({m.tets[3][2], m.tets[3][0], m.tets[3][1], m.tets[3][3]});
  });
  EXPECT_EQ(twice.duplicates, (std::vector<std::vector<Index>>{{3, 12}}));
  EXPECT_TRUE(twice.confirms("face-shared-thrice") || twice.confirms("face-orientation"));
  const Truth flat = changed([](TetMesh& m) { m.tets.push_back({0, 1, 4, 3}); });
  EXPECT_EQ(flat.flat, std::vector<Index>{12});
  const Truth cracked = changed([](TetMesh& m) {
    for (Index& v : m.tets[3]) m.points.push_back(m.points[v]), v = static_cast<Index>(m.points.size() - 1);
  });
  EXPECT_FALSE(cracked.coinciding_faces.empty());
  EXPECT_EQ(cracked.equal_points.size(), 4u);
}

TEST(Truth, OrientationOfOneUnitInTheLastPlace) {
  const Eigen::Vector3d a(0.1, 0.2, 0.3), b(0.7, 0.2, 0.3), c(0.1, 0.9, 0.3);
  EXPECT_EQ(corpus::orientation(a, b, c, {0.2, 0.3, 0.3}), 0);
  EXPECT_EQ(corpus::orientation(a, b, c, {0.2, 0.3, std::nextafter(0.3, 1.0)}), 1);
  EXPECT_EQ(corpus::orientation(a, b, c, {0.2, 0.3, std::nextafter(0.3, 0.0)}), -1);
  EXPECT_TRUE(corpus::within_of_line({0.5, 1e-13, 0}, {0, 0, 0}, {1, 0, 0}, 1e-13));
  EXPECT_FALSE(corpus::within_of_line({0.5, 1.0001e-13, 0}, {0, 0, 0}, {1, 0, 0}, 1e-13));
  EXPECT_TRUE(corpus::within_of_plane({0.5, 0.2, -1e-13}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1e-13));
  EXPECT_FALSE(corpus::within_of_plane({0.5, 0.2, -1.0001e-13}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1e-13));
}

}  // namespace
}  // namespace tetproof::test
