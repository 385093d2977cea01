// SPDX-License-Identifier: GPL-3.0-or-later
// The changes that a planting has made, and the parts of the mesh that they concern. Internal.
#pragma once

#include <vector>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {

/// The mutated mesh without its removed tetrahedra, and its differences from the sound mesh.
struct Outcome {
  TetMesh mesh;
  std::vector<Index> changed;         ///< tetrahedra that are new, name other vertices or have moved vertices
  std::vector<Index> tets, vertices;  ///< as in `Planted`
  std::vector<Index> origins;         ///< for each of `tets`, its position in the copy
  bool anything = false;              ///< whether there is any difference
};

Outcome outcome(const Site& s);

/// The vertices that a second planting must not use if it is to be far from the first one, as a flag for each
/// point: the vertices of the tetrahedra that the first one concerned, of those in the bounding box of its
/// changes, and of two more rings of tetrahedra around these.
std::vector<std::uint8_t> taken_by(const Site& s);

/// Whether the bounding boxes of two roots are disjoint.
bool apart(const TetMesh& mesh, const PlantedRoot& one, const PlantedRoot& other);

}  // namespace tetproof::corpus
