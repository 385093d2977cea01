// SPDX-License-Identifier: GPL-3.0-or-later
// What a surface file says before it is welded and cut into triangles; and how that is done, the same way for
// every format.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Welds the points and cuts faces into triangles as they come.
///
/// A triangle stays as it is, degenerate or not. Of a larger polygon, corners that repeat the one before are
/// dropped first (a quadrilateral with a collapsed side is a triangle; one that collapses altogether leaves
/// one degenerate triangle). It is cut into a fan if it is planar and convex, which is judged with a
/// tolerance, because coordinates rounded to float32 or to six digits are neither exactly: t = max(1e-4 x
/// diagonal of the polygon's box, 1e-6 x its largest absolute coordinate).
///  - Planar: no corner is farther than t from the plane through the corners' mean, across Newell's normal.
///  - Convex: no corner lies more than t inwards of the line through its neighbours, the polygon turns once
///    around, and the triangles of its fan that turn backwards have together no more area than t x diagonal.
/// The fan starts at the first corner both of whose neighbours are more than t off the straight line, so that
/// points in the middle of a side make no degenerate triangle; where there is none, at the corner whose
/// neighbours are farthest off it.
///
/// Throws InputError, with the polygon's line or byte, for a point that does not exist, fewer than three
/// corners, and a polygon that is not planar or not convex.
class SurfaceFaces {
 public:
  /// All points of the file, the first of which it calls `first`. Places are told as lines if `text`, else as
  /// bytes.
  SurfaceFaces(const InputFile& file, std::vector<Eigen::Vector3d> points, std::int64_t first, bool text);

  void reserve(std::size_t triangles) { surface_.triangles.reserve(triangles); }
  /// The next face: its corners, counted from 0, and the byte where it stands.
  void add(std::span<const std::int64_t> face, std::size_t place);
  TriangleSurface take() { return std::move(surface_); }

 private:
  [[noreturn]] void fail(std::size_t place, const std::string& message) const;

  const InputFile& file_;
  std::int64_t first_;
  bool text_;
  std::vector<Index> moved_;    // where welding put each point
  std::vector<Index> corners_;  // of the face at hand
  TriangleSurface surface_;
};

}  // namespace tetproof::io
