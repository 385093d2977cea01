// SPDX-License-Identifier: GPL-3.0-or-later
// Scales and moves documents.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/error.hpp"

namespace tetproof::io {
namespace {

// Applies a map of points to everything that has a place. Not to boxes, whose corners may be infinite.
template <class Map>
void move_points(Document& document, const Map& map) {
  for (std::size_t i = 0; i < document.points.size(); ++i) {
    const Eigen::Vector3d old = document.points[i];
    document.points[i] = map(old);
    if (old.allFinite() && !document.points[i].allFinite())
      throw InputError(
          fmt::format("{}: node {} would leave the range of numbers", document.path, document.node_tag(i)));
  }
  for (Eigen::Vector3d& hole : document.holes) hole = map(hole);
  for (Facet& facet : document.facets)
    for (Eigen::Vector3d& hole : facet.holes) hole = map(hole);
  for (Region& region : document.regions) region.point = map(region.point);
  for (Eigen::Vector3d& point : document.voronoi.points) point = map(point);
  for (Entity& entity : document.entities) {
    const Eigen::Vector3d low = map(Eigen::Vector3d(entity.box[0], entity.box[1], entity.box[2])),
                          high = map(Eigen::Vector3d(entity.box[3], entity.box[4], entity.box[5]));
    for (std::size_t k = 0; k < 3; ++k)
      entity.box[k] = low[static_cast<Eigen::Index>(k)],
      entity.box[3 + k] = high[static_cast<Eigen::Index>(k)];
  }
}

}  // namespace

Edit scale(Document& document, double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw InputError(fmt::format("expected a factor above 0, found {}", factor));
  move_points(document, [&](const Eigen::Vector3d& point) -> Eigen::Vector3d { return point * factor; });
  for (Region& region : document.regions)
    if (region.max_volume > 0) region.max_volume *= factor * factor * factor;
  for (AreaBound& bound : document.area_bounds) bound.area *= factor * factor;
  for (LengthBound& bound : document.length_bounds) bound.length *= factor;
  for (PeriodicLink& link : document.periodic)
    for (std::size_t row = 0; row < 3 && link.affine.size() == 16; ++row) link.affine[4 * row + 3] *= factor;
  if (document.format == "tetgen" || document.format == "poly" || document.format == "smesh") {
    for (Values& values : document.node_values)  // an entry of a metric tensor is 1 / length^2
      if (values.name == "sizes")
        for (double& size : values.reals) values.components == 1 ? size *= factor : size /= factor * factor;
    for (Values& values : document.element_values)
      if (values.name == "volume bounds")
        for (double& bound : values.reals)
          if (bound > 0) bound *= factor * factor * factor;
  }
  return {fmt::format("{} scaled by {}", counted(document.points.size(), "points"), factor), {}};
}

Edit translate(Document& document, const Eigen::Vector3d& by) {
  if (!by.allFinite()) throw InputError("expected three finite numbers X,Y,Z");
  move_points(document, [&](const Eigen::Vector3d& point) -> Eigen::Vector3d { return point + by; });
  for (PeriodicLink& link : document.periodic) {  // x = A m + t becomes x + d = A (m + d) + t + d - A d
    if (link.affine.size() != 16) continue;
    for (std::size_t row = 0; row < 3; ++row) {
      const double* a = link.affine.data() + 4 * row;
      link.affine[4 * row + 3] +=
          by[static_cast<Eigen::Index>(row)] - (a[0] * by[0] + a[1] * by[1] + a[2] * by[2]);
    }
  }
  return {
      fmt::format("{} moved by ({}, {}, {})", counted(document.points.size(), "points"), by[0], by[1], by[2]),
      {}};
}

}  // namespace tetproof::io
