// SPDX-License-Identifier: GPL-3.0-or-later
// What a surface file says before it is welded and cut into triangles; and how that is done, the same way for
// every format.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/surface/surface_document.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Where the fan of a planar and convex polygon starts; -1 and the reason if it is not both.
///
/// This is judged with a tolerance, because coordinates rounded to float32 or to six digits are neither
/// exactly: t = max(1e-4 x diagonal of the polygon's box, 1e-6 x its largest absolute coordinate).
///  - Planar: no corner is farther than t from the plane through the corners' mean, across Newell's normal.
///  - Convex: no corner lies more than t inwards of the line through its neighbours, the polygon turns once
///    around, and the triangles of its fan that turn backwards have together no more area than t x diagonal.
/// The fan starts at the first corner both of whose neighbours are more than t off the straight line, so that
/// points in the middle of a side make no degenerate triangle; where there is none, at the corner whose
/// neighbours are farthest off it.
struct Fan {
  std::ptrdiff_t start = -1;
  std::string fault;
};
Fan fan_of(std::span<const Index> corners, const std::vector<Eigen::Vector3d>& points);

/// Welds the points and cuts faces into triangles; elements of OBJ and PLY that are no faces are passed over.
///
/// A triangle stays as it is, degenerate or not. Of a larger polygon, corners that repeat the one before are
/// dropped first (a quadrilateral with a collapsed side is a triangle; one that collapses altogether leaves
/// one degenerate triangle). It is cut into a fan if it is planar and convex.
///
/// Throws InputError, with the polygon's line or byte, for a point that does not exist, fewer than three
/// corners, and a polygon that is not planar or not convex.
TriangleSurface surface_of_faces(const InputFile& file, SurfaceDocument source);

}  // namespace tetproof::io
