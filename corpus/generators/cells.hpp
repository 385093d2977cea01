// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a body that consists of cells between axis-parallel planes. Its faces, edges and corners can
// coincide with those of a lattice.
#pragma once

#include <array>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

struct CellBody {
  std::array<std::vector<double>, 3> planes;  ///< ascending, along x, y, z
  std::vector<char> solid;                    ///< for each cell; x runs fastest, then y, then z

  CellBody(std::vector<double> x, std::vector<double> y, std::vector<double> z, bool full)
      : planes{std::move(x), std::move(y), std::move(z)}, solid(cells(0) * cells(1) * cells(2), full) {}
  std::size_t cells(int axis) const { return planes[axis].size() - 1; }
  char& at(std::size_t i, std::size_t j, std::size_t k) { return solid[i + cells(0) * (j + cells(1) * k)]; }
  char at(std::size_t i, std::size_t j, std::size_t k) const {
    return solid[i + cells(0) * (j + cells(1) * k)];
  }
};

/// The boundary of the solid cells, oriented outward. Each side of a cell is cut into n x n squares of two
/// triangles. The boundary is a 2-manifold if, around every edge and every vertex, the solid cells are
/// connected through common sides, and so are the empty ones.
TriangleSurface boundary(const CellBody& body, int n = 1);

/// The sum of the volumes of the solid cells [length^3].
double volume(const CellBody& body);

}  // namespace tetproof::corpus
