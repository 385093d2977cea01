// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces and grids to calculate with by hand, for the tests of the page.
#pragma once

#include "reference/paper/page.hpp"

namespace tetproof::reference::paper {

/// The surface of the cube from 0 to 1, oriented outward. Triangle t is in the face t/2: z=0, z=1, y=0, y=1,
/// x=0, x=1.
inline TriangleSurface cube() {
  TriangleSurface s;
  for (int i = 0; i < 8; ++i) s.vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

/// The same, so far away that all distances to it are about equal.
inline TriangleSurface far_cube() {
  TriangleSurface far = cube();
  for (Point& v : far.vertices) v += Point(100, 0, 0);
  return far;
}

/// Gives a page a grid to begin section 3 or 4 with, in place of the one of section 2.
inline void give_grid(Page& page, const std::vector<Point>& points, const std::set<int>& surface_points,
                      const std::vector<Tet>& tets) {
  page.points_ = points;
  page.surface_points_ = surface_points;
  for (const Tet& tet : tets) page.add(tet);
}

}  // namespace tetproof::reference::paper
