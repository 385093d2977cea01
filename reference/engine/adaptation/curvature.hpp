// SPDX-License-Identifier: GPL-3.0-or-later
// The absolute curvature at the vertices of a triangulated surface, by the method of the paper's reference
// [3] (reading D15).
#pragma once

#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// |k1| + |k2| [1/length] at each vertex. The neighbours of the vertex are projected onto the plane that is
/// normal to the mean of the adjacent triangles' unit normals. Then (c20 u^2 + 2 c11 uv + c02 v^2)/2 is
/// fitted to their heights by least squares; k1 and k2 are the eigenvalues of ((c20, c11), (c11, c02)). If
/// the first ring of neighbours does not determine the fit, the second ring is added. If both do not, the
/// curvature is 0. The result converges on structured triangulations, but not on random ones (reading D15).
std::vector<double> absolute_curvatures(const TriangleSurface& surface);

/// The largest curvature over the 99th percentile. If it is far above 1, a few outliers decide the weights of
/// eq. (3.6).
double outlier_ratio(std::vector<double> curvatures);

}  // namespace tetproof::reference
