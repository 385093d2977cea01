// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of the part of a surface that a cut has taken away. Not installed.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "reference/figure/plane_cut.hpp"

namespace tetproof::reference {

/// Closed lines whose picture, filled by the rule "nonzero", is the picture of the surface's part on the
/// plane's positive side: the border of the triangles that face the viewer, clipped by the plane. `view`: the
/// direction from which they are seen. A triangle that is exactly on the plane has no part.
std::vector<std::vector<Eigen::Vector3d>> near_part_outline(const TriangleSurface& surface,
                                                            const Plane& plane, const Eigen::Vector3d& view);

}  // namespace tetproof::reference
