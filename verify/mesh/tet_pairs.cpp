// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/tet_pairs.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "verify/mesh/witness.hpp"

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Whether all of `other` lies on the outer side of a face of `one`, or in its plane.
bool a_face_separates(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& one,
                      const std::array<Index, 4>& other) {
  const auto point = [&](Index v) {
    const Eigen::Vector3d& p = points[v];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  return std::any_of(tet_faces.begin(), tet_faces.end(), [&](const std::array<int, 3>& face) {
    return std::none_of(other.begin(), other.end(), [&](Index v) {
      return CGAL::orientation(point(one[face[0]]), point(one[face[1]]), point(one[face[2]]), point(v)) ==
             CGAL::NEGATIVE;
    });
  });
}

}  // namespace

bool overlap(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& one,
             const std::array<Index, 4>& other) {
  return !a_face_separates(points, one, other) && !a_face_separates(points, other, one) &&
         common_point(points, one, other).has_value();
}

}  // namespace tetproof::verify
