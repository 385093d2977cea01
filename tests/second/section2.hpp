// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2 of the paper, steps (i) to (iv), with everything in maps.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/triangle_surface.hpp"
#include "tests/second/geometry.hpp"
#include "tests/second/settings.hpp"

namespace tetproof::second {

using Place = std::array<int, 3>;  ///< i, j, k of a lattice vertex

/// Step (i).
struct Lattice {
  std::array<int, 3> cells{};
  Point low, high;  ///< the scaled box
  double shortest_cell_edge = 0;
  std::map<int, Point> points;  ///< by D3's number
  std::map<int, Place> places;
  std::vector<std::array<int, 4>> tets;  ///< by cell, then order of the axes (D2, D3)
  std::set<std::pair<int, int>> edges;   ///< lower number first
  int number(const Place& at) const { return at[0] + (cells[0] + 1) * (at[1] + (cells[1] + 1) * at[2]); }
};

Lattice make_lattice(const TriangleSurface& surface, const Settings& settings);

/// Steps (ii) and (iii).
struct Indicators {
  std::map<int, int> initial, after;          ///< before and after Table 3
  std::map<int, Point> settled;               ///< vertices taken to the surface for good, and where (D4)
  std::map<std::pair<int, int>, Point> cuts;  ///< of the edges between -1 and +1, lower number first
  std::map<std::pair<int, int>, int> cut_at_vertex;  ///< those cuts that are a lattice vertex (D7)
};

/// Steps (ii), (iii). `mended`: vertices that become 0 for good because of rounding.
Indicators characterize(const TriangleSurface& surface, const Lattice& lattice, const Settings& settings,
                        const std::set<int>& mended);

/// The grid of step (iv).
struct Grid {
  std::vector<Point> points;
  std::vector<bool> on_surface;
  std::vector<std::array<int, 4>> tets;
  std::vector<std::string> rows;  ///< of Table 2, for each lattice tetrahedron
  std::set<int> to_mend;  ///< lattice vertices that D4 asks for, because a tetrahedron is not positive
};

/// Step (iv).
Grid extract(const TriangleSurface& surface, const Lattice& lattice, const Indicators& indicators,
             const Settings& settings);

}  // namespace tetproof::second
