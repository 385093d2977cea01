// SPDX-License-Identifier: GPL-3.0-or-later
// Convex hulls by exact decisions. Internal.
#pragma once

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The boundary of the convex hull of points, in triangles, oriented outward. Points that lie on the hull of
/// those before them, and are no corner of it, are left out; so are those inside. The same points in the same
/// order give the same triangles everywhere, which CGAL's
/// `convex_hull_3` does not promise from version to version. InputError if all points lie in one plane.
TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points);

}  // namespace tetproof::corpus
