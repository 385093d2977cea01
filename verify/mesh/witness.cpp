// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/mesh/witness.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace tetproof::verify {
namespace {

using Rational = CGAL::Gmpq;
using Point = std::array<Rational, 3>;

Point operator-(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
Rational dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// A tetrahedron as four corners and as four half-spaces.
struct Tetrahedron {
  std::array<Point, 4> corners;
  std::array<Point, 4> inwards;  // the inward normal of the face opposite to each corner

  Tetrahedron(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& tet) {
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) corners[i][k] = Rational(points[static_cast<std::size_t>(tet[i])][k]);
    for (int i = 0; i < 4; ++i) {
      const Point& origin = on_face(i);
      inwards[i] = cross(corners[tet_faces[i][1]] - origin, corners[tet_faces[i][2]] - origin);
      if (height(i, corners[i]) < 0)
        for (Rational& x : inwards[i]) x = -x;
    }
  }
  const Point& on_face(int i) const { return corners[tet_faces[i][0]]; }
  Rational height(int i, const Point& p) const { return dot(inwards[i], p - on_face(i)); }
  bool flat() const { return height(0, corners[0]) == 0; }
  bool holds(const Point& p) const {
    for (int i = 0; i < 4; ++i)
      if (height(i, p) < 0) return false;
    return true;
  }
  bool holds_inside(const Point& p) const {
    for (int i = 0; i < 4; ++i)
      if (height(i, p) <= 0) return false;
    return true;
  }
};

// Adds corners of the common part: corners of `one` inside `other`, and points where edges of `one` cross
// faces of `other`.
void add_corners(const Tetrahedron& one, const Tetrahedron& other, std::vector<Point>& corners) {
  for (int i = 0; i < 4; ++i) {
    if (other.holds(one.corners[i])) corners.push_back(one.corners[i]);
    for (int k = i + 1; k < 4; ++k)
      for (int face = 0; face < 4; ++face) {
        const Point &p = one.corners[i], &q = one.corners[k];
        const Rational hp = other.height(face, p), hq = other.height(face, q);
        if (!((hp < 0 && hq > 0) || (hp > 0 && hq < 0))) continue;
        const Rational share = hp / (hp - hq);
        Point x;
        for (int c = 0; c < 3; ++c) x[c] = p[c] + share * (q[c] - p[c]);
        if (other.holds(x)) corners.push_back(x);
      }
  }
}

std::string text(const Rational& value) {
  std::ostringstream out;
  out << value.numerator() << '/' << value.denominator();
  return out.str();
}

}  // namespace

std::optional<Witness> common_point(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& one,
                                    const std::array<Index, 4>& other) {
  for (int k = 0; k < 3; ++k) {
    const auto range = [&](const std::array<Index, 4>& tet) {
      std::array<double, 4> x;
      for (int i = 0; i < 4; ++i) x[i] = points[static_cast<std::size_t>(tet[i])][k];
      return std::pair(*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()));
    };
    const auto [low, high] = range(one);
    const auto [other_low, other_high] = range(other);
    if (low >= other_high || other_low >= high) return std::nullopt;
  }
  const Tetrahedron a(points, one), b(points, other);
  if (a.flat() || b.flat()) return std::nullopt;
  std::vector<Point> corners;
  add_corners(a, b, corners);
  add_corners(b, a, corners);
  if (corners.empty()) return std::nullopt;
  // If a convex body has an interior, the mean of its corners lies in it, however often each corner is
  // counted.
  Point mean{Rational(0), Rational(0), Rational(0)};
  for (const Point& p : corners)
    for (int k = 0; k < 3; ++k) mean[k] += p[k];
  Witness witness;
  Point rounded;
  for (int k = 0; k < 3; ++k) {
    mean[k] = mean[k] / Rational(static_cast<int>(corners.size()));
    witness.point[k] = CGAL::to_double(mean[k]);
    rounded[k] = Rational(witness.point[k]);
  }
  if (!a.holds_inside(mean) || !b.holds_inside(mean)) return std::nullopt;
  const bool double_says_it = a.holds_inside(rounded) && b.holds_inside(rounded);
  for (int k = 0; k < 3; ++k) witness.exact[k] = text(double_says_it ? rounded[k] : mean[k]);
  return witness;
}

}  // namespace tetproof::verify
