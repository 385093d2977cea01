// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/fuzz/cell_topology.hpp"

#include <array>
#include <vector>

namespace tetproof::corpus {
namespace {

// Whether those of the eight cells around a corner whose state is `solid` hang together. Bit k of a cell's
// number is its place along axis k.
bool hangs_together(const std::array<char, 8>& around, bool solid) {
  std::array<bool, 8> reached{};
  int wanted = 0, found = 0;
  std::vector<int> open;
  for (int cell = 0; cell < 8; ++cell)
    if ((around[cell] != 0) == solid && ++wanted == 1) open.push_back(cell), reached[cell] = true;
  while (!open.empty()) {
    const int cell = open.back();
    open.pop_back();
    ++found;
    for (int axis = 0; axis < 3; ++axis) {
      const int next = cell ^ (1 << axis);
      if ((around[next] != 0) != solid || reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
  return found == wanted;
}

// The number of sets of cells in one state that hang together. The empty ones include the outside.
std::int64_t regions(const CellBody& body, bool solid) {
  // One layer of empty cells around the body is the outside.
  const std::array<std::size_t, 3> n{body.cells(0) + 2, body.cells(1) + 2, body.cells(2) + 2};
  const std::array<std::size_t, 3> stride{1, n[0], n[0] * n[1]};
  std::vector<char> state(n[0] * n[1] * n[2], 0);
  for (std::size_t k = 0; k < body.cells(2); ++k)
    for (std::size_t j = 0; j < body.cells(1); ++j)
      for (std::size_t i = 0; i < body.cells(0); ++i)
        state[i + 1 + stride[1] * (j + 1) + stride[2] * (k + 1)] = body.at(i, j, k) != 0;
  std::int64_t count = 0;
  std::vector<std::size_t> open;
  constexpr char done = 2;
  for (std::size_t start = 0; start < state.size(); ++start) {
    if (state[start] != static_cast<char>(solid)) continue;
    ++count;
    open.assign(1, start);
    state[start] = done;
    while (!open.empty()) {
      const std::size_t cell = open.back();
      open.pop_back();
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t place = cell / stride[axis] % n[axis];
        for (const bool up : {false, true}) {
          if (up ? place + 1 == n[axis] : place == 0) continue;
          const std::size_t next = up ? cell + stride[axis] : cell - stride[axis];
          if (state[next] != static_cast<char>(solid)) continue;
          state[next] = done;
          open.push_back(next);
        }
      }
    }
  }
  return count;
}

}  // namespace

void fill_to_manifold(CellBody& body) {
  const auto solid = [&](std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k) -> char* {
    const auto inside = [&](std::ptrdiff_t at, int axis) {
      return at >= 0 && at < static_cast<std::ptrdiff_t>(body.cells(axis));
    };
    return inside(i, 0) && inside(j, 1) && inside(k, 2) ? &body.at(i, j, k) : nullptr;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k <= body.cells(2); ++k)
      for (std::size_t j = 0; j <= body.cells(1); ++j)
        for (std::size_t i = 0; i <= body.cells(0); ++i) {
          std::array<char*, 8> cells;
          std::array<char, 8> around;
          for (int c = 0; c < 8; ++c) {
            const auto at = [c](std::size_t corner, int axis) {
              return static_cast<std::ptrdiff_t>(corner) - 1 + (c >> axis & 1);
            };
            cells[c] = solid(at(i, 0), at(j, 1), at(k, 2));
            around[c] = cells[c] ? *cells[c] : 0;
          }
          if (hangs_together(around, true) && hangs_together(around, false)) continue;
          changed = true;
          for (int c = 0; c < 8; ++c)
            if (cells[c] && !*cells[c]) {
              *cells[c] = 1;
              break;
            }
        }
  }
}

Shape cell_shape(const CellBody& body) {
  Shape shape{boundary(body), {}, {}, {}};
  // Regions of solid and of empty cells are the nodes of a graph, sheets of the boundary its edges. Space has
  // no loops that pass a sheet once: the graph is a tree, and has one edge less than nodes.
  const std::int64_t empty = regions(body, false), sheets = regions(body, true) + empty - 1;
  shape.components = sheets;
  shape.cavities = empty - 1;
  // Euler: V - E + F = 2 (sheets - genus), where 2 E = 3 F.
  const auto V = static_cast<std::int64_t>(shape.surface.vertices.size()),
             F = static_cast<std::int64_t>(shape.surface.triangles.size());
  shape.genus = sheets - (V - F / 2) / 2;
  return shape;
}

}  // namespace tetproof::corpus
