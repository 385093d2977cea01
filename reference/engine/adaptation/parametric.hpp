// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the triangulated surface, moved to the parametric surface it approximates (reading D12).
#pragma once

#include <memory>
#include <vector>

#include "reference/engine/first_grid/extract.hpp"

namespace tetproof::reference {

/// The way from a point on or near the triangles to the true surface: closest triangle, barycentric
/// coordinates, parameter values from the triangle's corners, evaluator (section 2).
class TrueSurface {
 public:
  /// The surface must have `parameters` and `evaluate`.
  explicit TrueSurface(const TriangleSurface& surface);
  ~TrueSurface();

  /// The point itself where the evaluator gives nothing finite.
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

struct MappedPoint {
  Index point;
  Eigen::Vector3d from, to;
  bool moved;  ///< else `to` was refused
};

/// Moves the surface points of a first grid to the true surface, in order of their numbers, each only if,
/// with the points before it moved, all its tetrahedra stay exactly positive and the boundary does not meet
/// itself (reading D12). Those that are there already are left out of what is returned.
std::vector<MappedPoint> move_surface_points(Grid& grid, const TrueSurface& surface);

}  // namespace tetproof::reference
