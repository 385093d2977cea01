// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/touching.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace

bool touches_plane(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& plane) {
  return CGAL::orientation(point(plane[0]), point(plane[1]), point(plane[2]), point(p)) == CGAL::COPLANAR;
}

bool touches_segment(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 2>& segment) {
  if (segment[0] == segment[1]) return p == segment[0];
  return Kernel::Segment_3(point(segment[0]), point(segment[1])).has_on(point(p));
}

bool segments_touch(const std::array<Eigen::Vector3d, 2>& one, const std::array<Eigen::Vector3d, 2>& other) {
  if (one[0] == one[1]) return touches_segment(one[0], other);
  if (other[0] == other[1]) return touches_segment(other[0], one);
  return CGAL::do_intersect(Kernel::Segment_3(point(one[0]), point(one[1])),
                            Kernel::Segment_3(point(other[0]), point(other[1])));
}

}  // namespace tetproof::verify
