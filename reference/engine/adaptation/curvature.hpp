// SPDX-License-Identifier: GPL-3.0-or-later
// The absolute curvature at the vertices of a triangulated surface, after the paper's reference [3] (reading
// D15).
#pragma once

#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::reference {

/// |k1| + |k2| [1/length] at each vertex. At a vertex the neighbours are projected on the plane normal to the
/// mean of the adjacent triangles' unit normals, (c20 u^2 + 2 c11 uv + c02 v^2)/2 is fitted to their heights
/// by least squares, and k1, k2 are the eigenvalues of ((c20, c11), (c11, c02)). The second ring joins where
/// the first does not determine the fit; a vertex where that does not either has curvature 0. Converges on
/// structured triangulations, not on random ones (D15).
std::vector<double> absolute_curvatures(const TriangleSurface& surface);

/// The largest curvature over the 99th percentile: far above 1, a few outliers decide the weight of eq.
/// (3.6).
double outlier_ratio(std::vector<double> curvatures);

}  // namespace tetproof::reference
