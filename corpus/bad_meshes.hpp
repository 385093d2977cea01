// SPDX-License-Identifier: GPL-3.0-or-later
// The zoo of bad meshes in corpus/bad-meshes: every kind of defect, planted in a small mesh.
#pragma once

#include <string>
#include <vector>

#include "corpus/plant.hpp"

namespace tetproof::corpus {

struct BadMesh {
  std::string name;                ///< of its files
  const PlantKind* kind;           ///< null: nothing is planted
  std::vector<std::string> flags;  ///< the kind's, and where it lies: "far", "tiny"
  Planted planted;
};

/// All of them: the same on every machine.
std::vector<BadMesh> bad_meshes();

/// index.json: one entry a line, numbers as in the files, from 1.
std::string bad_meshes_index(const std::vector<BadMesh>& meshes);

/// Writes NAME.msh (Gmsh's 2.2, text), NAME.node and NAME.ele (TetGen) of each, and index.json.
void write_bad_meshes(const std::string& folder, const std::vector<BadMesh>& meshes);

}  // namespace tetproof::corpus
