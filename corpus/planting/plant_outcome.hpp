// SPDX-License-Identifier: GPL-3.0-or-later
// What a planting changed, and what of the mesh that concerns. Internal.
#pragma once

#include <vector>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {

/// What differs from the sound mesh; the copy's removed tetrahedra are taken out.
struct Outcome {
  TetMesh mesh;
  std::vector<Index> changed;         ///< tetrahedra that are new, name other vertices or have moved ones
  std::vector<Index> tets, vertices;  ///< as in Planted
  std::vector<Index> origins;         ///< of `tets`: their positions in the copy
  bool anything = false;
};

Outcome outcome(const Site& s);

/// All vertices of what a planting concerned, of what lies where it added something, and two rings more.
std::vector<std::uint8_t> taken_by(const Site& s);

/// Whether nothing of the one place is near the other.
bool apart(const TetMesh& mesh, const PlantedRoot& one, const PlantedRoot& other);

}  // namespace tetproof::corpus
