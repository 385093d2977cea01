// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/near_distance.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/triangles/on_triangle.hpp"
#include "verify/triangles/touching.hpp"

namespace tetproof::verify {
namespace {

using Vector = Eigen::Vector3d;

// The power of two below the largest component of the vectors; 1 if all are zero. What is divided by it has
// components below 2, and squares and products of such components neither overflow nor lose what matters.
template <class... Vectors>
double unit_of(const Vectors&... vectors) {
  const double largest = std::max({vectors.cwiseAbs().maxCoeff()...});
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest)) : 1;
}

// The position, 0 to 1, of the point closest to p on the segment from 0 to `way`.
double share_along(const Vector& p, const Vector& way) {
  const double length = way.squaredNorm();
  return length > 0 ? std::clamp(p.dot(way) / length, 0.0, 1.0) : 0.0;
}

double distance_to_segment(const Vector& p, const Vector& way) {
  // Measured from the nearer end, so that the vectors that cancel are short.
  if (p.dot(way) > 0.5 * way.squaredNorm()) return (p - way + share_along(way - p, way) * way).norm();
  return (p - share_along(p, way) * way).norm();
}

// The distance of p from the triangle 0 b c; all components are below 2.
double distance_to_triangle(const Vector& p, const Vector& b, const Vector& c) {
  const Vector normal = b.cross(c);
  double least =
      std::min({distance_to_segment(p, b), distance_to_segment(p, c), distance_to_segment(p - b, c - b)});
  // If p lies straight above the inside, its foot is computed as a mean of the corners, so rounding moves it
  // only within the triangle.
  const double wb = p.cross(c).dot(normal), wc = b.cross(p).dot(normal), area = normal.squaredNorm();
  if (wb >= 0 && wc >= 0 && wb + wc <= area && area > 0)
    least = std::min(least, (p - wb / area * b - wc / area * c).norm());
  return least;
}

struct Size {
  double longest, thickness;  // [units]
};

// The longest edge of the triangle 0 b c, and the smallest height of the tetrahedron 0 b c d; where that has
// no volume or is not given (d = 0), the smallest height of the triangle.
Size size_of(const Vector& b, const Vector& c, const Vector& d) {
  const Vector normal = b.cross(c);
  const double longest = std::max({b.norm(), c.norm(), (c - b).norm()});
  const double determinant = std::abs(normal.dot(d));
  if (determinant > 0)
    return {longest, determinant / std::max({normal.norm(), b.cross(d).norm(), c.cross(d).norm(),
                                             (c - b).cross(d - b).norm()})};
  return {longest, longest > 0 ? normal.norm() / longest : 0};
}

}  // namespace

Near::Near(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
           std::span<const Index> opposite)
    : points_(points), triangles_(triangles), rooms_(triangles.size()), sizes_(triangles.size()) {
  double largest = 0;
  for (const Triangle& t : triangles)
    for (const Index v : t) largest = std::max(largest, at(v).cwiseAbs().maxCoeff());
  if (largest > std::numeric_limits<double>::max() / 4) factor_ = 0.25;
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t t) {
    const auto& [i, j, k] = triangles[t];
    const Vector b = from(i, j), c = from(i, k), d = opposite.empty() ? Vector::Zero() : from(i, opposite[t]);
    const double unit = unit_of(b, c, d);
    const Size size = size_of(b / unit, c / unit, d / unit);
    const double coordinate =
        std::max({at(i).cwiseAbs().maxCoeff(), at(j).cwiseAbs().maxCoeff(), at(k).cwiseAbs().maxCoeff()});
    sizes_[t] = std::min(size.longest * unit / factor_, std::numeric_limits<double>::max());
    rooms_[t] = std::min(std::max(near_distance * size.longest * unit / factor_,
                                  near_units * std::numeric_limits<double>::epsilon() * coordinate),
                         near_thickness * size.thickness * unit / factor_);
  });
}

double Near::along(Index v, Index a, Index b) const {
  const Vector p = from(a, v), way = from(a, b);
  const double unit = unit_of(p, way);
  return share_along(p / unit, way / unit);
}

// In the tests below, `error` is what doubles may be off by. A distance above room and error is far. If the
// room is above the error, the distance decides, else only exact touching is near.

bool Near::on_plane(Index v, Index t) const {
  const auto& [i, j, k] = triangle(t);
  const Vector p = from(i, v), b = from(i, j), c = from(i, k);
  const double unit = unit_of(p, b, c);
  const Vector normal = (b / unit).cross(c / unit);
  const double length = normal.norm();
  const double height = length > 0 ? std::abs(normal.dot(p / unit)) / length * unit / factor_ : 0;
  // For a needle the normal is known less well, by the factor length / height.
  const double error = length > 0 ? near_error * 4 / length * unit / factor_ : 0;
  if (height > std::max(room(t), error)) return false;
  return room(t) >= error ? height <= room(t) : touches_plane(at(v), {at(i), at(j), at(k)});
}

bool Near::on_edge(Index v, Index a, Index b, Index t) const {
  const Vector p = from(a, v), way = from(a, b);
  const double unit = unit_of(p, way);
  const double distance = distance_to_segment(p / unit, way / unit) * unit / factor_;
  const double error = near_error * unit / factor_;
  if (distance > std::max(room(t), error)) return false;
  return room(t) >= error ? distance <= room(t) : touches_segment(at(v), {at(a), at(b)});
}

bool Near::on_triangle(Index v, Index t) const {
  const auto& [i, j, k] = triangle(t);
  const double distance = to_triangle(v, t), error = near_error * size(t);
  if (distance > std::max(room(t), error)) return false;
  return room(t) >= error ? distance <= room(t) : verify::on_triangle(at(v), {at(i), at(j), at(k)});
}

bool Near::edges_near(Index a, Index b, Index s, Index c, Index d, Index t) const {
  const double reach = room(s, t), error = near_error * std::max(size(s), size(t));
  const double distance = between_segments(a, b, c, d);
  if (distance > std::max(reach, error)) return false;
  return reach >= error ? distance <= reach : segments_touch({at(a), at(b)}, {at(c), at(d)});
}

double Near::to_triangle(Index v, Index t) const {
  const auto& [i, j, k] = triangle(t);
  const Vector p = from(i, v), b = from(i, j), c = from(i, k);
  const double unit = unit_of(p, b, c);
  return distance_to_triangle(p / unit, b / unit, c / unit) * unit / factor_;
}

double Near::between_segments(Index a, Index b, Index c, Index d) const {
  Vector u = from(a, b), v = from(c, d), w = from(c, a);
  const double unit = unit_of(u, v, w);
  u /= unit, v /= unit, w /= unit;
  // The distances of the four ends from the other segment.
  const Vector to_b = w + u;
  double least = std::min({distance_to_segment(w, v), distance_to_segment(to_b, v),
                           distance_to_segment(-w, u), distance_to_segment(v - w, u)});
  // The closest points may both lie inside the segments. The segments are then not parallel.
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    const double x = (uv * vw - vv * uw) / determinant, y = (uu * vw - uv * uw) / determinant;
    if (x >= 0 && x <= 1 && y >= 0 && y <= 1) least = std::min(least, (w + x * u - y * v).norm());
  }
  return least * unit / factor_;
}

double Near::between_triangles(Index s, Index t) const {
  const Triangle &first = triangle(s), &second = triangle(t);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, to_triangle(first[i], t), to_triangle(second[i], s)});
    for (int k = 0; k < 3; ++k)
      least = std::min(least, between_segments(first[i], first[(i + 1) % 3], second[k], second[(k + 1) % 3]));
  }
  return least;
}

}  // namespace tetproof::verify
