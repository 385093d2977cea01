// SPDX-License-Identifier: GPL-3.0-or-later
// Brute force in rational arithmetic: where a point lies, and where a segment meets a surface. No code shared
// with reference/.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "io/triangle_surface.hpp"
#include "tests/support/exact_mesh.hpp"

namespace exact_surface {

using exact_mesh::exact;
using exact_mesh::Point;
using exact_mesh::Rational;

inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The closed interval of t in which origin + t * direction lies in the closed triangle, by barycentric
/// coordinates; t is not bounded.
inline std::optional<std::array<Rational, 2>> line_in_triangle(const Point& origin, const Point& direction,
                                                               const std::array<Point, 3>& t) {
  const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const Rational slope = dot(normal, direction), height = dot(normal, minus(origin, t[0]));
  if (slope == 0 && height != 0) return std::nullopt;
  // Each barycentric coordinate is linear in t along the line: b(t) = b0 + t b1.
  std::array<Rational, 2> range;
  bool bounded[2] = {false, false};
  const auto limit = [&](int end, const Rational& t0) {
    if (!bounded[end] || (end == 0 ? t0 > range[0] : t0 < range[1])) range[end] = t0;
    bounded[end] = true;
  };
  if (slope != 0) {
    limit(0, -height / slope);
    limit(1, -height / slope);
  }
  for (int c = 0; c < 3; ++c) {
    const Point inward = cross(normal, minus(t[(c + 1) % 3], t[c]));
    const Rational b0 = dot(inward, minus(origin, t[c])), b1 = dot(inward, direction);
    if (b1 == 0) {
      if (b0 < 0) return std::nullopt;
    } else {
      limit(b1 > 0 ? 0 : 1, -b0 / b1);
    }
  }
  if (range[0] > range[1]) return std::nullopt;
  return range;
}

class Surface {
 public:
  explicit Surface(const tetproof::TriangleSurface& s) {
    for (const auto& [a, b, c] : s.triangles) {
      triangles_.push_back({exact(s.vertices[a]), exact(s.vertices[b]), exact(s.vertices[c])});
      lowest_.push_back(s.vertices[a].cwiseMin(s.vertices[b]).cwiseMin(s.vertices[c]));
      highest_.push_back(s.vertices[a].cwiseMax(s.vertices[b]).cwiseMax(s.vertices[c]));
    }
  }

  /// -1 outside, 0 on the surface, 1 inside: by a ray in a direction that meets no edge.
  int locate(const Eigen::Vector3d& from) const {
    const Point p = exact(from);
    for (int attempt = 0;; ++attempt) {
      const Point direction{Rational(1), Rational(attempt * 37 + 11, 101), Rational(attempt * 53 + 7, 1009)};
      int crossings = 0;
      bool clean = true;
      for (std::size_t n = 0; n < triangles_.size(); ++n) {
        if ((highest_[n].array() < from.array()).any()) continue;  // the ray runs upwards in every coordinate
        const auto& t = triangles_[n];
        const auto hit = line_in_triangle(p, direction, t);
        if (!hit) continue;
        if ((*hit)[0] <= 0 && (*hit)[1] >= 0) return 0;
        if ((*hit)[1] < 0) continue;
        const Point at{p[0] + (*hit)[0] * direction[0], p[1] + (*hit)[0] * direction[1],
                       p[2] + (*hit)[0] * direction[2]};
        clean = clean && (*hit)[0] == (*hit)[1] && strictly_inside(at, t);
        ++crossings;
      }
      if (clean) return crossings % 2 ? 1 : -1;
    }
  }

  /// The ends of the maximal pieces that segment ab has in common with the surface, as parameters in the open
  /// interval (0,1), ascending, each once.
  std::vector<Rational> points_on(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const Point a = exact(from), b = exact(to);
    const Eigen::Vector3d low = from.cwiseMin(to), high = from.cwiseMax(to);
    std::vector<std::array<Rational, 2>> pieces;
    for (std::size_t n = 0; n < triangles_.size(); ++n) {
      if ((highest_[n].array() < low.array()).any() || (lowest_[n].array() > high.array()).any()) continue;
      auto hit = line_in_triangle(a, minus(b, a), triangles_[n]);
      if (!hit) continue;
      (*hit)[0] = std::max((*hit)[0], Rational(0));
      (*hit)[1] = std::min((*hit)[1], Rational(1));
      if ((*hit)[0] <= (*hit)[1]) pieces.push_back(*hit);
    }
    std::sort(pieces.begin(), pieces.end());
    std::vector<Rational> ends;
    for (std::size_t first = 0; first < pieces.size();) {
      Rational reach = pieces[first][1];
      std::size_t next = first + 1;
      while (next < pieces.size() && pieces[next][0] <= reach) reach = std::max(reach, pieces[next++][1]);
      for (const Rational& end : {pieces[first][0], reach})
        if (end > 0 && end < 1 && (ends.empty() || ends.back() != end)) ends.push_back(end);
      first = next;
    }
    return ends;
  }

 private:
  static bool strictly_inside(const Point& p, const std::array<Point, 3>& t) {
    const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    for (int c = 0; c < 3; ++c)
      if (dot(cross(normal, minus(t[(c + 1) % 3], t[c])), minus(p, t[c])) <= 0) return false;
    return true;
  }

  std::vector<std::array<Point, 3>> triangles_;
  std::vector<Eigen::Vector3d> lowest_, highest_;  // of each, exact: they select nothing but what cannot meet
};

}  // namespace exact_surface
