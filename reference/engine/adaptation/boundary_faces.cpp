// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/adaptation/boundary_faces.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tetproof::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

bool boxes_apart(const BoundaryFace& f, const BoundaryFace& g) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [f_low, f_high] = std::minmax({f.corners[0][axis], f.corners[1][axis], f.corners[2][axis]});
    const auto [g_low, g_high] = std::minmax({g.corners[0][axis], g.corners[1][axis], g.corners[2][axis]});
    if (f_high < g_low || g_high < f_low) return true;
  }
  return false;
}

}  // namespace

bool faces_meet(const BoundaryFace& f, const BoundaryFace& g) {
  if (boxes_apart(f, g)) return false;
  std::array<Point, 3> p{point(f.corners[0]), point(f.corners[1]), point(f.corners[2])},
      q{point(g.corners[0]), point(g.corners[1]), point(g.corners[2])};
  std::array<Index, 3> names = g.names;
  int common = 0;  // the common vertices are moved to the front of both
  for (int i = 0; i < 3; ++i)
    for (int j = common; j < 3; ++j)
      if (f.names[i] == names[j]) {
        std::swap(p[common], p[i]);
        std::swap(q[common], q[j]);
        std::swap(names[common], names[j]);
        ++common;
        break;
      }
  const Kernel::Triangle_3 s(p[0], p[1], p[2]), t(q[0], q[1], q[2]);
  switch (common) {
    case 0:
      return CGAL::do_intersect(s, t);
    case 1:  // they have more in common than the vertex only if a side opposite to it meets the other face
      return CGAL::do_intersect(Kernel::Segment_3(p[1], p[2]), t) ||
             CGAL::do_intersect(Kernel::Segment_3(q[1], q[2]), s);
    case 2:  // they have more in common than the edge only if one is folded flat onto the other
      return CGAL::coplanar(p[0], p[1], p[2], q[2]) &&
             CGAL::coplanar_orientation(p[0], p[1], p[2], q[2]) == CGAL::POSITIVE;
    default:
      return true;
  }
}

template <class Visit>
void BoundaryFaces::visit_cells(const BoundaryFace& face, const Visit& visit) const {
  std::array<std::int64_t, 3> low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, most] =
        std::minmax({face.corners[0][axis], face.corners[1][axis], face.corners[2][axis]});
    low[axis] = static_cast<std::int64_t>(std::floor(least / cell_));
    high[axis] = static_cast<std::int64_t>(std::floor(most / cell_));
  }
  for (std::int64_t i = low[0]; i <= high[0]; ++i)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      // Two cells with the same key share a list, which only costs time.
      for (std::int64_t k = low[2]; k <= high[2]; ++k)
        visit(static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15u ^
              static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4Fu ^
              static_cast<std::uint64_t>(k) * 0x165667B19E3779F9u);
}

void BoundaryFaces::add(const BoundaryFace& face) {
  visit_cells(face, [&](std::uint64_t cell) { faces_[cell].push_back(face); });
}

void BoundaryFaces::remove(const BoundaryFace& face) {
  auto names = face.names;
  std::sort(names.begin(), names.end());
  visit_cells(face, [&](std::uint64_t cell) {
    auto& there = faces_[cell];
    const auto found = std::find_if(there.begin(), there.end(), [&](BoundaryFace other) {
      std::sort(other.names.begin(), other.names.end());
      return other.names == names;
    });
    if (found == there.end())
      throw std::logic_error("a boundary face is not in the cell to which it was added");
    *found = there.back();
    there.pop_back();
  });
}

bool BoundaryFaces::meets(const BoundaryFace& face,
                          const std::function<bool(const BoundaryFace&)>& counts) const {
  bool met = false;
  visit_cells(face, [&](std::uint64_t cell) {
    const auto there = faces_.find(cell);
    if (met || there == faces_.end()) return;
    met = std::any_of(there->second.begin(), there->second.end(),
                      [&](const BoundaryFace& other) { return counts(other) && faces_meet(face, other); });
  });
  return met;
}

}  // namespace tetproof::reference
