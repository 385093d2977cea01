// SPDX-License-Identifier: GPL-3.0-or-later
// Table 4: the place of the new point when a tetrahedron is split (reading D19).
#pragma once

#include "reference/engine/adaptation/triangulation.hpp"
#include "reference/tables.hpp"

namespace tetproof::reference {

/// The split of one tetrahedron. The new point lies on an edge, on a face or inside. There is one piece for
/// each corner of that edge, face or tetrahedron: the tetrahedron with this corner replaced by the new point.
/// The pieces are in the order of the corners.
struct Split {
  int row;                        ///< in `tables::table4`
  int pieces;                     ///< 2, 3 or 4
  std::array<int, 4> replaced{};  ///< the first `pieces`: positions of the replaced corners, ascending
  Eigen::Vector3d point;          ///< the mean of these corners
  /// Whether the new point is a surface point: it lies on an unshared edge or face (reading D19).
  bool on_surface;
};

/// The splits of a tetrahedron that Table 4 allows. There is more than one only if a row takes the longest of
/// several edges, or the largest of several faces. The first split is the prescribed one: lengths and areas
/// are compared in doubles, and equal ones by the sorted numbers of their points. The other splits are those
/// whose edge or face is as large within a relative difference of `tie`.
std::vector<Split> splits_by_table4(const Triangulation& grid, Index tet, double tie);

/// The split of a tetrahedron that Table 4 prescribes. If the row asks for an edge that no other tetrahedron
/// has, and there is none, the point is the centroid of the largest unshared face.
Split split_by_table4(const Triangulation& grid, Index tet);

/// The corners of the pieces, in order, where `point` is the number of the new point. The first
/// `split.pieces` are set.
std::array<Corners, 4> pieces_of(const Corners& tet, const Split& split, Index point);

}  // namespace tetproof::reference
