// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the triangles that a segment meets, without looking at all of them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// A tree of boxes around triangles. Coordinates must be finite, and no triangle may be degenerate.
class CrossedTriangles {
 public:
  CrossedTriangles(const std::vector<Eigen::Vector3d>& points,
                   const std::vector<std::array<Index, 3>>& triangles);
  ~CrossedTriangles();
  CrossedTriangles(const CrossedTriangles&) = delete;
  CrossedTriangles& operator=(const CrossedTriangles&) = delete;

  /// Exactly the triangles that have a point in common with the segment, in any order.
  std::vector<std::size_t> of(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tetproof::io
