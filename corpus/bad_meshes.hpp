// SPDX-License-Identifier: GPL-3.0-or-later
// The collection of bad meshes in corpus/bad-meshes: every kind of defect, planted in a small mesh.
#pragma once

#include <string>
#include <vector>

#include "corpus/plant.hpp"

namespace tetproof::corpus {

struct BadMesh {
  std::string name;                ///< of its files, without the ending
  const PlantKind* kind;           ///< null: a sound mesh in which nothing is planted
  std::vector<std::string> flags;  ///< those of the kind, and "far" or "tiny" for its place
  Planted planted;
};

/// All bad meshes: the same on every machine.
std::vector<BadMesh> bad_meshes();

/// The text of index.json: one entry a line. Points and tetrahedra are numbered as in the files, from 1.
std::string bad_meshes_index(const std::vector<BadMesh>& meshes);

/// Writes NAME.msh (Gmsh 2.2, text), NAME.node and NAME.ele (TetGen) for each mesh, and index.json.
void write_bad_meshes(const std::string& folder, const std::vector<BadMesh>& meshes);

}  // namespace tetproof::corpus
