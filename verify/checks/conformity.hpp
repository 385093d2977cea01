// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary faces that do not match others only because a node lies on them, or because a quadrilateral is cut
// along another diagonal. Internal.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "verify/checks/interface.hpp"
#include "verify/checks/suspects.hpp"
#include "verify/triangles/intersections.hpp"

namespace tetproof::verify {

// Faces are positions in `Boundary::faces`.
struct HangingNode {
  Index vertex;
  std::vector<Index> carriers;  ///< faces on which it lies without being their vertex
  std::vector<Index> opposite;  ///< faces at it that cover the carriers from the other side
};
struct CrossedDiagonals {
  std::array<Index, 4> vertices;  ///< ascending
  std::array<Index, 4> faces;     ///< ascending
};

struct Conformity {
  std::vector<HangingNode> hanging;       ///< ascending by their vertex
  std::vector<CrossedDiagonals> crossed;  ///< ascending by their vertices

  /// The hanging node or crossed diagonal that left a face without its partner.
  std::optional<Cause> cause_of_face(Index face) const;
  /// The hanging node or crossed diagonal that makes two faces meet, or nearly meet: a node that hangs on one
  /// of them and is a vertex of the other, or the one that left the gap to which both belong.
  std::optional<Cause> cause_of_pair(const Boundary& boundary, Index s, Index t) const;

  std::vector<Contact> contacts;   ///< ascending
  std::vector<Index> gap_of_face;  ///< -1: none; empty: there are no gaps
  std::vector<Cause> cause_of_gap;
};

/// Finds hanging nodes and crossed diagonals among the contacts, folds and near pairs of `found`.
///
/// A set of faces is a gap if three things hold: nodes of some of its faces lie near others, the tetrahedra
/// lie on opposite sides, and the faces cancel once their edges are cut at the nodes. Then they cover the
/// same place. Crossed diagonals are four faces on four vertices that cancel. Either two of them fold onto
/// each other, or one is among `covered`, the faces with the mesh on their outer side: then the quadrilateral
/// is bent, and the tetrahedra overlap.
Conformity find_conformity(const TetMesh& mesh, const Boundary& boundary, const FacesAtVertices& at,
                           const Intersections& found, const Near& near, const std::vector<Index>& covered);

/// Whether two triangles that are near each other are connected by edges that are as tiny as the distance
/// between them. Then they are one place of the boundary, and not two places that nearly touch.
bool one_place(const Boundary& boundary, const FacesAtVertices& at, const Near& near, Index s, Index t);

}  // namespace tetproof::verify
