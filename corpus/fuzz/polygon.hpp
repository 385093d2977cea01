// SPDX-License-Identifier: GPL-3.0-or-later
// Simple polygons, cut into triangles by exact decisions. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// Cuts a simple polygon, given anticlockwise, into triangles without new vertices: the first ear is cut off
/// until a triangle is left. None of the triangles is degenerate, even where vertices are collinear.
/// InputError if the polygon crosses or touches itself so that no ear is left.
std::vector<std::array<Index, 3>> cut_polygon(const std::vector<Eigen::Vector2d>& polygon);

/// The prism over a simple polygon, given anticlockwise, from z = 0 to z = h.
TriangleSurface prism(const std::vector<Eigen::Vector2d>& polygon, double h);

}  // namespace tetproof::corpus
