// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/exact/exact_pairs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "corpus/exact/exact_integers.hpp"

namespace tetproof::corpus {
namespace {

// A direction along which two tetrahedra may be separated: the cross product of two differences of corners.
struct Axis {
  std::array<int, 4> ends;  // the corners of the two differences, from 0 to 7
  double gap;    // between the two tetrahedra [length], in doubles: only to try likely directions first
  bool flipped;  // whether the second tetrahedron is below the first
};

constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::vector<Axis> axes(const std::array<Eigen::Vector3d, 8>& p) {
  std::vector<Axis> found;
  found.reserve(44);
  const auto add = [&](int a, int b, int c, int d) {
    const Eigen::Vector3d n = (p[b] - p[a]).cross(p[d] - p[c]);
    const double length = n.norm();
    double low[2], high[2];
    for (int i = 0; i < 8; ++i) {
      const double h = length > 0 ? n.dot(p[i] - p[0]) / length : 0;
      if (i % 4 == 0) low[i / 4] = high[i / 4] = h;
      low[i / 4] = std::min(low[i / 4], h);
      high[i / 4] = std::max(high[i / 4], h);
    }
    const double up = low[1] - high[0], down = low[0] - high[1];
    found.push_back({{a, b, c, d}, std::max(up, down), down > up});
  };
  for (const int base : {0, 4})
    for (const auto& f : tet_faces) add(base + f[0], base + f[1], base + f[0], base + f[2]);
  for (const auto& e : edges)
    for (const auto& f : edges) add(e[0], e[1], 4 + f[0], 4 + f[1]);
  return found;
}

// The sign of the area of triangle p q r, which lies in a plane with this normal.
int turn(const IntegerPoint& normal, const IntegerPoint& p, const IntegerPoint& q, const IntegerPoint& r) {
  return dot(normal, cross(q - p, r - p)).sign();
}

// Whether p lies in the convex hull of one to three corners, all in a plane with this normal.
bool in_hull(const IntegerPoint& normal, const IntegerPoint& p, const std::vector<IntegerPoint>& hull) {
  if (hull.size() == 1) return p == hull[0];
  if (hull.size() == 2) {
    const IntegerPoint way = hull[1] - hull[0], to = p - hull[0];
    if (cross(way, to) != IntegerPoint{0, 0, 0}) return false;
    const Integer share = dot(way, to);
    return share >= 0 && share <= dot(way, way);
  }
  bool left = true, right = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = turn(normal, hull[k], hull[(k + 1) % 3], p);
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

}  // namespace

Meeting meeting(const Corners& a, const std::array<Index, 4>& one, const Corners& b,
                const std::array<Index, 4>& other) {
  std::array<Eigen::Vector3d, 8> points;
  std::copy(a.begin(), a.end(), points.begin());
  std::copy(b.begin(), b.end(), points.begin() + 4);
  const int unit = last_bit(points);
  std::array<IntegerPoint, 8> p;
  for (int i = 0; i < 8; ++i) p[i] = integers(points[i], unit);
  const auto is_common = [&](int i) {
    return i < 4 ? std::count(other.begin(), other.end(), one[i]) > 0
                 : std::count(one.begin(), one.end(), other[i - 4]) > 0;
  };

  Meeting result;
  // The widest gap is tried first: it usually decides.
  std::vector<Axis> left = axes(points);
  while (!left.empty()) {
    const auto widest = std::max_element(left.begin(), left.end(),
                                         [](const Axis& x, const Axis& y) { return x.gap < y.gap; });
    const Axis axis = *widest;
    left.erase(widest);
    const IntegerPoint n = cross(p[axis.ends[1]] - p[axis.ends[0]], p[axis.ends[3]] - p[axis.ends[2]]);
    if (n == IntegerPoint{0, 0, 0}) continue;
    const int lower = axis.flipped ? 4 : 0, upper = 4 - lower;
    std::array<Integer, 8> height;
    for (int i = 0; i < 8; ++i) height[i] = dot(n, p[i]);
    const Integer top = *std::max_element(&height[lower], &height[lower] + 4),
                  bottom = *std::min_element(&height[upper], &height[upper] + 4);
    if (top > bottom) continue;
    if (top < bottom) return result;
    // The two touch, in this plane only. Find the corners of each that lie in it.
    std::array<std::vector<int>, 2> in_plane;
    for (int i = 0; i < 8; ++i)
      if (height[i] == top) in_plane[i / 4].push_back(i);
    for (const auto& side : in_plane)
      if (std::all_of(side.begin(), side.end(), is_common)) return result;  // they meet in a common simplex
    std::array<std::vector<IntegerPoint>, 2> hull;
    for (int s = 0; s < 2; ++s)
      for (const int i : in_plane[s]) hull[s].push_back(p[i]);
    for (int s = 0; s < 2; ++s)
      for (const int i : in_plane[s])
        if (!is_common(i) && in_hull(n, p[i], hull[1 - s]))
          (s == 0 ? result.one_in_other : result.other_in_one).push_back(i % 4);
    for (std::size_t i = 0; i < in_plane[0].size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        for (std::size_t l = 0; l < in_plane[1].size(); ++l)
          for (std::size_t m = 0; m < l; ++m) {
            const IntegerPoint &u = hull[0][i], &v = hull[0][k], &x = hull[1][l], &y = hull[1][m];
            if (turn(n, u, v, x) * turn(n, u, v, y) < 0 && turn(n, x, y, u) * turn(n, x, y, v) < 0)
              result.crossing = true;
          }
    return result;
  }
  result.overlap = true;
  return result;
}

bool partly_on_each_other(const std::array<Eigen::Vector3d, 3>& f, const std::array<Eigen::Vector3d, 3>& g) {
  std::array<Eigen::Vector3d, 6> points;
  std::copy(f.begin(), f.end(), points.begin());
  std::copy(g.begin(), g.end(), points.begin() + 3);
  const int unit = last_bit(points);
  std::array<IntegerPoint, 6> p;
  for (int i = 0; i < 6; ++i) p[i] = integers(points[i], unit);
  const IntegerPoint n = cross(p[1] - p[0], p[2] - p[0]);
  for (int i = 3; i < 6; ++i)
    if (dot(n, p[i] - p[0]) != 0) return false;
  int common = 0;
  for (int i = 0; i < 3; ++i) common += std::count(p.begin() + 3, p.end(), p[i]) > 0;
  if (common == 3) return false;
  // Two convex polygons have no area in common if the line of an edge separates them.
  for (int first = 0; first < 6; first += 3)
    for (int k = 0; k < 3; ++k) {
      const IntegerPoint &a = p[first + k], &b = p[first + (k + 1) % 3];
      const int inside = turn(n, a, b, p[first + (k + 2) % 3]);
      bool separates = true;
      for (int i = 0; i < 3; ++i) separates = separates && turn(n, a, b, p[3 - first + i]) != inside;
      if (separates) return false;
    }
  return true;
}

}  // namespace tetproof::corpus
