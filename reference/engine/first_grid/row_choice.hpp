// SPDX-License-Identifier: GPL-3.0-or-later
// From four indicators to the row of Table 2: sorting (reading D8), the choice among a case's rows (reading
// D9), orientation (reading E7).
#pragma once

#include <array>
#include <cstdint>

#include "reference/tables.hpp"

namespace tetproof::reference {

/// The order v1 .. v4 of four vertices: by indicator, descending, ties by place. `order[0]` is the place of
/// v1. `sign` is the permutation's.
struct SortedVertices {
  std::array<std::uint8_t, 4> order;
  int sign;
  std::uint8_t first_row;  ///< the first row of its case in Table 2
};
SortedVertices sort_vertices(const std::array<std::int8_t, 4>& indicators);

/// A quadrilateral on a face of the lattice tetrahedron: vi and vj inside, ve outside. Its diagonal is either
/// vi-p_je ("from the first") or vj-p_ie.
struct Quad {
  tables::RowPoint vi, vj, pie, pje;
};

/// The quadrilaterals of case 10, 11 or 12 that two lattice tetrahedra share, in order of (vi, vj, ve); none
/// for other cases.
struct Quads {
  int size = 0;
  std::array<Quad, 3> quads{};
};
const Quads& shared_quads(int first_row);

/// The row of the case with the given diagonals: bit q set where quad q's runs from vi.
int choose_row(int first_row, unsigned from_the_first);

/// Orientation of tetrahedron t of a row as listed, when v1 .. v4 is positive and each cut lies strictly
/// inside its edge: +1 or -1.
int listed_orientation(int row, int t);

}  // namespace tetproof::reference
