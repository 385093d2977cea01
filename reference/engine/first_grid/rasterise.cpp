// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/rasterise.hpp"

namespace tetproof::reference {
namespace {

// One step of Sutherland and Hodgman's clipping: the part of the polygon where side * coordinate <= side *
// bound.
ClippedTriangle clip(const ClippedTriangle& polygon, int axis, double side, double bound) {
  ClippedTriangle kept{{}, 0};
  for (int c = 0; c < polygon.size; ++c) {
    const Eigen::Vector3d& a = polygon.corners[c];
    const Eigen::Vector3d& b = polygon.corners[c + 1 < polygon.size ? c + 1 : 0];
    const double above_a = side * (a[axis] - bound), above_b = side * (b[axis] - bound);
    if (above_a <= 0) kept.corners[kept.size++] = a;
    if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0)) {
      Eigen::Vector3d& cut = kept.corners[kept.size++];
      cut = a + (b - a) * (above_a / (above_a - above_b));
      cut[axis] = bound;
    }
  }
  return kept;
}

}  // namespace

ClippedTriangle ClippedTriangle::between(int axis, double lo, double hi) const {
  return clip(clip(*this, axis, -1, lo), axis, 1, hi);
}

}  // namespace tetproof::reference
