// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity of triangles: the triangles at each edge, connected sheets, and the fans at each vertex.
// Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

using Triangle = std::array<Index, 3>;

/// Side k of triangle t, from its vertex k to the next: 3 t + k.
using Side = std::int32_t;
inline constexpr Side no_side = -1;
inline Index from(std::span<const Triangle> triangles, Side s) {
  return triangles[static_cast<std::size_t>(s / 3)][static_cast<std::size_t>(s % 3)];
}
inline Index to(std::span<const Triangle> triangles, Side s) {
  return triangles[static_cast<std::size_t>(s / 3)][static_cast<std::size_t>((s + 1) % 3)];
}

/// All lists are sorted by the edge's lower vertex, then by its higher vertex.
struct EdgeMatching {
  /// For each side: the other side, if its edge has exactly two triangles; else no_side.
  std::vector<Side> mate;
  std::vector<Side> open;  ///< edges of one triangle
  /// Edges of two triangles that both run along the edge in the same direction.
  std::vector<std::array<Side, 2>> same_direction;
  std::vector<std::vector<Side>> nonmanifold;  ///< edges of three or more triangles
};

/// Matches the sides of all triangles except those marked in `excluded` (empty: none). Each of them must name
/// three different vertices in [0, vertices).
EdgeMatching match_edges(std::span<const Triangle> triangles, std::size_t vertices,
                         const std::vector<std::uint8_t>& excluded = {});

/// A set of triangles that are connected through mates. A vertex counts once for each fan of triangles around
/// it.
struct Sheet {
  Index first_triangle = 0;
  std::int64_t triangles = 0, vertices = 0, open_sides = 0;
  /// Euler's characteristic V - E + F = 2 - 2 genus of a closed, oriented sheet.
  std::int64_t euler() const { return vertices - (3 * triangles + open_sides) / 2 + triangles; }
  std::int64_t genus() const { return (2 - euler()) / 2; }
};

struct Sheets {
  std::vector<Index> of_triangle;  ///< a position in `sheets`; -1 for an excluded triangle
  std::vector<Sheet> sheets;       ///< sorted by their lowest triangle
  /// The vertex of every fan, ascending. A vertex with two fans is listed twice.
  std::vector<Index> vertices_of_fans;
};

/// Finds the sheets and fans that `mate` connects, without the triangles marked in `excluded` (empty: none).
Sheets find_sheets(std::span<const Triangle> triangles, const std::vector<Side>& mate,
                   const std::vector<std::uint8_t>& excluded = {});

/// The vertices that an ascending list names twice or more, each once.
std::vector<Index> repeated(const std::vector<Index>& ascending);

}  // namespace tetproof::verify
