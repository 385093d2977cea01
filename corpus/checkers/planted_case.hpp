// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes that a checker is asked about: each kind of defect in several sound meshes, and sound ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "corpus/plant.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// What the rows of the matrix are called: "sound", then the ids of all kinds, or of those in `wanted`.
/// InputError if `wanted` has an unknown one.
std::vector<std::string> checked_kinds(const std::vector<std::string>& wanted = {});

/// A mesh, and what is known about it.
struct PlantedCase {
  std::uint64_t index = 0;
  std::string kind;     ///< "sound": nothing is planted
  std::string ground;   ///< the mesh in which it is planted: "block", "ball far"
  bool planted = true;  ///< false: no place was found; there is no mesh
  TetMesh mesh{};
  Expected expected = Expected::sound;
  TetMesh before{};  ///< the sound mesh
};

/// Case `index` of `seed`: the same on every machine. Case k is of kind k modulo the number of kinds.
PlantedCase planted_case(const std::vector<std::string>& kinds, std::uint64_t seed, std::uint64_t index);

/// The boundary of a sound mesh, outward.
TriangleSurface boundary_of(const TetMesh& mesh);

/// Whether two meshes have the same boundary, by coordinates. Only then is a mesh that is sound by itself
/// also sound against the surface of the other one.
bool same_boundary(const TetMesh& a, const TetMesh& b);

}  // namespace tetproof::corpus
