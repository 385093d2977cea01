// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps ask about points and triangles. An answer that decides is exact for the doubles as given; an
// answer that measures is the plain formula.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tetproof::reference::paper {

using Point = Eigen::Vector3d;
using Triangle = std::array<Point, 3>;
using Rational = boost::multiprecision::cpp_rational;
using ExactPoint = std::array<Rational, 3>;
using Interval = std::pair<Rational, Rational>;  ///< from the first to the last number, both included

inline bool lexicographically_less(const Point& a, const Point& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}
inline constexpr auto by_coordinates = [](const Point& a, const Point& b) {
  return lexicographically_less(a, b);
};
inline Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end(), by_coordinates);
  return t;
}
inline bool lexicographically_less(const Triangle& a, const Triangle& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), by_coordinates);
}

inline ExactPoint exact(const Point& p) {
  return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}

/// (b-a) x (c-a) . (d-a), exactly.
inline Rational determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  ExactPoint o = exact(a), u = exact(b), v = exact(c), w = exact(d);
  for (int x = 0; x < 3; ++x) u[x] -= o[x], v[x] -= o[x], w[x] -= o[x];
  return w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
         w[2] * (u[0] * v[1] - u[1] * v[0]);
}

/// The sums of the magnitudes of the terms of u x v.
inline Point magnitudes_of_cross(const Point& u, const Point& v) {
  const Point a = u.cwiseAbs(), b = v.cwiseAbs();
  return {a.y() * b.z() + a.z() * b.y(), a.z() * b.x() + a.x() * b.z(), a.x() * b.y() + a.y() * b.x()};
}

/// The sign of (b-a) x (c-a) . (d-a): +1 if (a,b,c,d) is positive. Exact. In doubles, rounding changes the
/// determinant by less than 8e-16 of the sum of the magnitudes of its terms; underflow changes it by less
/// than 20 times the smallest double times the longest difference, which is far below 1e-230.
inline int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = c - a, w = d - a;
  const double quick = w.dot(u.cross(v)), size = w.cwiseAbs().dot(magnitudes_of_cross(u, v));
  const double longest = u.cwiseAbs().cwiseMax(v.cwiseAbs()).cwiseMax(w.cwiseAbs()).maxCoeff();
  if (longest < 1e90 && std::abs(quick) > 1e-15 * size + 1e-230) return quick > 0 ? 1 : -1;
  return determinant(a, b, c, d).sign();
}

/// Whether all points of `a` are beyond all points of `b` along an axis.
template <std::size_t M, std::size_t N>
bool apart(const std::array<Point, M>& a, const std::array<Point, N>& b) {
  for (int x = 0; x < 3; ++x) {
    const auto less = [x](const Point& p, const Point& q) { return p[x] < q[x]; };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), less);
    if (less(*a_high, *b_low) || less(*b_high, *a_low)) return true;
  }
  return false;
}

/// The part of the edge p + s (q-p), 0 <= s <= 1, that lies on a triangle in one plane with it. Exact: an
/// intersection of three half-planes, in a projection in which the triangle has an area.
inline std::optional<Interval> part_in_plane(const Point& p, const Point& q, const Triangle& triangle) {
  const std::array<ExactPoint, 3> t{exact(triangle[0]), exact(triangle[1]), exact(triangle[2])};
  for (int u = 0, v = 1; u < 3; ++u, v = (u + 1) % 3) {
    const auto side = [u, v](const ExactPoint& a, const ExactPoint& b, const ExactPoint& x) -> Rational {
      return (b[u] - a[u]) * (x[v] - a[v]) - (b[v] - a[v]) * (x[u] - a[u]);
    };
    const int area = side(t[0], t[1], t[2]).sign();
    if (area == 0) continue;
    Interval part(0, 1);
    for (int i = 0; i < 3; ++i) {
      const Rational at_p = area * side(t[i], t[(i + 1) % 3], exact(p));
      const Rational at_q = area * side(t[i], t[(i + 1) % 3], exact(q));
      if (at_p < 0 && at_q < 0) return std::nullopt;
      if (at_p < 0) part.first = std::max(part.first, Rational(at_p / (at_p - at_q)));
      if (at_q < 0) part.second = std::min(part.second, Rational(at_p / (at_p - at_q)));
    }
    if (part.first <= part.second) return part;
    return std::nullopt;
  }
  return std::nullopt;  // a triangle without an area
}

inline bool in_plane(const Point& p, const Triangle& t) {
  return orientation(t[0], t[1], t[2], p) == 0;
}

/// The part of the edge p + s (q-p), 0 <= s <= 1, that lies on the closed triangle. Exact.
inline std::optional<Interval> common_part(const Point& p, const Point& q, const Triangle& t) {
  if (apart(std::array{p, q}, t)) return std::nullopt;
  const int at_p = orientation(t[0], t[1], t[2], p), at_q = orientation(t[0], t[1], t[2], q);
  if (at_p == 0 && at_q == 0) return part_in_plane(p, q, t);
  const auto [least, most] = std::minmax(
      {orientation(p, q, t[0], t[1]), orientation(p, q, t[1], t[2]), orientation(p, q, t[2], t[0])});
  if (at_p == at_q || (least < 0 && most > 0)) return std::nullopt;  // the line passes beside the triangle
  const Rational to_p = determinant(t[0], t[1], t[2], p), to_q = determinant(t[0], t[1], t[2], q);
  return Interval(to_p / (to_p - to_q), to_p / (to_p - to_q));
}

/// Whether p lies on the closed triangle. Exact.
inline bool is_on(const Triangle& t, const Point& p) {
  return !apart(t, std::array{p}) && in_plane(p, t) && part_in_plane(p, p, t);
}

/// Whether the line in the direction of x crosses the triangle before it comes to p, which is not on the
/// triangle. The line counts as moved by (epsilon, epsilon^2) in y and z (reading D4). Exact.
inline bool crosses_before(const Triangle& t, const Point& p) {
  if (apart(std::array{Point(t[0].x(), p.y(), p.z())}, t)) return false;
  const auto turn = [](const Point& a, const Point& b, const Point& c) {  // in the plane of y and z
    return orientation({0, a.y(), a.z()}, {0, b.y(), b.z()}, {0, c.y(), c.z()}, {1, 0, 0});
  };
  const int facing = turn(t[0], t[1], t[2]);  // +1: the normal points to +x; 0: the triangle is parallel to x
  for (int i = 0; i < 3; ++i) {
    const Point &a = t[i], &b = t[(i + 1) % 3];
    int side = turn(a, b, p);
    if (side == 0) side = a.z() != b.z() ? (a.z() > b.z() ? 1 : -1) : (b.y() > a.y() ? 1 : -1);
    if (side != facing) return false;
  }
  return facing * orientation(t[0], t[1], t[2], p) > 0;
}

/// The number s where the plane of the triangle cuts the edge p + s (q-p), and 1-s, in double precision.
/// Nothing if the error of s is not certified to be below 1e-12 (reading D6).
inline std::optional<std::pair<double, double>> cut_in_doubles(const Point& p, const Point& q,
                                                               const Triangle& t) {
  const Point u = t[1] - t[0], v = t[2] - t[0], to_p = p - t[0], to_q = q - t[0];
  const Point normal = u.cross(v), magnitude = magnitudes_of_cross(u, v);
  const double at_p = std::abs(to_p.dot(normal)), at_q = std::abs(to_q.dot(normal)), sum = at_p + at_q;
  const double error = 1e-15 * (to_p.cwiseAbs().dot(magnitude) + to_q.cwiseAbs().dot(magnitude));
  if (!(sum > 1e-290) || error / sum + 1e-15 > 1e-12) return std::nullopt;
  return std::pair(at_p / sum, at_q / sum);
}

/// The point of the triangle closest to p, in double precision; of several the lexicographically smallest.
inline Point closest_point(const Triangle& t, const Point& p) {
  const auto [a, b, c] = sorted(t);
  std::vector<Point> candidates;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(a, c), std::pair(b, c)}) {
    const Point d = to - from;
    const double length2 = d.squaredNorm(), s = d.dot(p - from);
    candidates.push_back(!(s > 0) ? from : s < length2 ? Point(from + (s / length2) * d) : to);
  }
  // The normal divided by a power of two, exactly: its square is the fourth power of a length, which may be
  // no double.
  const Point n = (b - a).cross(c - a), normal = n / std::exp2(std::ilogb(n.cwiseAbs().maxCoeff()));
  const auto inside = [&](const Point& u, const Point& v) { return normal.dot((v - u).cross(p - u)) >= 0; };
  if (normal.squaredNorm() > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    candidates.push_back(p - normal * (normal.dot(p - a) / normal.squaredNorm()));
  return *std::min_element(candidates.begin(), candidates.end(), [&](const Point& x, const Point& y) {
    const double to_x = (x - p).squaredNorm(), to_y = (y - p).squaredNorm();
    return to_x != to_y ? to_x < to_y : lexicographically_less(x, y);
  });
}

}  // namespace tetproof::reference::paper
