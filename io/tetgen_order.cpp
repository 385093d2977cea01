// SPDX-License-Identifier: GPL-3.0-or-later
// Where TetGen puts the nodes between corners, found by where they are: it depends on the version and on
// switches.
#include <algorithm>
#include <array>

#include "io/tetgen_parts.hpp"

namespace tetproof::io {
namespace {

using Edge = std::array<int, 2>;
// The edges of a tetrahedron and of a triangle, in the order in which a document has their middle nodes.
constexpr Edge edges[6] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};

bool in_the_middle(const Document& document, Index a, Index b, Index m) {
  if (a < 0 || b < 0 || m < 0) return false;
  const Eigen::Vector3d &p = document.points[a], &q = document.points[b];
  return (document.points[m] - (p / 2 + q / 2)).stableNorm() <= 1e-6 * (q - p).stableNorm();
}

// Whether node `place[k]` between the corners is in the middle of edge k, for all of them.
template <std::size_t Edges>
bool fits(const Document& document, const Index* corners, const Index* between,
          const std::array<int, Edges>& place) {
  for (std::size_t k = 0; k < Edges; ++k)
    if (!in_the_middle(document, corners[edges[k][0]], corners[edges[k][1]], between[place[k]])) return false;
  return true;
}

}  // namespace

// With its switch for the opposite orientation TetGen exchanges corners 0 and 1, but nothing between corners.
void order_tetrahedra_nodes(const TetgenElements& tets, Document& document) {
  if (tets.nodes_each != 10 || tets.count == 0) return;
  constexpr std::array<int, 6> usual{0, 1, 2, 3, 4, 5}, reversed{0, 2, 1, 5, 4, 3};
  Index* const all = document.connectivity.data() + tets.nodes;
  for (std::size_t t = 0; t < tets.count; ++t) {
    const Index* tet = all + 10 * t;
    if (fits(document, tet, tet + 4, usual) || !fits(document, tet, tet + 4, reversed)) return;
  }
  for (std::size_t t = 0; t < tets.count; ++t) {
    Index* const tet = all + 10 * t;
    std::swap(tet[5], tet[6]);
    std::swap(tet[7], tet[9]);
  }
}

// With -f TetGen 1.5 lists the node opposite to each corner, without it the node behind each corner.
void order_face_nodes(const TetgenElements& faces, const TetgenElements& tets, Document& document) {
  if (faces.nodes_each != 6 || faces.count == 0) return;
  // The edge that a node is in the middle of, as the tetrahedra say, which may be curved.
  std::vector<std::array<Index, 2>> edge_of;
  if (tets.nodes_each == 10 && tets.count > 0) {
    edge_of.assign(document.points.size(), {-1, -1});
    const Index* tet = document.connectivity.data() + tets.nodes;
    for (std::size_t t = 0; t < tets.count; ++t, tet += 10)
      for (int k = 0; k < 6; ++k)
        if (tet[4 + k] >= 0) {
          const auto [low, high] = std::minmax(tet[edges[k][0]], tet[edges[k][1]]);
          edge_of[static_cast<std::size_t>(tet[4 + k])] = {low, high};
        }
  }
  const auto between = [&](Index a, Index b, Index m) {
    if (edge_of.empty()) return in_the_middle(document, a, b, m);
    const auto [low, high] = std::minmax(a, b);
    return m >= 0 && edge_of[static_cast<std::size_t>(m)] == std::array<Index, 2>{low, high};
  };
  Index* const all = document.connectivity.data() + faces.nodes;
  for (std::size_t f = 0; f < faces.count; ++f) {
    const Index* face = all + 6 * f;
    const auto fits = [&](int shift) {  // node k between the corners is in the middle of edge k + shift
      for (int k = 0; k < 3; ++k) {
        const int edge = (k + shift) % 3;
        if (!between(face[edge], face[(edge + 1) % 3], face[3 + k])) return false;
      }
      return true;
    };
    if (fits(0) || !fits(1)) return;
  }
  for (std::size_t f = 0; f < faces.count; ++f) {
    Index* const face = all + 6 * f;
    std::rotate(face + 3, face + 5, face + 6);
  }
}

}  // namespace tetproof::io
