// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/planting/ground_meshes.hpp"

#include "corpus/block_mesh.hpp"

namespace tetproof::corpus {

// Between points with integer coordinates midpoints are exact; in jittered meshes they are rounded.
std::vector<GroundMesh> ground_meshes(const PlantKind& kind) {
  const GroundMesh cell{"cell", block_mesh({2, 1, 1})}, block{"block", block_mesh({2, 2, 2})},
      jittered{"jittered", block_mesh({2, 2, 2}, 0.1, 3)}, ball{"ball", ball_mesh(2, 0.1, 3)},
      onion{"onion", ball_mesh(3, 0.1, 3)};
  if (!kind.mutate)  // two kinds
    return {{"bar", block_mesh({10, 1, 1})},
            {"beam", block_mesh({7, 2, 2})},
            {"jittered beam", block_mesh({8, 3, 3}, 0.1)}};
  if (kind.has("whole")) return {cell, {"octahedron", ball_mesh(1, 0.1, 3)}, ball, block};
  if (kind.has("rounding") || kind.has("random")) return {jittered, ball, onion, block};
  return {block, ball, onion, jittered};
}

const std::array<Place, 3>& places() {
  static const std::array<Place, 3> all{
      {{"", 1, {0, 0, 0}}, {"far", 1, {1e6, -0.9e6, 1.1e6}}, {"tiny", 1e-9, {0, 0, 0}}}};
  return all;
}

}  // namespace tetproof::corpus
