// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/near_pairs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tetproof::verify {
namespace {

bool in_box(const Eigen::Vector3d& p, const Box& box) {
  return p.x() >= box.low[0] && p.x() <= box.high[0] && p.y() >= box.low[1] && p.y() <= box.high[1] &&
         p.z() >= box.low[2] && p.z() <= box.high[2];
}

}  // namespace

// A quick test for points far from a triangle's plane. If the normal is not reliable, no point counts as far.
struct Nearby::Plane {
  Eigen::Vector3d origin, normal;
  // The square of twice the near distance, times the squared length of the normal.
  double bound = std::numeric_limits<double>::infinity();

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

// The area test puts a vertex beyond a side's line by at least `margin_` / (length of the side), so the
// vertex is farther than 2 room_ from the triangle on the other side of that line. One end of the side may be
// shared: the other triangle then has one vertex on the line and the rest beyond, and the side's other end is
// as far from it. Rounding is a thousand times smaller than the margin.
bool Nearby::wide_apart(const Triangle& first, const Triangle& second) const {
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

bool Nearby::is_near(Index v, const Box& box, const Triangle& t, const Plane& plane) const {
  return in_box(at(v), box) && !plane.far(at(v)) && near_.to_triangle(v, t) <= near_.limit();
}

bool Nearby::segments_near(Index a, Index b, Index c, Index d) const {
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(at(a)[k], at(b)[k]);
    const auto [other_low, other_high] = std::minmax(at(c)[k], at(d)[k]);
    if (low - other_high > room_ || other_low - high > room_) return false;
  }
  return near_.between_segments(a, b, c, d) <= near_.limit();
}

bool Nearby::edges_near(const Triangle& s, const Triangle& t) const {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (segments_near(s[i], s[(i + 1) % 3], t[k], t[(k + 1) % 3])) return true;
  return false;
}

// For two triangles with a common edge: whether the edge from one of its ends to one apex crosses, or nearly
// crosses, the edge from the other end to the other apex.
bool Nearby::edges_cross(const Triangle& s, int i, const Triangle& t, int k) const {
  const Index a = s[(i + 1) % 3], b = s[(i + 2) % 3];
  return segments_near(a, s[i], b, t[k]) || segments_near(b, s[i], a, t[k]);
}

PairNearness Nearby::look(const Box& x, const Box& y, bool meet) const {
  PairNearness found;
  const auto s = static_cast<Index>(x.number), t = static_cast<Index>(y.number);
  const Triangle &first = triangles_[x.number], &second = triangles_[y.number];
  unsigned own_s = 0, own_t = 7;  // bits of the vertices that the other triangle does not have
  for (int i = 0; i < 3; ++i) {
    bool common = false;
    for (int k = 0; k < 3; ++k)
      if (first[i] == second[k]) common = true, own_t &= ~(1u << k);
    if (!common) own_s |= 1u << i;
  }
  const Plane plane_s(*this, first), plane_t(*this, second);
  const auto add = [&](const Contact& contact) { found.contacts[found.contact_count++] = contact; };
  for (int i = 0; i < 3; ++i) {
    if (own_s >> i & 1 && is_near(first[i], y, second, plane_t)) add({first[i], t});
    if (own_t >> i & 1 && is_near(second[i], x, first, plane_s)) add({second[i], s});
  }
  if (own_s == 7 && !meet &&
      (found.contact_count > 0 ||
       (!plane_s.far_side(*this, second) && !plane_t.far_side(*this, first) && edges_near(first, second)))) {
    found.near = true;
  }
  if (own_s != 0 && (own_s & (own_s - 1)) == 0) {  // a common edge
    const int i = own_s >> 1, k = own_t >> 1;      // positions of the apexes
    if (meet || (plane_s.normal.dot(plane_t.normal) <= 0 && edges_cross(first, i, second, k)))
      found.fold = true;
  }
  return found;
}

}  // namespace tetproof::verify
