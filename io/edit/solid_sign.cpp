// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/solid_sign.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "io/edit/solid_faces.hpp"
#include "io/surface/constrained.hpp"

namespace tetproof::io {
namespace {

// Differences to the first corner, along each axis in units of a power of two, so that no product of three
// leaves the range of numbers. The sign of a volume does not depend on such units.
void scale_axes(std::vector<Eigen::Vector3d>& corners) {
  const Eigen::Vector3d first = corners[0];
  for (int axis = 0; axis < 3; ++axis) {
    double most = 0;
    for (Eigen::Vector3d& corner : corners) {
      corner[axis] = corner[axis] / 2 - first[axis] / 2;  // halves: the difference may be too large
      most = std::max(most, std::abs(corner[axis]));
    }
    int exponent = 0;
    std::frexp(most, &exponent);
    for (Eigen::Vector3d& corner : corners) corner[axis] = std::ldexp(corner[axis], -exponent);
  }
}

}  // namespace

bool is_inverted(const Document& document, const ElementBlock& block, const Index* nodes) {
  const ElementType& type = *element_type(block.type);
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < type.corners; ++k) {
    if (nodes[k] < 0) return false;
    corners.push_back(document.points[static_cast<std::size_t>(nodes[k])]);
    if (!corners.back().allFinite()) return false;
  }
  if (type.shape == Shape::tetrahedron)
    return side_of_plane(corners[0], corners[1], corners[2], corners[3]) < 0;
  scale_axes(corners);
  double volume = 0;
  for (const SolidFace& face : solid_faces(block.type)) {
    const auto corner = [&](int k) -> const Eigen::Vector3d& {
      return corners[static_cast<std::size_t>(face.nodes[static_cast<std::size_t>(k)])];
    };
    for (int k = 1; k + 1 < face.corners; ++k) volume += corner(0).dot(corner(k).cross(corner(k + 1)));
  }
  return volume < 0;
}

}  // namespace tetproof::io
