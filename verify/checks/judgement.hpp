// SPDX-License-Identifier: GPL-3.0-or-later
// What the groups of checks hand on while a mesh is judged. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "verify/checks/conformity.hpp"
#include "verify/checks/suspects.hpp"
#include "verify/mesh/boundary.hpp"
#include "verify/mesh/cracks.hpp"
#include "verify/triangles/intersections.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {

struct MeshVolumes;

struct Judgement {
  const TetMesh& mesh;
  const Options& options;
  std::array<bool, check_count> asked{};  ///< not skipped by the options
  std::vector<std::uint8_t> excluded{};   ///< tetrahedra that geometry cannot be asked about; empty: none
  std::vector<std::vector<Index>> same_place{};  ///< points with equal coordinates; ascending
  std::int64_t boundary_faces = 0;               ///< of the mesh as it is written
  Boundary boundary{};                           ///< with cracks closed
  std::vector<std::array<FaceId, 2>> folded{};   ///< with cracks closed: two at one place, both on one side
  Intersections meetings{};                      ///< of the boundary's triangles
  Conformity conformity{};
  std::vector<Suspects> suspects = std::vector<Suspects>(check_count);
  Report report{};

  bool wants(Check check) const { return asked[static_cast<std::size_t>(check)]; }
  void skip(std::initializer_list<Check> checks) {
    for (const Check check : checks) asked[static_cast<std::size_t>(check)] = false;
  }
  Suspects& operator[](Check check) { return suspects[static_cast<std::size_t>(check)]; }
};

/// index-range, finite-coordinates, repeated-vertex, duplicate-point, unused-point; decides what is excluded.
void check_numbers_and_points(Judgement& judgement);
/// inverted, flat, duplicate-tet, face-shared-thrice, face-orientation, crack; finds the boundary.
void check_tetrahedra(Judgement& judgement);
/// crack; the mesh with its cracks closed.
Cracks check_cracks(Judgement& judgement, const FaceMatching& faces);

/// Of pairs of triangles that meet or are near so many are kept; the others are counted.
inline constexpr std::size_t most_pairs = 100000;
/// Finds what of the boundary meets, or is near.
void find_meetings(Judgement& judgement, const Near& near, const std::vector<std::uint8_t>& degenerate);
/// hanging-node, crossed-diagonal, near-contact. `covered`: see `find_conformity`.
void check_conformity(Judgement& judgement, const Near& near, const std::vector<Index>& covered);
/// cavity, boundary-nonmanifold-edge and -vertex, boundary-self-intersection, overlap; the mesh's components
/// and genus. The largest `right_cavities` cavities are as they should be.
void check_boundary(Judgement& judgement, const MeshVolumes& volumes, std::size_t right_cavities);

}  // namespace tetproof::verify
