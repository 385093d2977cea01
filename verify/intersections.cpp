// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
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

// The first `most` in order, each once.
template <class T>
void keep_first(std::vector<T>& list, std::size_t most) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  if (list.size() > most) list.resize(most), list.shrink_to_fit();
}

template <class T>
void add(std::vector<T>& list, const T& item, std::size_t most) {
  list.push_back(item);
  if (list.size() > 2 * most + 1024) keep_first(list, most);
}

void keep_first(Intersections& all, std::size_t most) {
  keep_first(all.pairs, most);
  keep_first(all.contacts, most);
  keep_first(all.folds, most);
  keep_first(all.near, most);
}

bool in_box(const Eigen::Vector3d& p, const Box& box) {
  return p.x() >= box.low[0] && p.x() <= box.high[0] && p.y() >= box.low[1] && p.y() <= box.high[1] &&
         p.z() >= box.low[2] && p.z() <= box.high[2];
}

// What of two triangles, whose boxes are wider than they by what is near, is near each other.
class Nearby {
 public:
  Nearby(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, const Near& near,
         std::size_t most)
      : points_(points),
        triangles_(triangles),
        near_(near),
        room_(near.limit() * near.diagonal()),
        margin_(2 * room_ * near.diagonal()),
        most_(most) {}

  // Whether a side of one triangle separates the shadows that both cast along an axis, but for vertices they
  // share, by so much that they neither meet nor are near each other. Most pairs end here. A vertex beyond
  // the line of a side by `margin_` / (length of the side) is farther than 2 room_ from the triangle on its
  // other side; and an end of the side is as far from a triangle that has its other end on the line, and the
  // rest beyond. Rounding is a thousand times smaller than the margin.
  bool wide_apart(const Triangle& first, const Triangle& second) const {
    const Eigen::Vector3d &a = at(first[0]), &b = at(first[1]), &c = at(first[2]);
    Eigen::Index along = 0;
    (b - a).cross(c - a).cwiseAbs().maxCoeff(&along);
    const Eigen::Index x = (along + 1) % 3, y = (along + 2) % 3;
    const auto separates = [&](const Triangle& sides, const Triangle& other) {
      const auto area = [&](Index u, Index v, Index w) {
        const Eigen::Vector3d &p = at(u), &q = at(v), &r = at(w);
        return (q[x] - p[x]) * (r[y] - p[y]) - (q[y] - p[y]) * (r[x] - p[x]);
      };
      const double inside = area(sides[0], sides[1], sides[2]);
      if (std::abs(inside) <= margin_) return false;
      const double sign = inside > 0 ? -1 : 1;
      for (int k = 0; k < 3; ++k) {
        const Index u = sides[k], v = sides[(k + 1) % 3];
        if (std::all_of(other.begin(), other.end(),
                        [&](Index w) { return w == u || w == v || sign * area(u, v, w) > margin_; }))
          return true;
      }
      return false;
    };
    return separates(first, second) || separates(second, first);
  }

  void look(const Box& x, const Box& y, bool meet, Intersections& found) const {
    const auto s = static_cast<Index>(x.number), t = static_cast<Index>(y.number);
    const Triangle &first = triangles_[x.number], &second = triangles_[y.number];
    unsigned own_s = 0, own_t = 7;  // the vertices that the other does not have
    for (int i = 0; i < 3; ++i) {
      bool common = false;
      for (int k = 0; k < 3; ++k)
        if (first[i] == second[k]) common = true, own_t &= ~(1u << k);
      if (!common) own_s |= 1u << i;
    }
    const Plane plane_s(*this, first), plane_t(*this, second);
    bool contact = false;
    for (int i = 0; i < 3; ++i) {
      if (own_s >> i & 1 && is_near(first[i], y, second, plane_t))
        add(found.contacts, Contact{first[i], t}, most_), contact = true;
      if (own_t >> i & 1 && is_near(second[i], x, first, plane_s))
        add(found.contacts, Contact{second[i], s}, most_), contact = true;
    }
    const std::array<Index, 2> pair{std::min(s, t), std::max(s, t)};
    if (own_s == 7 && !meet &&
        (contact || (!plane_s.far_side(*this, second) && !plane_t.far_side(*this, first) &&
                     edges_near(first, second)))) {
      ++found.near_count;
      add(found.near, pair, most_);
    }
    if (own_s != 0 && (own_s & (own_s - 1)) == 0) {  // a common edge
      const int i = own_s >> 1, k = own_t >> 1;      // positions of the apexes
      if (meet || (plane_s.normal.dot(plane_t.normal) <= 0 && edges_cross(first, i, second, k)))
        add(found.folds, pair, most_);
    }
  }

 private:
  // What is far from a triangle's plane, quickly; where its normal is not to be trusted nothing is.
  struct Plane {
    Eigen::Vector3d origin, normal;
    double bound =
        std::numeric_limits<double>::infinity();  // of the square of what is near, times the normal's

    Plane(const Nearby& all, const Triangle& t) : origin(all.at(t[0])) {
      const Eigen::Vector3d b = all.at(t[1]) - origin, c = all.at(t[2]) - origin;
      normal = b.cross(c);
      const double square = normal.squaredNorm();
      if (square > 1e-12 * b.squaredNorm() * c.squaredNorm() && std::isnormal(square))
        bound = 4 * all.room_ * all.room_ * square;
    }
    double height(const Eigen::Vector3d& p) const { return normal.dot(p - origin); }
    bool far(const Eigen::Vector3d& p) const {
      const double h = height(p);
      return h * h > bound;
    }
    bool far_side(const Nearby& all, const Triangle& t) const {
      const double a = height(all.at(t[0])), b = height(all.at(t[1])), c = height(all.at(t[2]));
      return ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) && a * a > bound && b * b > bound &&
             c * c > bound;
    }
  };

  const Eigen::Vector3d& at(Index v) const { return points_[static_cast<std::size_t>(v)]; }

  bool is_near(Index v, const Box& box, const Triangle& t, const Plane& plane) const {
    return in_box(at(v), box) && !plane.far(at(v)) && near_.to_triangle(v, t) <= near_.limit();
  }

  bool segments_near(Index a, Index b, Index c, Index d) const {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(at(a)[k], at(b)[k]);
      const auto [other_low, other_high] = std::minmax(at(c)[k], at(d)[k]);
      if (low - other_high > room_ || other_low - high > room_) return false;
    }
    return near_.between_segments(a, b, c, d) <= near_.limit();
  }

  bool edges_near(const Triangle& s, const Triangle& t) const {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (segments_near(s[i], s[(i + 1) % 3], t[k], t[(k + 1) % 3])) return true;
    return false;
  }

  // Of two triangles with a common edge: from an end of it to the one's apex, and from the other end to the
  // other's.
  bool edges_cross(const Triangle& s, int i, const Triangle& t, int k) const {
    const Index a = s[(i + 1) % 3], b = s[(i + 2) % 3];
    return segments_near(a, s[i], b, t[k]) || segments_near(b, s[i], a, t[k]);
  }

  std::span<const Eigen::Vector3d> points_;
  std::span<const Triangle> triangles_;
  const Near& near_;
  double room_;    // what is near [length]
  double margin_;  // [length^2]
  std::size_t most_;
};

}  // namespace

Intersections self_intersections(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                 const std::vector<std::uint8_t>& excluded, std::size_t most,
                                 const Near* near) {
  if (near && !near->usable()) near = nullptr;
  const double room = near ? near->limit() * near->diagonal() : 0;
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (excluded.empty() || !excluded[t]) {
      boxes.push_back(box_of(points, triangles[t], t));
      for (int k = 0; k < 3; ++k) boxes.back().low[k] -= room, boxes.back().high[k] += room;
    }
  Intersections result;
  if (boxes.empty()) return result;

  const Slabs slabs = make_slabs(boxes);
  std::vector<std::uint32_t> begins(triangles.size()), ends(triangles.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
    begins[boxes[i].number] = slabs.slab_of(boxes[i].low[slabs.axis]);
    ends[boxes[i].number] = slabs.slab_of(boxes[i].high[slabs.axis]);
  });
  const std::optional<Nearby> nearby =
      near ? std::optional<Nearby>(std::in_place, points, triangles, *near, most) : std::nullopt;
  std::mutex joining;
  tbb::parallel_for(
      std::size_t{0}, slabs.splits.size() + 1,
      [&](std::size_t slab) {
        std::vector<Box> mine;
        for (const Box& box : boxes)
          if (begins[box.number] <= slab && slab <= ends[box.number]) mine.push_back(box);
        Intersections found;
        const auto meet = [&](const Box& x, const Box& y) {
          if (std::max(begins[x.number], begins[y.number]) != slab) return;
          const auto [low, high] = std::minmax({static_cast<Index>(x.number), static_cast<Index>(y.number)});
          if (nearby && nearby->wide_apart(triangles[low], triangles[high])) return;
          const bool meeting = triangles_meet(points, triangles[low], triangles[high]);
          if (meeting) {
            ++found.count;
            add(found.pairs, std::array<Index, 2>{low, high}, most);
          }
          if (nearby) nearby->look(x, y, meeting, found);
        };
        // Below the cutoff it sweeps instead of splitting further; 1000 takes half the time of its
        // default, 10.
        CGAL::box_self_intersection_d(mine.begin(), mine.end(), meet,
                                      CGAL::Box_intersection_d::Box_traits_d<Box>(), 1000,
                                      CGAL::Box_intersection_d::CLOSED);
        // The first of a union are the first of its parts' first, in whatever order the parts come.
        const std::lock_guard lock(joining);
        const auto join = [&](auto& all, const auto& part) {
          all.insert(all.end(), part.begin(), part.end());
          if (all.size() > 2 * most + 1024) keep_first(all, most);
        };
        result.count += found.count;
        result.near_count += found.near_count;
        join(result.pairs, found.pairs);
        join(result.contacts, found.contacts);
        join(result.folds, found.folds);
        join(result.near, found.near);
      },
      tbb::simple_partitioner());
  keep_first(result, most);
  return result;
}

}  // namespace tetproof::verify
