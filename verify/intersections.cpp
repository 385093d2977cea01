// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "verify/box.hpp"

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(std::span<const Eigen::Vector3d> points, Index i) {
  const Eigen::Vector3d& p = points[static_cast<std::size_t>(i)];
  return {p.x(), p.y(), p.z()};
}

// Points of one plane, seen along an axis that is not in it: cheaper there, and as exact.
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

// The segment against the closed triangle, both in a plane. Two convex sets are apart if a line along a side
// of one of them separates them.
bool meets(const Flat& p, const Flat& q, const Flat& a, const Flat& b, const Flat& c) {
  const CGAL::Orientation inside = CGAL::orientation(a, b, c), outside = -inside;
  const auto beyond = [&](const Flat& u, const Flat& v) {
    return CGAL::orientation(u, v, p) == outside && CGAL::orientation(u, v, q) == outside;
  };
  if (beyond(a, b) || beyond(b, c) || beyond(c, a)) return false;
  const CGAL::Orientation side = CGAL::orientation(p, q, a);
  return side == CGAL::COLLINEAR || CGAL::orientation(p, q, b) != side || CGAL::orientation(p, q, c) != side;
}

// The segment against the closed triangle.
bool meets(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  return CGAL::do_intersect(Kernel::Segment_3(p, q), Kernel::Triangle_3(a, b, c));
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

namespace {

// Whether a side of one triangle separates the shadows that both cast along an axis, but for vertices they
// share. Then the triangles have nothing else in common. Most pairs end here, and neighbours that are all but
// coplanar, where predicates in space need exact arithmetic, do so with doubles.
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

bool triangles_meet(std::span<const Eigen::Vector3d> points, const Triangle& first, const Triangle& second) {
  if (shadows_apart(points, first, second)) return false;
  // Common vertices to the front of both.
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
      // A common part beyond the vertex runs from it to where one triangle ends: on its side opposite to the
      // vertex.
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
      // Only when folded flat: in one plane and on the same side of the common edge.
      if (CGAL::orientation(a, b, c, p(t[2])) != CGAL::COPLANAR) return false;
      const Projection flat(points, s);
      const auto q = [&](Index i) { return flat(points, i); };
      return CGAL::orientation(q(s[0]), q(s[1]), q(s[2])) == CGAL::orientation(q(s[0]), q(s[1]), q(t[2]));
    }
    default:
      return true;
  }
}

namespace {

// The boxes dealt to slabs across one axis, so that slabs can be searched by themselves. A box is in every
// slab that it reaches; a pair belongs to the later of the slabs in which its two boxes begin, and both reach
// that one.
struct Slabs {
  int axis = 0;
  std::vector<double> splits;  // where all slabs but the first begin

  std::uint32_t slab_of(double x) const {
    return static_cast<std::uint32_t>(std::upper_bound(splits.begin(), splits.end(), x) - splits.begin());
  }
};

Slabs make_slabs(const std::vector<Box>& boxes) {
  constexpr std::size_t boxes_each = 16384;
  // The axis across which boxes are thinnest; so many slabs that boxes reach about one more than they begin
  // in.
  Slabs slabs;
  double reach = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    double low = boxes[0].low[axis], high = low, sum = 0;
    for (const Box& box : boxes) {
      low = std::min(low, box.low[axis]);
      high = std::max(high, box.high[axis]);
      sum += box.high[axis] - box.low[axis];
    }
    const double share = sum / (static_cast<double>(boxes.size()) * (high - low));
    if (share < reach) reach = share, slabs.axis = axis;
  }
  const double most = std::min(static_cast<double>(boxes.size() / boxes_each), 1 / reach);
  const auto count = most >= 2 ? static_cast<std::size_t>(most) : 1;
  std::vector<double> lows(boxes.size());
  std::transform(boxes.begin(), boxes.end(), lows.begin(),
                 [&](const Box& box) { return box.low[slabs.axis]; });
  for (std::size_t i = 1; i < count; ++i) {
    const auto at = lows.begin() + static_cast<std::ptrdiff_t>(i * lows.size() / count);
    std::nth_element(lows.begin(), at, lows.end());
    slabs.splits.push_back(*at);
  }
  return slabs;
}

// The first `most` in order, and how many there were.
void keep_first(std::vector<std::array<Index, 2>>& pairs, std::size_t most) {
  std::sort(pairs.begin(), pairs.end());
  if (pairs.size() > most) pairs.resize(most);
}

}  // namespace

Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (excluded.empty() || !excluded[t]) boxes.push_back(box_of(points, triangles[t], t));
  Intersections result;
  if (boxes.empty()) return result;

  const Slabs slabs = make_slabs(boxes);
  std::vector<std::uint32_t> begins(triangles.size()), ends(triangles.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
    begins[boxes[i].number] = slabs.slab_of(boxes[i].low[slabs.axis]);
    ends[boxes[i].number] = slabs.slab_of(boxes[i].high[slabs.axis]);
  });
  std::vector<Intersections> found(slabs.splits.size() + 1);
  tbb::parallel_for(
      std::size_t{0}, found.size(),
      [&](std::size_t slab) {
        std::vector<Box> mine;
        for (const Box& box : boxes)
          if (begins[box.number] <= slab && slab <= ends[box.number]) mine.push_back(box);
        auto& [count, pairs] = found[slab];
        const auto meet = [&, &n = count, &list = pairs](const Box& x, const Box& y) {
          if (std::max(begins[x.number], begins[y.number]) != slab) return;
          const auto [low, high] = std::minmax({static_cast<Index>(x.number), static_cast<Index>(y.number)});
          if (!triangles_meet(points, triangles[low], triangles[high])) return;
          ++n;
          list.push_back({low, high});
          if (list.size() > 2 * most + 1024) keep_first(list, most);
        };
        // Below the cutoff it sweeps instead of splitting further; 1000 takes half the time of its
        // default, 10.
        CGAL::box_self_intersection_d(mine.begin(), mine.end(), meet,
                                      CGAL::Box_intersection_d::Box_traits_d<Box>(), 1000,
                                      CGAL::Box_intersection_d::CLOSED);
      },
      tbb::simple_partitioner());
  for (const Intersections& part : found) {
    result.count += part.count;
    result.pairs.insert(result.pairs.end(), part.pairs.begin(), part.pairs.end());
  }
  keep_first(result.pairs, most);
  return result;
}

}  // namespace tetproof::verify
