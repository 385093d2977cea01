// SPDX-License-Identifier: GPL-3.0-or-later
// What the groups of checks hand on while a mesh is judged. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "verify/boundary.hpp"
#include "verify/suspects.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {

struct MeshVolumes;

struct Judgement {
  const TetMesh& mesh;
  const Options& options;
  std::array<bool, check_count> asked{};  ///< not skipped by the options
  std::vector<std::uint8_t> excluded{};   ///< tetrahedra that geometry cannot be asked about; empty: none
  Boundary boundary{};
  std::vector<Suspects> suspects = std::vector<Suspects>(check_count);
  Report report{};

  bool wants(Check check) const { return asked[static_cast<std::size_t>(check)]; }
  Suspects& operator[](Check check) { return suspects[static_cast<std::size_t>(check)]; }
};

/// index-range, finite-coordinates, repeated-vertex, duplicate-point, unused-point; decides what is excluded.
void check_numbers_and_points(Judgement& judgement);
/// inverted, flat, duplicate-tet, face-shared-thrice, face-orientation; finds the boundary.
void check_tetrahedra(Judgement& judgement);
/// cavity, boundary-nonmanifold-edge and -vertex, boundary-self-intersection, overlap; the mesh's components
/// and genus. The largest `right_cavities` cavities are as they should be.
void check_boundary(Judgement& judgement, const MeshVolumes& volumes, std::size_t right_cavities);

}  // namespace tetproof::verify
