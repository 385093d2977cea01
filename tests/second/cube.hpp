// SPDX-License-Identifier: GPL-3.0-or-later
// A surface to calculate with by hand.
#pragma once

#include "tests/second/geometry.hpp"

namespace tetproof::second {

inline TriangleSurface cube() {  // 0 .. 1, outward
  TriangleSurface s;
  for (int i = 0; i < 8; ++i) s.vertices.push_back(Point(i & 1, i >> 1 & 1, i >> 2));
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

}  // namespace tetproof::second
