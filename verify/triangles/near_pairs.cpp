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

// A quick test for points far from the plane of a triangle 0 b c.
//
// Why nothing near counts as far: the boxes of the pair meet, so all its points p are within 4 E of the
// origin, where E is the longest edge of both. With the rounding unit e = 2^-53, the normal is off by less
// than 7 e |b| |c|, and its product with p by less than 28 e |b| |c| E more. So a point within the pair's
// room of the plane has a computed height of at most room |normal| + 56 e |b| |c| E, which is below `bound`.
// Underflow changes a height by less than 2^-1070; while |b| |c| is above `least`, that is far below the
// bound. Beyond `least` and `most` no point counts as far, and neither where something overflows.
struct Nearby::Plane {
  Eigen::Vector3d origin, normal;
  double bound = std::numeric_limits<double>::infinity();

  // `other`: the other triangle of the pair.
  Plane(const Nearby& all, Index t, Index other) : origin(all.at(all.triangle(t)[0])) {
    const Eigen::Vector3d b = all.at(all.triangle(t)[1]) - origin, c = all.at(all.triangle(t)[2]) - origin;
    normal = b.cross(c);
    const double lengths = b.norm() * c.norm();
    if (lengths > least && lengths < most)
      bound = 2 * all.near_.room(t, other) * normal.norm() +
              near_error * lengths * std::max(all.near_.size(t), all.near_.size(other));
  }
  double height(const Eigen::Vector3d& p) const { return normal.dot(p - origin); }
  bool far(const Eigen::Vector3d& p) const { return std::abs(height(p)) > bound; }
  // Whether all corners of a triangle are far on the same side.
  bool far_side(const Nearby& all, Index t) const {
    const Triangle& v = all.triangle(t);
    const double a = height(all.at(v[0])), b = height(all.at(v[1])), c = height(all.at(v[2]));
    return (a > bound && b > bound && c > bound) || (a < -bound && b < -bound && c < -bound);
  }

  static constexpr double least = 1e-140, most = 1e140;
};

// Why this dismisses no pair that meets or is near. Let u v be the side of one triangle, w a vertex of the
// other one, and e the rounding unit 2^-53. The computed area is off by less than 4 e (|first| + |second|),
// where these are its two products, and by underflow of less than 2^-1072; both are subtracted. If a product
// overflows, the comparison is false. So the sign is right: w lies strictly beyond the line of the side in
// the projection. The other triangle has at most one vertex on that line, one that the two share, so the
// triangles meet in nothing else.
// The exact area is also larger than 2 room E, where room and E are the larger ones of the two triangles. A
// vertex w is then farther than 2 room from the side's line, because no side is longer than E. If the other
// triangle shares the end u of the side, the distance of the other end v from each of its edges u w is the
// same area divided by |u w|, so it is farther than 2 room, too.
bool Nearby::wide_apart(Index first, Index second) const {
  const Triangle &s = triangle(first), &t = triangle(second);
  const Eigen::Vector3d &a = at(s[0]), &b = at(s[1]), &c = at(s[2]);
  Eigen::Index along = 0;
  (b - a).cross(c - a).cwiseAbs().maxCoeff(&along);
  const Eigen::Index x = (along + 1) % 3, y = (along + 2) % 3;
  const double wide = 2 * near_.room(first, second) * std::max(near_.size(first), near_.size(second));
  // 1 or -1: the side of the line from u to v on which w lies, if it is wide of it; else 0.
  const auto side = [&](Index u, Index v, Index w) {
    const Eigen::Vector3d &p = at(u), &q = at(v), &r = at(w);
    const double one = (q[x] - p[x]) * (r[y] - p[y]), other = (q[y] - p[y]) * (r[x] - p[x]);
    const double area = one - other;
    const double bound = 1.000001 * wide + 1e-15 * (std::abs(one) + std::abs(other)) + 0x1p-1070;
    return area > bound ? 1 : area < -bound ? -1 : 0;
  };
  const auto separates = [&](const Triangle& sides, const Triangle& other) {
    const int inside = side(sides[0], sides[1], sides[2]);
    if (inside == 0) return false;
    for (int k = 0; k < 3; ++k) {
      const Index u = sides[k], v = sides[(k + 1) % 3];
      if (std::all_of(other.begin(), other.end(),
                      [&](Index w) { return w == u || w == v || side(u, v, w) == -inside; }))
        return true;
    }
    return false;
  };
  return separates(s, t) || separates(t, s);
}

bool Nearby::is_near(Index v, const Box& box, Index t, const Plane& plane) const {
  return in_box(at(v), box) && !plane.far(at(v)) && near_.on_triangle(v, t);
}

bool Nearby::segments_near(Index a, Index b, Index s, Index c, Index d, Index t) const {
  const double reach = near_.room(s, t);
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(at(a)[k], at(b)[k]);
    const auto [other_low, other_high] = std::minmax(at(c)[k], at(d)[k]);
    if (low - other_high > reach || other_low - high > reach) return false;
  }
  return near_.edges_near(a, b, s, c, d, t);
}

bool Nearby::edges_near(Index s, Index t) const {
  const Triangle &first = triangle(s), &second = triangle(t);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (segments_near(first[i], first[(i + 1) % 3], s, second[k], second[(k + 1) % 3], t)) return true;
  return false;
}

// For two triangles with a common edge: whether the edge from one of its ends to one apex crosses, or nearly
// crosses, the edge from the other end to the other apex.
bool Nearby::edges_cross(Index s, int i, Index t, int k) const {
  const Triangle& first = triangle(s);
  const Index a = first[(i + 1) % 3], b = first[(i + 2) % 3], p = first[i], q = triangle(t)[k];
  return segments_near(a, p, s, b, q, t) || segments_near(b, p, s, a, q, t);
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
  const Plane plane_s(*this, s, t), plane_t(*this, t, s);
  const auto add = [&](const Contact& contact) { found.contacts[found.contact_count++] = contact; };
  for (int i = 0; i < 3; ++i) {
    if (own_s >> i & 1 && is_near(first[i], y, t, plane_t)) add({first[i], t});
    if (own_t >> i & 1 && is_near(second[i], x, s, plane_s)) add({second[i], s});
  }
  if (own_s == 7 && !meet &&
      (found.contact_count > 0 ||
       (!plane_s.far_side(*this, t) && !plane_t.far_side(*this, s) && edges_near(s, t)))) {
    found.near = true;
  }
  if (own_s != 0 && (own_s & (own_s - 1)) == 0) {  // a common edge
    const int i = own_s >> 1, k = own_t >> 1;      // positions of the apexes
    // Where the product overflows, it may be no number: then they may well be folded.
    if (meet || (!(plane_s.normal.dot(plane_t.normal) > 0) && edges_cross(s, i, t, k))) found.fold = true;
  }
  return found;
}

}  // namespace tetproof::verify
