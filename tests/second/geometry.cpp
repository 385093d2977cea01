// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/second/geometry.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

#include "tests/second/edge_intersections.hpp"

namespace tetproof::second {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = std::array<Rational, 3>;

Kernel::Point_3 cgal(const Point& p) {
  return {p.x(), p.y(), p.z()};
}
Exact exact(const Point& p) {
  return {Rational(p.x()), Rational(p.y()), Rational(p.z())};
}

std::array<Point, 3> corners(const TriangleSurface& surface, std::size_t t) {
  const auto [a, b, c] = surface.triangles[t];
  return {surface.vertices[a], surface.vertices[b], surface.vertices[c]};
}

Exact minus(const Exact& a, const Exact& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Exact o = exact(a), n = cross(minus(exact(b), o), minus(exact(c), o)), e = minus(exact(d), o);
  return n[0] * e[0] + n[1] * e[1] + n[2] * e[2];
}

// On which sides of the edges of a triangle the line from p to q passes: three signs, equal if it passes
// through.
std::array<int, 3> sides(const Point& p, const Point& q, const std::array<Point, 3>& t) {
  return {orientation(p, q, t[0], t[1]), orientation(p, q, t[1], t[2]), orientation(p, q, t[2], t[0])};
}

bool mixed(const std::array<int, 3>& signs) {
  const auto [least, most] = std::minmax({signs[0], signs[1], signs[2]});
  return least < 0 && most > 0;
}

// The part of an edge in the plane of a triangle that lies in the triangle. Exact, in the projection along an
// axis that does not flatten the triangle.
std::vector<std::pair<Rational, Rational>> coplanar_part(const Point& p, const Point& q,
                                                         const std::array<Point, 3>& triangle) {
  const std::array<Exact, 3> t{exact(triangle[0]), exact(triangle[1]), exact(triangle[2])};
  const Exact normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const int drop = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const auto side = [&](const Exact& a, const Exact& b, const Exact& x) -> Rational {
    return (b[u] - a[u]) * (x[v] - a[v]) - (b[v] - a[v]) * (x[u] - a[u]);
  };
  const bool turned = side(t[0], t[1], t[2]) < 0;
  Rational low = 0, high = 1;
  for (int i = 0; i < 3; ++i) {
    Rational at_p = side(t[i], t[(i + 1) % 3], exact(p)), at_q = side(t[i], t[(i + 1) % 3], exact(q));
    if (turned) at_p = -at_p, at_q = -at_q;
    if (at_p == at_q) {
      if (at_p < 0) return {};
    } else {
      const Rational zero = at_p / (at_p - at_q);
      if (at_q > at_p) low = std::max(low, zero);
      if (at_q < at_p) high = std::min(high, zero);
    }
  }
  if (low > high) return {};
  return {{low, high}};
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return static_cast<int>(CGAL::orientation(cgal(a), cgal(b), cgal(c), cgal(d)));
}

bool is_on(const TriangleSurface& surface, const Point& p) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [a, b, c] = corners(surface, t);
    const Kernel::Triangle_3 triangle(cgal(a), cgal(b), cgal(c));
    if (!triangle.is_degenerate() && triangle.has_on(cgal(p))) return true;
  }
  return false;
}

bool is_inside(const TriangleSurface& surface, const Point& p) {
  Point low = p, high = p;
  for (const Point& v : surface.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const double far = 3 * (high - low).norm();
  std::mt19937_64 random(1994);
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };  // -1 .. 1
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Point direction(coordinate(), coordinate(), coordinate());
    if (direction.norm() < 0.5) continue;
    const Point end = p + far / direction.norm() * direction;
    bool odd = false, settled = true;
    for (std::size_t t = 0; t < surface.triangles.size() && settled; ++t) {
      const auto triangle = corners(surface, t);
      const int at_p = orientation(triangle[0], triangle[1], triangle[2], p);
      const int at_end = orientation(triangle[0], triangle[1], triangle[2], end);
      if (at_p == at_end && at_p != 0) continue;
      const auto signs = sides(p, end, triangle);
      if (mixed(signs)) continue;
      if (std::count(signs.begin(), signs.end(), 0) > 0 || at_end == 0)
        settled = false;  // through an edge
      else if (at_p != 0)
        odd = !odd;
    }
    if (settled) return odd;
  }
  throw std::runtime_error("no ray in general position found");
}

std::vector<std::pair<Rational, Rational>> meets(const TriangleSurface& surface, const Point& p,
                                                 const Point& q) {
  std::vector<std::pair<Rational, Rational>> parts;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto triangle = corners(surface, t);
    const auto& [a, b, c] = triangle;
    const int at_p = orientation(a, b, c, p), at_q = orientation(a, b, c, q);
    if (at_p == 0 && at_q == 0) {
      for (const auto& part : coplanar_part(p, q, triangle)) parts.push_back(part);
    } else if (at_p != at_q && !mixed(sides(p, q, triangle))) {
      const Rational to_p = determinant(a, b, c, p), to_q = determinant(a, b, c, q);
      const Rational at = to_p / (to_p - to_q);
      parts.push_back({at, at});
    }
  }
  std::sort(parts.begin(), parts.end());
  std::vector<std::pair<Rational, Rational>> united;
  for (const auto& part : parts) {
    if (!united.empty() && part.first <= united.back().second)
      united.back().second = std::max(united.back().second, part.second);
    else
      united.push_back(part);
  }
  return united;
}

Point along(const Point& p, const Point& q, const Rational& t) {
  Point at;
  for (int i = 0; i < 3; ++i) {
    const Rational exactly = Rational(p[i]) + t * (Rational(q[i]) - Rational(p[i]));
    at[i] = CGAL::to_double(exactly);
  }
  return at;
}

Point closest_on_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point n = (b - a).cross(c - a);
  // Inside the three planes through the edges, upright on the triangle: its foot on the plane.
  if (n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 && n.cross(a - c).dot(p - c) >= 0)
    return p - n.dot(p - a) / n.squaredNorm() * n;
  Point best = a;
  for (const auto& [s, e] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
    const double t = std::clamp((p - s).dot(e - s) / (e - s).squaredNorm(), 0.0, 1.0);
    const Point foot = t == 1 ? e : Point(s + t * (e - s));
    if ((p - foot).squaredNorm() < (p - best).squaredNorm()) best = foot;
  }
  return best;
}

Point closest_on_surface(const TriangleSurface& surface, const Point& p) {
  if (is_on(surface, p)) return p;
  Point best = surface.vertices.at(surface.triangles.at(0)[0]);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [a, b, c] = corners(surface, t);
    const Point candidate = closest_on_triangle(p, a, b, c);
    const double now = (p - candidate).norm(), before = (p - best).norm();
    if (now < before || (now == before && lexicographically_less(candidate, best))) best = candidate;
  }
  return best;
}

bool lexicographically_less(const Point& a, const Point& b) {
  return std::array{a.x(), a.y(), a.z()} < std::array{b.x(), b.y(), b.z()};
}

}  // namespace tetproof::second
