// SPDX-License-Identifier: GPL-3.0-or-later
// Step (ii), first half: the lattice vertices that lie on the surface or near it, and the lattice edges that
// each triangle meets. The surface is rasterised into the lattice: every triangle visits the cells it
// touches.
#pragma once

#include <functional>
#include <vector>

#include "reference/engine/first_grid/closest_point.hpp"
#include "reference/engine/first_grid/lattice.hpp"

namespace tetproof::reference {

/// A lattice edge and a triangle that meet, or may meet.
struct EdgeHit {
  Edge edge;
  Index triangle;
  /// False: the ends of the edge lie strictly on different sides of the triangle, and the edge meets it
  /// (exact). True: the edge lies in the plane of the triangle, so that they may overlap.
  bool along;
};

struct Contacts {
  std::vector<Vertex> on_surface;  ///< the lattice vertices that lie exactly in a closed triangle, ascending
  std::vector<EdgeHit> hits;       ///< ascending by (edge, triangle)
};

/// All contacts, exact for the doubles as stored (reading D4). The time is linear in the number of triangles
/// plus the number of cells they touch.
Contacts find_contacts(const Lattice& lattice, const TriangleSurface& surface);

/// A lattice vertex with its closest point of the surface.
struct NearVertex {
  Vertex vertex;
  /// [length^2], with a relative error below 1e-14 and a further error of (1e-15 times the largest
  /// coordinate)^2.
  double squared_distance;
  /// Of several closest points the lexicographically smallest. For a vertex exactly on the surface, the
  /// vertex.
  Eigen::Vector3d point;
};

/// Every lattice vertex that is closer to the surface than `radius` [length] and for which `wanted` is true,
/// ascending.
std::vector<NearVertex> find_near_vertices(const Lattice& lattice, const TriangleSurface& surface,
                                           double radius, const std::function<bool(Vertex)>& wanted);

}  // namespace tetproof::reference
