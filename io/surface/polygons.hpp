// SPDX-License-Identifier: GPL-3.0-or-later
// Tells which polygons are planar and convex, and where their fans of triangles start.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// What a polygon is: convex and planar polygons are cut into fans, others by io/surface/cutting.hpp.
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
  enum class Shape {
    convex,   ///< and planar
    concave,  ///< planar, and not convex
    bent,     ///< not planar
    broken,   ///< cannot be cut; `fault` says why
  };
  Shape shape = Shape::convex;
  std::size_t start = 0;                             ///< of a convex one: the corner where its fan starts
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< Newell's, of length 1; 0 of corners on a line
  std::string fault;
};
/// The tolerance t of points in the box from `low` to `high`.
double planar_tolerance(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
Fan fan_of(std::span<const Index> corners, const std::vector<Eigen::Vector3d>& points);

}  // namespace tetproof::io
