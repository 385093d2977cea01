// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which triangles are painted, so that each covers what is behind it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetproof::reference {

/// A triangle as the viewer sees it: x to the right, y up, z towards the viewer, in one unit of length.
/// Anticlockwise: a triangle that turns its back to the viewer, or its edge, hides nothing.
struct SeenTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  int colour = 0;  ///< from 0 on; triangles of one colour can be painted together
};

struct PaintersOrder {
  /// Positions of the triangles, in layers that are painted one after the other. The triangles of a layer
  /// have one colour and do not overlap.
  std::vector<std::vector<std::size_t>> layers;
  /// Pairs of triangles that overlap and are painted in the wrong order, because triangles cover one another
  /// in a circle. A single order cannot show these rightly. 0: every pair is in order.
  std::int64_t wrong_pairs = 0;
};

/// Orders triangles that do not pass through one another. Every pair is compared where their pictures
/// overlap, so that the order is right whether or not the mesh is convex or connected. Overlaps smaller than
/// 1e-9 of the square of the picture's longer side are not looked at: they are below a thousandth of a square
/// pixel. Time: the pairs whose boxes meet; memory: the pairs that overlap.
PaintersOrder painters_order(const std::vector<SeenTriangle>& triangles);

}  // namespace tetproof::reference
