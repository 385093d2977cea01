// SPDX-License-Identifier: GPL-3.0-or-later
// The constrained Delaunay triangulation of polygons in a plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// Polygons in one plane: of one corner (a point), of two (an edge), or of more.
struct PlanarFacet {
  std::vector<std::span<const Index>> polygons;  ///< positions of points
  std::span<const Eigen::Vector3d> holes;        ///< a point in each
  /// What lies inside. Of one polygon: what is surrounded an odd number of times, so that a polygon may reach
  /// holes over an edge that it runs both ways. Of several, as in TetGen: what their edges separate from
  /// outside and from the points of holes.
  bool odd = true;
};

/// Adds the triangles to `triangles`, seen anticlockwise against `normal`. Returns what is wrong with the
/// polygons; empty: nothing.
///
/// The points are seen along the axis next to the normal, so that their coordinates are exact and all
/// decisions are exact. Lengths are those in the plane across the normal. Of four corners on one circle, the
/// one with the smallest position gets the diagonal; this rule makes the triangulation the only one, whatever
/// the order in which it is found. Triangles start with their smallest position, and ascend.
std::string cut_planar(const PlanarFacet& facet, const std::vector<Eigen::Vector3d>& points,
                       const Eigen::Vector3d& normal, std::vector<std::array<Index, 3>>& triangles);

}  // namespace tetproof::io
