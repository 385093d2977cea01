// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/triangle_pairs.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(std::span<const Eigen::Vector3d> points, Index i) {
  const Eigen::Vector3d& p = points[static_cast<std::size_t>(i)];
  return {p.x(), p.y(), p.z()};
}

// Projects points of one plane along an axis that is not in the plane. Predicates in 2D are cheaper and as
// exact.
struct Projection {
  int i = 0, j = 1;

  // The plane of a triangle that has an area.
  Projection(std::span<const Eigen::Vector3d> points, const Triangle& t) {
    for (i = 0; i < 2; ++i)
      for (j = i + 1; j < 3; ++j)
        if (CGAL::orientation((*this)(points, t[0]), (*this)(points, t[1]), (*this)(points, t[2])) !=
            CGAL::COLLINEAR)
          return;
    throw std::logic_error("a triangle without an area was tested for intersection");
  }
  Kernel::Point_2 operator()(std::span<const Eigen::Vector3d> points, Index v) const {
    return {points[static_cast<std::size_t>(v)][i], points[static_cast<std::size_t>(v)][j]};
  }
};

using Flat = Kernel::Point_2;

// Whether a segment meets a closed triangle in the same plane. Two convex polygons are apart exactly if the
// line along a side of one of them separates them.
bool meets(const Flat& p, const Flat& q, const Flat& a, const Flat& b, const Flat& c) {
  const CGAL::Orientation inside = CGAL::orientation(a, b, c), outside = -inside;
  const auto beyond = [&](const Flat& u, const Flat& v) {
    return CGAL::orientation(u, v, p) == outside && CGAL::orientation(u, v, q) == outside;
  };
  if (beyond(a, b) || beyond(b, c) || beyond(c, a)) return false;
  const CGAL::Orientation side = CGAL::orientation(p, q, a);
  return side == CGAL::COLLINEAR || CGAL::orientation(p, q, b) != side || CGAL::orientation(p, q, c) != side;
}

// Whether a segment meets a closed triangle.
bool meets(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  return CGAL::do_intersect(Kernel::Segment_3(p, q), Kernel::Triangle_3(a, b, c));
}

// Whether the line through a side of one triangle separates the projections of both along an axis, except for
// shared vertices. The triangles then have nothing else in common. This settles most pairs. It also settles
// nearly coplanar neighbours in double arithmetic, where predicates in space would need exact arithmetic.
bool shadows_apart(std::span<const Eigen::Vector3d> points, const Triangle& first, const Triangle& second) {
  const Eigen::Vector3d& a = points[static_cast<std::size_t>(first[0])];
  const Eigen::Vector3d normal =
      (points[static_cast<std::size_t>(first[1])] - a).cross(points[static_cast<std::size_t>(first[2])] - a);
  Eigen::Index along = 0;
  normal.cwiseAbs().maxCoeff(&along);
  const auto flat = [&](Index v) {
    const Eigen::Vector3d& p = points[static_cast<std::size_t>(v)];
    return Flat(p[(along + 1) % 3], p[(along + 2) % 3]);
  };
  const auto separates = [&](const Triangle& sides, const Triangle& other) {
    const auto inside = CGAL::orientation(flat(sides[0]), flat(sides[1]), flat(sides[2]));
    if (inside == CGAL::COLLINEAR) return false;
    for (int k = 0; k < 3; ++k) {
      const Index u = sides[k], v = sides[(k + 1) % 3];
      if (std::all_of(other.begin(), other.end(), [&](Index w) {
            return w == u || w == v || CGAL::orientation(flat(u), flat(v), flat(w)) == -inside;
          }))
        return true;
    }
    return false;
  };
  return separates(first, second) || separates(second, first);
}

}  // namespace

Degenerate degenerate_triangles(std::span<const Eigen::Vector3d> points,
                                std::span<const Triangle> triangles) {
  Degenerate result;
  result.triangles.assign(triangles.size(), 0);
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    result.triangles[t] = CGAL::collinear(point(points, a), point(points, b), point(points, c));
  });
  result.count = std::count(result.triangles.begin(), result.triangles.end(), 1);
  return result;
}

bool triangles_meet(std::span<const Eigen::Vector3d> points, const Triangle& first, const Triangle& second) {
  if (shadows_apart(points, first, second)) return false;
  // Move the common vertices to the front of both.
  std::array<Index, 3> s = first, t = second;
  int common = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = common; j < 3; ++j)
      if (s[i] == t[j]) {
        std::swap(s[common], s[i]);
        std::swap(t[common], t[j]);
        ++common;
        break;
      }
  const auto p = [&](Index i) { return point(points, i); };
  const Point a = p(s[0]), b = p(s[1]), c = p(s[2]);
  switch (common) {
    case 0:
      return CGAL::do_intersect(Kernel::Triangle_3(a, b, c), Kernel::Triangle_3(p(t[0]), p(t[1]), p(t[2])));
    case 1: {
      // If they share more than the vertex, the common part runs from the vertex to the opposite side of one
      // of the triangles.
      const Point e = p(t[1]), f = p(t[2]);
      const auto side_e = CGAL::orientation(a, b, c, e), side_f = CGAL::orientation(a, b, c, f);
      if (side_e == side_f) {
        if (side_e != CGAL::COPLANAR) return false;
        const Projection flat(points, s);
        const auto q = [&](Index i) { return flat(points, i); };
        return meets(q(t[1]), q(t[2]), q(s[0]), q(s[1]), q(s[2])) ||
               meets(q(s[1]), q(s[2]), q(t[0]), q(t[1]), q(t[2]));
      }
      return meets(e, f, a, b, c) || meets(b, c, a, e, f);
    }
    case 2: {
      // They meet only if folded flat: in one plane, and on the same side of the common edge.
      if (CGAL::orientation(a, b, c, p(t[2])) != CGAL::COPLANAR) return false;
      const Projection flat(points, s);
      const auto q = [&](Index i) { return flat(points, i); };
      return CGAL::orientation(q(s[0]), q(s[1]), q(s[2])) == CGAL::orientation(q(s[0]), q(s[1]), q(t[2]));
    }
    default:
      return true;
  }
}

}  // namespace tetproof::verify
