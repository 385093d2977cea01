// SPDX-License-Identifier: GPL-3.0-or-later
// The small sound meshes in which kinds of defects are planted, and the places where they lie. Not installed.
#pragma once

#include <array>
#include <vector>

#include "corpus/plant.hpp"

namespace tetproof::corpus {

struct GroundMesh {
  const char* name;
  TetMesh mesh;
};

/// The meshes in which a kind may be planted, those that suit it best first.
std::vector<GroundMesh> ground_meshes(const PlantKind& kind);

/// What `moved` in corpus/block_mesh.hpp takes.
struct Place {
  const char* name;  ///< "", "far", "tiny"
  double scale;
  Eigen::Vector3d shift;
};

/// As the meshes are; far from the origin; and tiny.
const std::array<Place, 3>& places();

}  // namespace tetproof::corpus
