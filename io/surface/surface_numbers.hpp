// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the file's numbers of a surface's vertices and triangles, while a document's faces become a
// surface.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "io/document.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Follows the steps of the surface's making: first nodes are left out, then equal ones are welded, then
/// faces are added one by one. Memory is taken only for numbers that do not count up.
class SurfaceNumbers {
 public:
  /// `points`: the number of the document's points, which may have been moved out of it. `corners_of`: the
  /// number of corners of each element of a block; 0 if these are no faces.
  SurfaceNumbers(const Document& document, std::size_t points,
                 const std::function<int(const ElementBlock&)>& corners_of);

  /// The vertex at `from` moves to `to`, which is not behind it.
  void move(std::size_t to, std::size_t from);
  /// Only the first `vertices` vertices are left.
  void keep(std::size_t vertices);
  /// The vertices become those at the positions `moved`, which ascend where a vertex is the first of its
  /// like.
  void weld(std::span<const Index> moved, std::size_t vertices);
  /// The next face, which is an element of the document, has become triangles: there are so many now.
  void add(std::size_t element, std::size_t triangles) {
    if (lists_triangles_) list(element, triangles);
    ++faces_;
  }

  /// Only the triangles `kept` are left, after all faces have been added.
  void keep_triangles(std::span<const std::size_t> kept);

  SurfaceNumbering take() &&;

 private:
  void list(std::size_t element, std::size_t triangles);
  void spell_out();

  const Document& document_;
  const std::size_t points_;
  SurfaceNumbering numbering_;
  // STL, OFF, OBJ and PLY number no faces: these are counted as the vertices are.
  const bool counts_faces_;
  bool lists_triangles_ = false;
  std::size_t faces_ = 0;
};

}  // namespace tetproof::io
