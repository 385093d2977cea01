// SPDX-License-Identifier: GPL-3.0-or-later
// The rule by which polygons are cut into triangles, the same for every format.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// The corner at which the fan of a planar and convex polygon starts; -1 and the reason if it is not both.
///
/// The rule has a tolerance, because coordinates that are rounded to float32 or to six digits are never
/// exactly planar or convex: t = max(1e-4 x diagonal of the polygon's box, 1e-6 x its largest absolute
/// coordinate).
///  - Planar: no corner is farther than t from the plane through the mean of the corners, across Newell's
///    normal.
///  - Convex: no corner lies more than t inwards of the line through its neighbours, the polygon turns once
///    around, and the triangles of its fan that turn backwards have together no more area than t x diagonal.
/// The fan starts at the first corner both of whose neighbours are more than t off the straight line, so that
/// points in the middle of a side make no degenerate triangle. If there is none, it starts at the corner
/// whose neighbours are farthest off that line.
struct Fan {
  std::ptrdiff_t start = -1;
  std::string fault;
};
Fan fan_of(std::span<const Index> corners, const std::vector<Eigen::Vector3d>& points);

}  // namespace tetproof::io
