// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary faces that would match others but for a node on them or for another diagonal. Internal.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "verify/checks/suspects.hpp"
#include "verify/mesh/boundary.hpp"
#include "verify/triangles/intersections.hpp"

namespace tetproof::verify {

/// The boundary faces at every vertex, as positions in `Boundary::faces`, ascending.
class FacesAtVertices {
 public:
  FacesAtVertices(const Boundary& boundary, std::size_t points);
  std::span<const Index> operator[](Index v) const {
    return {faces_.data() + start_[v], static_cast<std::size_t>(start_[v + 1] - start_[v])};
  }

 private:
  std::vector<Index> start_, faces_;
};

// Faces are positions in `Boundary::faces`.
struct HangingNode {
  Index vertex;
  std::vector<Index> carriers;  ///< faces on which it lies without being their vertex
  std::vector<Index> opposite;  ///< faces at it that cover those from the other side
};
struct CrossedDiagonals {
  std::array<Index, 4> vertices;  ///< ascending
  std::array<Index, 4> faces;     ///< ascending
};

struct Conformity {
  std::vector<HangingNode> hanging;       ///< by their vertex
  std::vector<CrossedDiagonals> crossed;  ///< by their vertices

  /// The hanging node or crossed diagonal that left a face without its partner.
  std::optional<Cause> cause_of_face(Index face) const;
  /// The one because of which two faces meet, or nearly do: a node hangs on the one and is a vertex of the
  /// other, or both belong to one gap.
  std::optional<Cause> cause_of_pair(const Boundary& boundary, Index s, Index t) const;

  std::vector<Contact> contacts;   ///< ascending
  std::vector<Index> gap_of_face;  ///< -1: none; empty: no gap at all
  std::vector<Cause> cause_of_gap;
};

/// From what a search for intersections and what is near found. A set of faces is a gap if nodes lie near the
/// others' faces, the tetrahedra lie on opposite sides of it, and the faces cancel once their edges are cut
/// at the nodes: they cover the same place. Crossed diagonals: four faces on four vertices that cancel, of
/// which two fold onto each other, or one is among `covered`, the faces with mesh on their outer side: then
/// the quadrilateral is bent and the tetrahedra overlap.
Conformity find_conformity(const TetMesh& mesh, const Boundary& boundary, const FacesAtVertices& at,
                           const Intersections& found, const Near& near, const std::vector<Index>& covered);

/// Whether two triangles near each other hang together by edges that are as short: then they are one place of
/// the boundary, and not two that all but touch.
bool one_place(const Boundary& boundary, const FacesAtVertices& at, const Near& near, Index s, Index t);

}  // namespace tetproof::verify
