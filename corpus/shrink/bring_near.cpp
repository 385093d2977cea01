// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/bring_near.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::corpus {
namespace {

Eigen::AlignedBox3d box_of(const TriangleSurface& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : surface.vertices) box.extend(p);
  return box;
}

}  // namespace

double size_of(const TriangleSurface& surface) {
  return box_of(surface).sizes().maxCoeff();
}

TriangleSurface brought_near(const TriangleSurface& surface, bool move, bool scale) {
  TriangleSurface result = surface;
  const Eigen::AlignedBox3d box = box_of(surface);
  const double size = size_of(surface);
  if (!(size > 0) || !std::isfinite(size)) return result;
  const double far = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (move && far > 8 * size)
    for (Eigen::Vector3d& p : result.vertices) p -= box.min();
  if (scale && (size < 0.1 || size > 1000)) {
    const int exponent = -std::ilogb(size);
    for (Eigen::Vector3d& p : result.vertices)
      for (double& x : p) x = std::ldexp(x, exponent);
  }
  return result;
}

}  // namespace tetproof::corpus
