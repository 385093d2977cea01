// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of n corners around the z axis, ring above ring. Internal.
#pragma once

#include <optional>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

struct Ring {
  double radius, z;
  double turned = 0;  ///< in turns, against the x axis
};

/// How the lowest or the highest ring is closed.
struct End {
  std::optional<double> apex{};  ///< a fan around (0, 0, apex); absent: a fan around the ring's first corner
};

/// Rings of n corners, the lowest first, each joined to the next by 2 n triangles: corners i and i + 1 of the
/// lower ring with i + 1 of the upper, and i of the lower with i + 1 and i of the upper.
TriangleSurface revolved(const std::vector<Ring>& rings, int n, const End& bottom, const End& top);

}  // namespace tetproof::corpus
