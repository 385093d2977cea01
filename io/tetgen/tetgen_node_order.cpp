// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the order of TetGen's nodes between corners.
#include "io/tetgen/tetgen_node_order.hpp"

#include <algorithm>
#include <array>

namespace tetproof::io {
namespace {

using Edge = std::array<int, 2>;
// The edges of a tetrahedron (the first three: of a triangle), in the order of their middle nodes in a
// document.
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

bool is_usual(const Document& document, const Index* tet) {
  return fits<6>(document, tet, tet + 4, {0, 1, 2, 3, 4, 5});
}
bool is_turned(const Document& document, const Index* tet) {
  return fits<6>(document, tet, tet + 4, {0, 2, 1, 5, 4, 3});
}

// For each node the edge that has it as its middle node, according to the tetrahedra, which may be curved.
std::vector<std::array<Index, 2>> edges_of(const Document& document, const std::vector<TetgenRun>& tets) {
  std::vector<std::array<Index, 2>> edge_of(document.points.size(), {-1, -1});
  for (const TetgenRun& run : tets)
    for (std::size_t t = 0; t < run.count; ++t)
      for (int k = 0; k < 6; ++k) {
        const Index* tet = run.nodes + 10 * t;
        if (tet[4 + k] < 0) continue;
        const auto [low, high] = std::minmax(tet[edges[k][0]], tet[edges[k][1]]);
        edge_of[static_cast<std::size_t>(tet[4 + k])] = {low, high};
      }
  return edge_of;
}

template <class Yes>
bool all_and_any(const std::vector<TetgenRun>& runs, std::size_t each, const Yes& yes) {
  std::size_t count = 0;
  for (const TetgenRun& run : runs)
    for (std::size_t e = 0; e < run.count; ++e, ++count)
      if (!yes(run.nodes + each * e)) return false;
  return count > 0;
}

std::vector<TetgenRun> runs_of(const TetgenElements& elements, const Document& document) {
  return {{document.connectivity.data() + elements.nodes, elements.count}};
}

}  // namespace

bool are_turned(const Document& document, const std::vector<TetgenRun>& tets) {
  return all_and_any(tets, 10,
                     [&](const Index* tet) { return !is_usual(document, tet) && is_turned(document, tet); });
}

bool have_nodes_opposite_corners(const Document& document, const std::vector<TetgenRun>& faces,
                                 const std::vector<TetgenRun>& tets) {
  std::vector<std::array<Index, 2>> edge_of;  // filled when the first face asks
  const auto between = [&](Index a, Index b, Index m) {
    if (tets.empty()) return in_the_middle(document, a, b, m);
    if (edge_of.empty()) edge_of = edges_of(document, tets);
    const auto [low, high] = std::minmax(a, b);
    return m >= 0 && edge_of[static_cast<std::size_t>(m)] == std::array<Index, 2>{low, high};
  };
  return all_and_any(faces, 6, [&](const Index* face) {
    const auto fits = [&](int shift) {  // node k between the corners is in the middle of edge k + shift
      for (int k = 0; k < 3; ++k) {
        const int edge = (k + shift) % 3;
        if (!between(face[edge], face[(edge + 1) % 3], face[3 + k])) return false;
      }
      return true;
    };
    return !fits(0) && fits(1);
  });
}

void order_tetrahedra_nodes(const TetgenElements& tets, Document& document) {
  if (tets.nodes_each != 10 || !are_turned(document, runs_of(tets, document))) return;
  Index* const all = document.connectivity.data() + tets.nodes;
  for (std::size_t t = 0; t < tets.count; ++t) {
    Index* const tet = all + 10 * t;
    std::swap(tet[5], tet[6]);
    std::swap(tet[7], tet[9]);
  }
}

void order_face_nodes(const TetgenElements& faces, const TetgenElements& tets, Document& document) {
  if (faces.nodes_each != 6) return;
  std::vector<TetgenRun> of_second_order;
  if (tets.nodes_each == 10 && tets.count > 0) of_second_order = runs_of(tets, document);
  if (!have_nodes_opposite_corners(document, runs_of(faces, document), of_second_order)) return;
  Index* const all = document.connectivity.data() + faces.nodes;
  for (std::size_t f = 0; f < faces.count; ++f) {
    Index* const face = all + 6 * f;
    std::rotate(face + 3, face + 5, face + 6);
  }
}

}  // namespace tetproof::io
