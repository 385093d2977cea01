// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the rings of triangles that go around a handle: cycles of triangles that do not separate the surface.
#include <algorithm>

#include "corpus/generators/random.hpp"
#include "corpus/shrink/patches.hpp"
#include "verify/triangles/edges.hpp"

namespace tetproof::corpus {
namespace {

constexpr int roots = 24;               // of the trees whose cycles are looked at
constexpr int most_of_a_root = 8;       // rings: the next roots may find shorter ones elsewhere
constexpr std::size_t most_rings = 60;  // that are returned

// A tree of shortest paths across edges.
struct Tree {
  std::vector<Index> parent, depth;
};

Tree tree_from(Index root, const std::vector<verify::Side>& mate) {
  const std::size_t n = mate.size() / 3;
  Tree tree{std::vector<Index>(n, -1), std::vector<Index>(n, -1)};
  std::vector<Index> queue{root};
  tree.depth[root] = 0;
  for (std::size_t at = 0; at < queue.size(); ++at)
    for (int c = 0; c < 3; ++c) {
      const Index t = queue[at], other = mate[3 * t + c] / 3;
      if (tree.depth[other] >= 0) continue;
      tree.depth[other] = tree.depth[t] + 1;
      tree.parent[other] = t;
      queue.push_back(other);
    }
  return tree;
}

// The cycle that the edge between triangles a and b closes in the tree, ascending.
Patch cycle(const Tree& tree, Index a, Index b) {
  Patch ring;
  while (a != b) {
    Index& deeper = tree.depth[a] >= tree.depth[b] ? a : b;
    ring.push_back(deeper);
    deeper = tree.parent[deeper];
  }
  ring.push_back(a);
  std::sort(ring.begin(), ring.end());
  return ring;
}

// Whether the triangles are a ring with two borders: V - E + F = 0. (The triangles around a vertex are a
// cycle, too, but a disk.)
bool is_ring(const Patch& cycle, const TriangleSurface& surface, const std::vector<verify::Side>& mate) {
  std::vector<Index> vertices;
  std::ptrdiff_t inner_sides = 0;
  for (const Index t : cycle)
    for (int c = 0; c < 3; ++c) {
      vertices.push_back(surface.triangles[t][c]);
      inner_sides += std::binary_search(cycle.begin(), cycle.end(), mate[3 * t + c] / 3);
    }
  std::sort(vertices.begin(), vertices.end());
  const auto v = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  const auto f = static_cast<std::ptrdiff_t>(cycle.size()), e = 3 * f - inner_sides / 2;
  return v - e + f == 0;
}

// Whether the rest of the ring's part is connected, so that the ring goes around a handle.
bool leaves_rest_connected(const Patch& ring, const verify::Sheets& sheets,
                           const std::vector<verify::Side>& mate) {
  const std::size_t n = mate.size() / 3;
  std::vector<std::uint8_t> seen(n, 0);
  for (const Index t : ring) seen[t] = 1;
  const Index part = sheets.of_triangle[ring.front()];
  std::size_t left = static_cast<std::size_t>(sheets.sheets[part].triangles) - ring.size();
  std::vector<Index> queue;
  for (Index t = 0; t < static_cast<Index>(n) && queue.empty(); ++t)
    if (!seen[t] && sheets.of_triangle[t] == part) seen[t] = 1, queue.push_back(t);
  for (std::size_t at = 0; at < queue.size(); ++at, --left)
    for (int c = 0; c < 3; ++c) {
      const Index other = mate[3 * queue[at] + c] / 3;
      if (!seen[other]) seen[other] = 1, queue.push_back(other);
    }
  return left == 0 && !queue.empty();
}

}  // namespace

std::vector<Patch> handle_rings(const TriangleSurface& surface, std::uint64_t seed) {
  const auto edges = verify::match_edges(surface.triangles, surface.vertices.size());
  const auto sheets = verify::find_sheets(surface.triangles, edges.mate);
  Random random(seed);
  std::vector<Patch> rings;
  for (std::size_t part = 0; part < sheets.sheets.size(); ++part) {
    if (sheets.sheets[part].genus() == 0) continue;
    std::vector<Index> own;
    for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t)
      if (sheets.of_triangle[t] == static_cast<Index>(part)) own.push_back(t);
    for (int root = 0; root < roots; ++root) {
      const Tree tree = tree_from(own[random.below(static_cast<int>(own.size()))], edges.mate);
      std::vector<Patch> cycles;
      for (const Index t : own)
        for (int c = 0; c < 3; ++c) {
          const Index other = edges.mate[3 * t + c] / 3;
          if (t < other && tree.parent[t] != other && tree.parent[other] != t)
            cycles.push_back(cycle(tree, t, other));
        }
      std::sort(cycles.begin(), cycles.end(), [](const Patch& a, const Patch& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
      });
      int kept = 0;
      for (Patch& ring : cycles) {
        if (!is_ring(ring, surface, edges.mate) || !leaves_rest_connected(ring, sheets, edges.mate)) continue;
        rings.push_back(std::move(ring));
        if (++kept == most_of_a_root) break;
      }
    }
  }
  std::sort(rings.begin(), rings.end(), [](const Patch& a, const Patch& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  rings.erase(std::unique(rings.begin(), rings.end()), rings.end());
  if (rings.size() > most_rings) rings.resize(most_rings);
  return rings;
}

}  // namespace tetproof::corpus
