// SPDX-License-Identifier: GPL-3.0-or-later
// Step (i): eq. (2.1), the box, the numbering and the six tetrahedra.
#include "reference/engine/first_grid/lattice.hpp"

#include <gtest/gtest.h>

#include <set>

#include "io/error.hpp"
#include "tests/support/exact_mesh.hpp"

namespace tetproof::reference {
namespace {

// A tetrahedral surface with the given box.
TriangleSurface surface_with_box(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) {
  TriangleSurface s;
  s.vertices = {lo, {hi.x(), lo.y(), lo.z()}, {lo.x(), hi.y(), lo.z()}, {lo.x(), lo.y(), hi.z()}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return s;
}

TEST(Equation21, IsTheSumOverTheEightCornersOfTheBox) {
  const Lattice lattice = make_lattice(surface_with_box({-1, 2, 0.1}, {3, 2.5, 9}), {4, 3, 7}, 1.3);
  const auto box = [&](int axis, int end) {
    return end ? lattice.planes[axis].back() : lattice.planes[axis].front();
  };
  const auto bernstein = [](int degree_index, double t) { return degree_index ? t : 1 - t; };
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 3; ++j)
      for (int k = 0; k <= 7; ++k) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int I = 0; I < 2; ++I)
          for (int J = 0; J < 2; ++J)
            for (int K = 0; K < 2; ++K)
              sum += Eigen::Vector3d(box(0, I), box(1, J), box(2, K)) * bernstein(I, i / 4.0) *
                     bernstein(J, j / 3.0) * bernstein(K, k / 7.0);
        EXPECT_LT((lattice.point(i, j, k) - sum).norm(), 1e-14) << i << ' ' << j << ' ' << k;
      }
}

TEST(Lattice, BoxIsScaledAboutItsCentre) {
  const Lattice lattice = make_lattice(surface_with_box({0, 0, 0}, {4, 2, 1}), {8, 0, 0}, 1.5);
  EXPECT_EQ(lattice.cells, (std::array{8, 4, 4}));  // cubes of 0.75, but at least four cells a side
  EXPECT_EQ(lattice.planes[0].front(), -1);
  EXPECT_EQ(lattice.planes[0].back(), 5);
  EXPECT_EQ(lattice.planes[1].front(), -0.5);
  EXPECT_EQ(lattice.planes[2].back(), 1.25);
  EXPECT_DOUBLE_EQ(lattice.shortest_edge, 0.375);
  EXPECT_EQ(make_lattice(surface_with_box({0, 0, 0}, {4, 2, 1}), {3, 0, 0}, 1.5).cells,
            (std::array{3, 3, 3}));
}

TEST(Lattice, NumbersVerticesAsReadingD3) {
  const Lattice lattice = make_lattice(surface_with_box({0, 0, 0}, {1, 1, 1}), {3, 4, 5}, 1.2);
  EXPECT_EQ(lattice.vertices(), 4 * 5 * 6);
  EXPECT_EQ(lattice.vertex(1, 2, 3), 1 + 4 * (2 + 5 * 3));
  for (Vertex v = 0; v < lattice.vertices(); ++v) {
    const auto [i, j, k] = lattice.position(v);
    EXPECT_EQ(lattice.vertex(i, j, k), v);
  }
  EXPECT_EQ(lattice.high(Edge{lattice.vertex(0, 1, 2)} * 8 + 5), lattice.vertex(1, 1, 3));
}

TEST(Lattice, EdgesAscendLexicographically) {
  const Lattice lattice = make_lattice(surface_with_box({0, 0, 0}, {1, 1, 1}), {1, 1, 1}, 1.2);
  for (int direction = 1; direction < 7; ++direction)
    EXPECT_LT(lattice.offset(direction), lattice.offset(direction + 1));
}

TEST(KuhnSplit, TilesTheCellAndSharesItsMainDiagonal) {
  TetMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  for (std::size_t t = 0; t < 6; ++t) {
    std::array<Index, 4> tet;
    for (int v = 0; v < 4; ++v) tet[v] = kuhn_tets[t][v];
    EXPECT_EQ(tet[0], 0);
    EXPECT_EQ(tet[3], 7);
    EXPECT_TRUE(std::is_sorted(tet.begin(), tet.end()));
    if (kuhn_signs[t] < 0) std::swap(tet[2], tet[3]);
    mesh.tets.push_back(tet);
  }
  std::vector<std::array<Index, 3>> boundary;
  EXPECT_EQ(exact_mesh::fault(mesh, &boundary), "");
  EXPECT_EQ(boundary.size(), 12u);
  EXPECT_EQ(exact_mesh::volume6(mesh), 6);
}

TEST(KuhnSplit, MatchesFromCellToCell) {
  const Lattice lattice = make_lattice(surface_with_box({0, 0, 0}, {1, 1, 1}), {3, 2, 2}, 2);
  TetMesh mesh;
  for (Vertex v = 0; v < lattice.vertices(); ++v) mesh.points.push_back(lattice.point(v));
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i)
        for (std::size_t t = 0; t < 6; ++t) {
          std::array<Index, 4> tet;
          for (int v = 0; v < 4; ++v) tet[v] = lattice.vertex(i, j, k) + lattice.offset(kuhn_tets[t][v]);
          if (kuhn_signs[t] < 0) std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
        }
  std::vector<std::array<Index, 3>> boundary;
  EXPECT_EQ(exact_mesh::fault(mesh, &boundary), "");
  EXPECT_EQ(boundary.size(), 2u * 2 * (3 * 2 + 3 * 2 + 2 * 2));
}

std::string refusal(const TriangleSurface& surface, std::array<int, 3> cells, double scale) {
  try {
    make_lattice(surface, cells, scale);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Lattice, RefusesWhatItCannotUse) {
  const TriangleSurface unit = surface_with_box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(refusal(unit, {4, 4, 4}, 1), "the box scale must be more than 1 and below 1e6, found 1");
  EXPECT_EQ(refusal(unit, {4, 0, 4}, 1.2),
            "the number of cells must be 1 or more in each direction, found 0");
  EXPECT_EQ(refusal(unit, {100000, 0, 0}, 1.2),
            "a lattice of 100000 x 100000 x 100000 cells is too large: more than 4e8 vertices");
  const double big = 1e16;
  EXPECT_EQ(refusal(surface_with_box({big, 0, 0}, {big + 4, 1, 1}), {24, 2, 2}, 1.2),
            "the surface's box, 10000000000000000 .. 10000000000000004 along x, cannot be told apart into 24 "
            "cells in double precision");
  EXPECT_EQ(refusal(surface_with_box({0, 0, 0}, {1e100, 1, 1}), {4, 0, 0}, 1.2),
            "the longest side of the surface's box is 1e+100, expected 1e-90 to 1e90");
  EXPECT_EQ(refusal(TriangleSurface{}, {4, 4, 4}, 1.2), "the surface has no triangles");
}

TEST(Lattice, CellOfFindsThePlaneAtOrBelow) {
  const Lattice lattice = make_lattice(surface_with_box({0, 0, 0}, {1, 1, 1}), {7, 7, 7}, 1.2);
  for (int i = 0; i <= 7; ++i) {
    const double x = lattice.planes[0][i];
    EXPECT_EQ(lattice.cell_of(0, x), i);
    EXPECT_EQ(lattice.cell_of(0, std::nextafter(x, -10)), std::max(0, i - 1));
    EXPECT_EQ(lattice.cell_of(0, std::nextafter(x, 10)), i);
  }
  EXPECT_EQ(lattice.cell_of(0, -1e300), 0);
  EXPECT_EQ(lattice.cell_of(0, 1e300), 7);
}

}  // namespace
}  // namespace tetproof::reference
