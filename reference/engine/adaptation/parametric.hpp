// SPDX-License-Identifier: GPL-3.0-or-later
// The move of surface points from the triangulated surface to the parametric surface that it approximates
// (reading D12).
#pragma once

#include <memory>
#include <vector>

#include "reference/engine/first_grid/extract.hpp"

namespace tetproof::reference {

/// Maps a point on or near the triangles to the parametric surface (section 2). It finds the closest triangle
/// and the barycentric coordinates of the closest point, interpolates (u,v) between the triangle's corners,
/// and calls the surface's evaluator.
class TrueSurface {
 public:
  /// The surface must have `parameters` and `evaluate`, and must outlive this object.
  explicit TrueSurface(const TriangleSurface& surface);
  ~TrueSurface();

  /// The point on the parametric surface; `point` itself if the evaluator's result is not finite.
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

struct MappedPoint {
  Index point;
  Eigen::Vector3d from, to;
  bool moved;  ///< false: the point stayed at `from`, because `to` was refused
};

/// Moves the surface points of a first grid to the parametric surface, one after the other by number. A point
/// moves only if, with the earlier points already moved, all its tetrahedra stay exactly positive and the
/// boundary does not meet itself (reading D12). Returns all surface points except those that are on the
/// parametric surface already.
std::vector<MappedPoint> move_surface_points(Grid& grid, const TrueSurface& surface);

}  // namespace tetproof::reference
