// SPDX-License-Identifier: GPL-3.0-or-later
// The row of Table 2 for four indicators: sorting of the vertices (reading D8), choice among the rows of a
// case (reading D9), orientation of the listed tetrahedra (reading E7).
#pragma once

#include <array>
#include <cstdint>

#include "reference/tables.hpp"

namespace tetproof::reference {

/// Four vertices in the order v1 .. v4: descending by indicator, and equal ones in the given order.
struct SortedVertices {
  std::array<std::uint8_t, 4> order;  ///< the positions of v1 .. v4 in the given order
  int sign;                           ///< of this permutation, +1 or -1
  std::uint8_t first_row;             ///< the first row of the case in Table 2
};
SortedVertices sort_vertices(const std::array<std::int8_t, 4>& indicators);

/// A quadrilateral on the face v_i v_j v_e of a lattice tetrahedron, where v_i and v_j are inside and v_e is
/// outside. Its diagonal is either v_i p_je ("from the first") or v_j p_ie.
struct Quad {
  tables::RowPoint vi, vj, pie, pje;
};

/// The quadrilaterals of case 10, 11 or 12 that two lattice tetrahedra can share, in the order of (i, j, e).
/// The other cases have none.
struct Quads {
  int size = 0;
  std::array<Quad, 3> quads{};
};
const Quads& shared_quads(int first_row);

/// The row of the case that has the given diagonals: bit q is set if the diagonal of quadrilateral q starts
/// at its v_i.
int choose_row(int first_row, unsigned from_the_first);

/// The orientation, +1 or -1, of the tetrahedron t that a row lists, if v1 .. v4 is positive and each cut
/// lies strictly inside its edge.
int listed_orientation(int row, int t);

}  // namespace tetproof::reference
