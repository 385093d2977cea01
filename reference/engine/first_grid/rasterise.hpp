// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice cells and lattice lines that a triangle can touch, and a few more. They are found in time that
// grows with the size of the triangle.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "reference/engine/first_grid/lattice.hpp"

namespace tetproof::reference {

using Triangle = std::array<Eigen::Vector3d, 3>;

inline Triangle corners(const TriangleSurface& surface, std::size_t t) {
  const auto& [a, b, c] = surface.triangles[t];
  return {surface.vertices[a], surface.vertices[b], surface.vertices[c]};
}

/// A convex polygon: a triangle clipped by at most four planes, which has at most 7 corners. Rounding can
/// make it slightly concave and give it more, so there is room for 16.
struct ClippedTriangle {
  std::array<Eigen::Vector3d, 16> corners;
  int size;

  /// The part with lo <= coordinate <= hi along `axis`. Its corners are rounded.
  ClippedTriangle between(int axis, double lo, double hi) const;
  std::array<double, 2> extent(int axis) const {
    std::array<double, 2> e{corners[0][axis], corners[0][axis]};
    for (int c = 1; c < size; ++c) e = {std::min(e[0], corners[c][axis]), std::max(e[1], corners[c][axis])};
    return e;
  }
};

/// An upper bound of the error of any clipped corner [length]. Clipping interpolates twice between the
/// corners of a triangle inside the lattice, each time with a few rounding errors of at most 2^-52 times the
/// largest coordinate.
inline double clipping_error(const Lattice& lattice) {
  double largest = 0;
  for (const auto& plane : lattice.planes)
    largest = std::max({largest, std::abs(plane.front()), std::abs(plane.back())});
  return 64 * std::numeric_limits<double>::epsilon() * largest;
}

/// Calls visit(i, j, k) for every cell whose closed box comes within `margin` of the triangle, and for a few
/// cells beside these. Cells are numbered from 0 to n, inclusive, along each axis: cell n is the last lattice
/// plane.
template <class Visit>
void for_each_cell(const Lattice& lattice, const Triangle& triangle, double margin, Visit visit) {
  const auto range = [&](const ClippedTriangle& part, int axis) {
    const auto [lo, hi] = part.extent(axis);
    return std::array{lattice.cell_of(axis, lo - margin), lattice.cell_of(axis, hi + margin)};
  };
  const auto slab = [&](const ClippedTriangle& part, int axis, int cell) {
    const auto& plane = lattice.planes[axis];
    const double end = cell < lattice.cells[axis] ? plane[cell + 1] : plane[cell];
    return part.between(axis, plane[cell] - margin, end + margin);
  };
  const ClippedTriangle whole{{triangle[0], triangle[1], triangle[2]}, 3};
  const auto [i0, i1] = range(whole, 0);
  const auto [j0, j1] = range(whole, 1);
  const auto [k0, k1] = range(whole, 2);
  constexpr std::int64_t few = 8;  // so few cells are visited sooner than the triangle is clipped
  if ((i1 - i0 + std::int64_t{1}) * (j1 - j0 + 1) * (k1 - k0 + 1) <= few) {
    for (int k = k0; k <= k1; ++k)
      for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i) visit(i, j, k);
    return;
  }
  for (int k = k0; k <= k1; ++k) {
    const ClippedTriangle layer = k0 == k1 ? whole : slab(whole, 2, k);
    if (layer.size == 0) continue;
    const auto [layer_j0, layer_j1] = range(layer, 1);
    for (int j = layer_j0; j <= layer_j1; ++j) {
      const ClippedTriangle row = layer_j0 == layer_j1 ? layer : slab(layer, 1, j);
      if (row.size == 0) continue;
      const auto [row_i0, row_i1] = range(row, 0);
      for (int i = row_i0; i <= row_i1; ++i) visit(i, j, k);
    }
  }
}

/// Calls visit(j, k) for every lattice line along x that comes within `margin` of the triangle's projection
/// along x, and for a few more.
template <class Visit>
void for_each_x_line(const Lattice& lattice, const Triangle& triangle, double margin, Visit visit) {
  const ClippedTriangle whole{{triangle[0], triangle[1], triangle[2]}, 3};
  const auto [y0, y1] = whole.extent(1);
  const auto& y = lattice.planes[1];
  for (int j = lattice.cell_of(1, y0 - margin); j <= lattice.cells[1] && y[j] <= y1 + margin; ++j) {
    const ClippedTriangle strip = whole.between(1, y[j] - margin, y[j] + margin);
    if (strip.size == 0) continue;
    const auto [z0, z1] = strip.extent(2);
    const auto& z = lattice.planes[2];
    for (int k = lattice.cell_of(2, z0 - margin); k <= lattice.cells[2] && z[k] <= z1 + margin; ++k)
      visit(j, k);
  }
}

}  // namespace tetproof::reference
