// SPDX-License-Identifier: GPL-3.0-or-later
// Step (ii), second half: the points where each lattice edge meets the surface, counted as reading D6 says.
#pragma once

#include <functional>
#include <vector>

#include "reference/engine/first_grid/contacts.hpp"

namespace tetproof::reference {

/// The points that a lattice edge has in common with the surface strictly between its ends. Distinct points
/// are counted, not crossings. Where the edge runs along the surface, the overlaps with all coplanar
/// triangles are united first, and only the ends of the union count (reading D6).
struct EdgeIntersections {
  Edge edge;
  int count;  ///< number of distinct points in the open edge, 1 or more; exact
  /// The point closest to the lower-numbered end, and the one closest to the higher-numbered end. The error
  /// is at most 1e-12 of the edge's length plus the rounding of the coordinates.
  Eigen::Vector3d nearest_low;
  Eigen::Vector3d nearest_high;
};

/// The intersections of every edge that the surface meets strictly between its ends and for which `wanted` is
/// true, ascending by edge.
std::vector<EdgeIntersections> intersect_edges(const Lattice& lattice, const TriangleSurface& surface,
                                               const Contacts& contacts,
                                               const std::function<bool(Edge)>& wanted);

}  // namespace tetproof::reference
