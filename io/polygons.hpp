// SPDX-License-Identifier: GPL-3.0-or-later
// What a surface file says before it is welded and cut into triangles; and how that is done, the same way for
// every format.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Points and polygons as a file lists them.
struct Polygons {
  std::vector<Eigen::Vector3d> points;
  std::vector<Index> corners;       ///< of all polygons, one after another, positions in `points`
  std::vector<std::size_t> ends;    ///< of each polygon, in `corners`
  std::vector<std::size_t> places;  ///< of each polygon, byte offset in the file

  std::int64_t first = 0;  ///< the number that the file gives to its first point
  bool text = true;        ///< places are told as lines; otherwise as bytes
};

/// Welds the points and cuts the polygons into triangles, in the file's order.
///
/// A triangle stays as it is, degenerate or not. Of a larger polygon, corners that repeat the one before are
/// dropped first (a quadrilateral with a collapsed side is a triangle; one that collapses altogether leaves
/// one degenerate triangle). It is cut into a fan if it is planar and convex, which is judged with a
/// tolerance, because coordinates rounded to float32 or to six digits are neither exactly: t = max(1e-4 x
/// diagonal of the polygon's box, 1e-6 x its largest absolute coordinate).
///  - Planar: no corner is farther than t from the plane through the corners' mean, across Newell's normal.
///  - Convex: no corner lies more than t inwards of the line through its neighbours, the polygon turns once
///  around, and no
///    triangle of its fan turns backwards by more than t (its height over its longest side).
/// The fan starts at the first corner both of whose neighbours are more than t off the straight line, so that
/// points in the middle of a side make no degenerate triangle; where there is none, at the corner whose
/// neighbours are farthest off it.
///
/// Throws InputError, with the polygon's line or byte, for a point that does not exist, fewer than three
/// corners, and a polygon that is not planar or not convex.
TriangleSurface triangulate(Polygons polygons, const InputFile& file);

}  // namespace tetproof::io
