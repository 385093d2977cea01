// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary together with the nodes that lie on its faces: which faces lie opposite each other. Internal.
#pragma once

#include <span>
#include <vector>

#include "verify/mesh/boundary.hpp"
#include "verify/triangles/near_distance.hpp"
#include "verify/triangles/near_pairs.hpp"

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

/// Faces are positions in `Boundary::faces`. Keeps references to the mesh, the boundary and `near`.
class Interface {
 public:
  /// `contacts`: vertices on triangles that they do not belong to.
  Interface(const TetMesh& mesh, const Boundary& boundary, const Near& near, std::vector<Contact> contacts);

  const Triangle& triangle(Index f) const { return boundary_.triangles[static_cast<std::size_t>(f)]; }
  const std::vector<Contact>& contacts() const { return by_triangle_; }  ///< by their triangles
  std::span<const Contact> nodes_on(Index f) const;

  /// Whether the tetrahedron of face g reaches to the outer side of face f. Exact.
  bool beyond(Index f, Index g) const;
  /// Whether the tetrahedron of each face reaches to the outer side of the other face. Exact.
  bool opposite(Index f, Index g) const { return beyond(f, g) && beyond(g, f); }
  /// For two faces with a common edge: whether they belong to two tetrahedra and bend outwards. Exact.
  bool overlap_between(Index f, Index g) const;

  /// Whether each vertex of face g is a vertex of face f or a node on it.
  bool within(Index g, Index f) const;
  /// Whether the vertices of face g are near the plane of face f.
  bool coplanar(Index g, Index f) const;
  /// Whether the faces cancel: once they are cut at the nodes on them, every edge is run as often in one
  /// direction as in the other.
  bool closes(std::span<const Index> faces) const;

 private:
  int side(Index f, Index v) const;  // 1: v is on the outer side of face f, -1: on its inner side

  const TetMesh& mesh_;
  const Boundary& boundary_;
  const Near& near_;
  std::vector<Contact> by_triangle_;
};

}  // namespace tetproof::verify
