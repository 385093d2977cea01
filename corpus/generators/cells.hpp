// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a body made of the cells between axis-parallel planes: faces, edges and corners where a
// lattice has its own.
#pragma once

#include <array>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

struct CellBody {
  std::array<std::vector<double>, 3> planes;  ///< ascending, along x, y, z
  std::vector<char> solid;  ///< x fastest, then y, then z; one less each way than there are planes

  CellBody(std::vector<double> x, std::vector<double> y, std::vector<double> z, bool full)
      : planes{std::move(x), std::move(y), std::move(z)}, solid(cells(0) * cells(1) * cells(2), full) {}
  std::size_t cells(int axis) const { return planes[axis].size() - 1; }
  char& at(std::size_t i, std::size_t j, std::size_t k) { return solid[i + cells(0) * (j + cells(1) * k)]; }
  char at(std::size_t i, std::size_t j, std::size_t k) const {
    return solid[i + cells(0) * (j + cells(1) * k)];
  }
};

/// The boundary, outward, each cell's side cut into n x n squares of two triangles. It is a 2-manifold if
/// cells that share an edge or a vertex are joined, or separated, through sides around it.
TriangleSurface boundary(const CellBody& body, int n = 1);

/// The sum of the solid cells' volumes [length^3].
double volume(const CellBody& body);

}  // namespace tetproof::corpus
