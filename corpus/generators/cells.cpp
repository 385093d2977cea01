// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/generators/cells.hpp"

#include <algorithm>
#include <cstdint>

namespace tetproof::corpus {

TriangleSurface boundary(const CellBody& body, int n) {
  // The nodes of the refined planes are numbered. Those that are used become vertices, in ascending order.
  std::array<std::uint64_t, 3> stride{1, body.cells(0) * n + 1, 0};
  stride[2] = stride[1] * (body.cells(1) * n + 1);
  std::vector<std::array<std::uint64_t, 4>> squares;  // anticlockwise seen from outside
  std::array<std::size_t, 3> c;
  for (c[2] = 0; c[2] < body.cells(2); ++c[2])
    for (c[1] = 0; c[1] < body.cells(1); ++c[1])
      for (c[0] = 0; c[0] < body.cells(0); ++c[0]) {
        if (!body.at(c[0], c[1], c[2])) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<std::size_t, 3> next = c;
            next[axis] += side ? 1 : -1;  // below 0 it wraps around to a large number
            if (next[axis] < body.cells(axis) && body.at(next[0], next[1], next[2])) continue;
            const int u = (axis + (side ? 1 : 2)) % 3, v = (axis + (side ? 2 : 1)) % 3;
            const std::uint64_t start =
                n * (c[0] * stride[0] + c[1] * stride[1] + c[2] * stride[2] + side * stride[axis]);
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const std::uint64_t a = start + i * stride[u] + j * stride[v];
                squares.push_back({a, a + stride[u], a + stride[u] + stride[v], a + stride[v]});
              }
          }
      }

  std::vector<std::uint64_t> nodes;
  nodes.reserve(4 * squares.size());
  for (const auto& square : squares) nodes.insert(nodes.end(), square.begin(), square.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto number = [&](std::uint64_t node) {
    return static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  };

  TriangleSurface surface;
  surface.vertices.reserve(nodes.size());
  for (const std::uint64_t node : nodes) {
    const std::array<std::uint64_t, 3> fine{node % stride[1], node % stride[2] / stride[1], node / stride[2]};
    Eigen::Vector3d x;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint64_t cell = fine[axis] / n, part = fine[axis] % n;
      x[axis] = body.planes[axis][cell];
      if (part > 0) x[axis] += (body.planes[axis][cell + 1] - x[axis]) * (static_cast<double>(part) / n);
    }
    surface.vertices.push_back(x);
  }
  surface.triangles.reserve(2 * squares.size());
  for (const auto& square : squares) {
    const Index a = number(square[0]), b = number(square[1]), c2 = number(square[2]), d = number(square[3]);
    surface.triangles.push_back({a, b, c2});
    surface.triangles.push_back({a, c2, d});
  }
  return surface;
}

double volume(const CellBody& body) {
  const auto width = [&](int axis, std::size_t i) { return body.planes[axis][i + 1] - body.planes[axis][i]; };
  double sum = 0;
  for (std::size_t k = 0; k < body.cells(2); ++k)
    for (std::size_t j = 0; j < body.cells(1); ++j)
      for (std::size_t i = 0; i < body.cells(0); ++i)
        if (body.at(i, j, k)) sum += width(0, i) * width(1, j) * width(2, k);
  return sum;
}

}  // namespace tetproof::corpus
