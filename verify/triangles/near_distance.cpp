// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/near_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tetproof::verify {
namespace {

// The position, 0 to 1, of the point closest to p on the segment from 0 to `way`.
double share_along(const Eigen::Vector3d& p, const Eigen::Vector3d& way) {
  const double length = way.squaredNorm();
  return length > 0 ? std::clamp(p.dot(way) / length, 0.0, 1.0) : 0.0;
}

double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& way) {
  // Measured from the nearer end, so that the vectors that cancel are short.
  if (p.dot(way) > 0.5 * way.squaredNorm()) return (p - way + share_along(way - p, way) * way).norm();
  return (p - share_along(p, way) * way).norm();
}

}  // namespace

Near::Near(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles) : points_(points) {
  if (triangles.empty()) return;
  Eigen::Vector3d low = points[static_cast<std::size_t>(triangles[0][0])], high = low;
  for (const Triangle& t : triangles)
    for (const Index v : t) {
      low = low.cwiseMin(points[static_cast<std::size_t>(v)]);
      high = high.cwiseMax(points[static_cast<std::size_t>(v)]);
    }
  diagonal_ = (high - low).stableNorm();
  scale_ = 1 / diagonal_;
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  limit_ = std::max(near_distance, near_units * std::numeric_limits<double>::epsilon() * (largest * scale_));
  usable_ = std::isnormal(diagonal_) && std::isnormal(scale_);
}

double Near::along(Index v, Index a, Index b) const {
  return share_along(from(a, v), from(a, b));
}

double Near::to_segment(Index v, Index a, Index b) const {
  return distance_to_segment(from(a, v), from(a, b));
}

double Near::to_plane(Index v, const Triangle& t) const {
  const Eigen::Vector3d normal = from(t[0], t[1]).cross(from(t[0], t[2]));
  const double length = normal.norm();
  return length > 0 ? std::abs(normal.dot(from(t[0], v))) / length : 0;
}

double Near::to_triangle(Index v, const Triangle& t) const {
  const Eigen::Vector3d p = from(t[0], v), b = from(t[0], t[1]), c = from(t[0], t[2]);
  const Eigen::Vector3d normal = b.cross(c);
  const double length = normal.norm(), height = std::abs(normal.dot(p));
  // A distance far above the limit need not be accurate. The code below also handles thin triangles, whose
  // normal may point anywhere.
  if (height > 1e3 * limit_ * length && length > 1e-6 * b.norm() * c.norm()) return height / length;
  double least =
      std::min({distance_to_segment(p, b), distance_to_segment(p, c), distance_to_segment(p - b, c - b)});
  // If p lies straight above the inside, its foot is computed as a mean of the corners, so rounding moves it
  // only within the triangle.
  const double wb = p.cross(c).dot(normal), wc = b.cross(p).dot(normal), area = normal.squaredNorm();
  if (wb >= 0 && wc >= 0 && wb + wc <= area && area > 0)
    least = std::min(least, (p - wb / area * b - wc / area * c).norm());
  return least;
}

double Near::between_segments(Index a, Index b, Index c, Index d) const {
  double least =
      std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
  // The closest points may both lie inside the segments. The segments are then not parallel.
  const Eigen::Vector3d u = from(a, b), v = from(c, d), w = from(c, a);
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return least;
  const double s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, (w + s * u - t * v).norm());
  return least;
}

double Near::between_triangles(const Triangle& s, const Triangle& t) const {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, to_triangle(s[i], t), to_triangle(t[i], s)});
    for (int k = 0; k < 3; ++k)
      least = std::min(least, between_segments(s[i], s[(i + 1) % 3], t[k], t[(k + 1) % 3]));
  }
  return least;
}

}  // namespace tetproof::verify
