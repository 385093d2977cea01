// SPDX-License-Identifier: GPL-3.0-or-later
// Step (ii), second half: the points in which each lattice edge meets the surface, counted as reading D6
// counts them.
#pragma once

#include <functional>
#include <vector>

#include "reference/engine/first_grid/contacts.hpp"

namespace tetproof::reference {

/// What a lattice edge has in common with the surface strictly between its ends. Distinct points are counted,
/// never crossings; where the edge runs along the surface, the overlaps with all coplanar triangles are
/// united first and only the ends of the union count (reading D6).
struct EdgeIntersections {
  Edge edge;
  int count;                     ///< of distinct points in the open edge, 1 or more; exact
  Eigen::Vector3d nearest_low;   ///< the one closest to the lower-numbered end, and
  Eigen::Vector3d nearest_high;  ///< to the higher; each off by at most 1e-12 of the edge's length plus the
                                 ///< rounding of its coordinates
};

/// For every edge that the surface meets strictly between its ends and that `wanted`, ascending by edge.
std::vector<EdgeIntersections> intersect_edges(const Lattice& lattice, const TriangleSurface& surface,
                                               const Contacts& contacts,
                                               const std::function<bool(Edge)>& wanted);

}  // namespace tetproof::reference
