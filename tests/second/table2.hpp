// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 1 and 2 of the paper, transcribed as text.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace tetproof::second {

/// A point of a lattice tetrahedron with the vertices v1 .. v4: {i} is v_i, {i,j} is p_ij, {} the centroid c.
using Name = std::vector<int>;
using NamedTet = std::array<Name, 4>;

/// Table 1, and errata entry E8: the case of four indicators in descending order, written as "+", "0" and
/// "-".
std::string table1(const std::string& indicators);

/// Table 2 by row, with errata entries E1, E2 (12g, 12h) and E8. Orientations as printed.
const std::map<std::string, std::vector<NamedTet>>& table2();

}  // namespace tetproof::second
