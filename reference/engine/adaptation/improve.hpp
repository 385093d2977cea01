// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: local improvement by flips, which exchange the two tetrahedra of a convex hexahedron for three,
// or three for two.
#pragma once

#include <vector>

#include "reference/engine/adaptation/weighted_grid.hpp"
#include "reference/options.hpp"

namespace tetproof::reference {

/// tan(Omega/2) of the smallest of the four solid angles of a positive tetrahedron, after van Oosterom and
/// Strackee. The four have the same numerator, so the smallest has the largest denominator. At most 0.28, the
/// value of the regular tetrahedron.
double smallest_solid_angle(const std::array<Eigen::Vector3d, 4>& corners);
/// D/A = 3V/A_max^2 [1/length]. D is the smallest distance of a vertex from the opposite face, and A is the
/// area of this face, which is the largest one (reading E5).
double aspect_ratio(const std::array<Eigen::Vector3d, 4>& corners);
/// D/sqrt(A) with the same D and A, which has no unit.
double dimensionless_aspect_ratio(const std::array<Eigen::Vector3d, 4>& corners);
/// The solid angle S = Omega/4pi, a fraction of the full solid angle from 0 to 1, from tan(Omega/2).
double solid_angle_of(double tangent);

/// An exchange of the tetrahedra on five vertices: a face for an edge (2-3), or an edge for a face (3-2).
struct Flip {
  std::vector<Index> old;  ///< the numbers of the two or three tetrahedra that are replaced
  /// The three or two new tetrahedra, positive. The vertices of each ascend, or ascend after the last two are
  /// exchanged. The tetrahedra are sorted by their ascending vertices.
  std::vector<Corners> fresh;
  std::array<Index, 3> face;  ///< ascending
  std::array<Index, 2> edge;  ///< ascending
  double before, after;  ///< the smallest quality of the old and of the new tetrahedra: tan(Omega/2), or D/A

  double gain() const { return after - before; }
  bool two_to_three() const { return old.size() == 2; }
  std::array<Index, 5> vertices() const;  ///< ascending
};

/// Every flip that replaces only tetrahedra of `set` and makes only positive ones (reading D22), whether it
/// raises the quality or not. The quality of a tetrahedron is computed from its vertices in ascending order,
/// so that it does not depend on the order in which the tetrahedron has them.
std::vector<Flip> possible_flips(const Triangulation& grid, const std::vector<Index>& set,
                                 Criterion criterion);

/// The flip with the largest gain, if any gain is positive. Of several with the same gain, the one with the
/// lowest vertex numbers (reading D22).
std::optional<Flip> best_flip(const Triangulation& grid, const std::vector<Index>& set, Criterion criterion);

/// The set O_i after a flip. The new tetrahedra have the numbers from `first_fresh` on.
std::vector<Index> updated_set(std::vector<Index> set, const Flip& flip, Index first_fresh);

}  // namespace tetproof::reference
