// SPDX-License-Identifier: GPL-3.0-or-later
// Step (ii), first half: which lattice vertices lie on the surface, or near it, and which triangles meet
// which lattice edges. The surface is rasterised into the lattice: every triangle visits the cells it
// touches.
#pragma once

#include <functional>
#include <vector>

#include "reference/engine/first_grid/lattice.hpp"

namespace tetproof::reference {

/// A triangle and a lattice edge whose ends lie strictly on different sides of it and that meet (exact); or,
/// `along` set, a triangle whose plane holds the edge, so that they may overlap.
struct EdgeHit {
  Edge edge;
  Index triangle;
  bool along;
};

struct Contacts {
  std::vector<Vertex> on_surface;  ///< vertices that lie exactly in a closed triangle, ascending
  std::vector<EdgeHit> hits;       ///< ascending by (edge, triangle)
};

/// All contacts, exact for the doubles as stored (reading D4). Linear in triangles + cells they touch.
Contacts find_contacts(const Lattice& lattice, const TriangleSurface& surface);

/// A lattice vertex with the closest point of the surface; of several, the lexicographically smallest. A
/// vertex exactly on the surface is its own.
struct NearVertex {
  Vertex vertex;
  double squared_distance;  ///< relative error below 1e-14 plus (1e-15 times the largest coordinate)^2
  Eigen::Vector3d point;
};

/// Every vertex that `wanted` and the surface comes closer to than `radius` [length], ascending.
std::vector<NearVertex> find_near_vertices(const Lattice& lattice, const TriangleSurface& surface,
                                           double radius, const std::function<bool(Vertex)>& wanted);

/// The closest point of a triangle to `p`, in double precision; the same for any order of the corners.
Eigen::Vector3d closest_point(std::array<Eigen::Vector3d, 3> triangle, const Eigen::Vector3d& p);

/// A triangle with its corners in lexicographic order, so that nothing computed from it depends on numbering.
std::array<Eigen::Vector3d, 3> sorted_corners(std::array<Eigen::Vector3d, 3> triangle);
bool lexicographically_less(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace tetproof::reference
