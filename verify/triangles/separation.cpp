// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/separation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

namespace tetproof::verify {
namespace {

using Vector = Eigen::Vector3d;

// The point of a set that is farthest in a direction, and how far it is.
struct Farthest {
  const Vector* point;
  double reach;
};
Farthest farthest(std::span<const Vector> points, const Vector& direction) {
  Farthest best{points.data(), points[0].dot(direction)};
  for (const Vector& p : points.subspan(1))
    if (const double reach = p.dot(direction); reach > best.reach) best = {&p, reach};
  return best;
}

// Up to four points, and the point of their hull that is nearest to the origin. Keeps only the points of the
// side, edge or corner on which it lies.
class Simplex {
 public:
  explicit Simplex(const Vector& p) : points_{p}, size_(1), nearest_(p) {}
  const Vector& nearest() const { return nearest_; }

  // False if the hull seems to hold the origin.
  bool add(const Vector& p) {
    points_[size_++] = p;
    const std::array<Vector, 4> all = points_;
    const std::size_t count = size_;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const Vector& q, std::initializer_list<std::size_t> on) {
      if (!(q.squaredNorm() < least)) return;
      least = q.squaredNorm(), nearest_ = q, size_ = 0;
      for (const std::size_t i : on) points_[size_++] = all[i];
    };
    for (std::size_t i = 0; i < count; ++i) {
      offer(all[i], {i});
      for (std::size_t j = 0; j < i; ++j) {
        const Vector way = all[j] - all[i];
        const double share = -all[i].dot(way) / way.squaredNorm();
        if (share > 0 && share < 1) offer(all[i] + share * way, {i, j});
        for (std::size_t k = 0; k < j; ++k) {
          const Vector &a = all[i], &b = all[j], &c = all[k];
          const Vector normal = (b - a).cross(c - a);
          const double area = normal.squaredNorm(), wa = b.cross(c).dot(normal), wb = c.cross(a).dot(normal),
                       wc = a.cross(b).dot(normal);
          if (area > 0 && wa > 0 && wb > 0 && wc > 0) offer(a.dot(normal) / area * normal, {i, j, k});
        }
      }
    }
    return count < 4 || !holds_origin(all);
  }

 private:
  static bool holds_origin(const std::array<Vector, 4>& p) {
    const auto volume = [](const Vector& a, const Vector& b, const Vector& c) { return a.dot(b.cross(c)); };
    const double s = volume(p[1], p[2], p[3]), t = -volume(p[0], p[2], p[3]), u = volume(p[0], p[1], p[3]),
                 v = -volume(p[0], p[1], p[2]);
    return (s > 0 && t > 0 && u > 0 && v > 0) || (s < 0 && t < 0 && u < 0 && v < 0);
  }

  std::array<Vector, 4> points_;
  std::size_t size_;
  Vector nearest_;
};

}  // namespace

// The algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robotics and Automation 4, 1988): walks towards the
// point of all differences a - b that is nearest to the origin. It only proposes directions. The proof is the
// comparison with `slack`: if the sets are apart by more than slack * (|x| + |y| + |z|) along the direction
// (x, y, z), then two points of the hulls differ by more than slack along an axis.
//
// Let u = 2^-53, N = |x| + |y| + |z| and M the largest absolute coordinate. Each of the two products of a
// point and the direction has an error below 4 u N M, their difference and the right side add less than 2 u N
// M and 5 u N slack. So the comparison errs by less than 16 u N M, unless slack > M, when nothing is
// separated by it. (Directions are scaled, so that what underflows is below u N M 2^-100 unless M < 2^-800.)
bool separated(std::span<const Vector> a, std::span<const Vector> b, double slack) {
  constexpr int most_steps = 16;
  Simplex simplex(a[0] - b[0]);
  for (int step = 0; step < most_steps; ++step) {
    const double size = simplex.nearest().cwiseAbs().maxCoeff();
    if (!(size > slack)) return false;  // so the nearest points are within the slack
    const Vector direction = simplex.nearest() / size;
    const Farthest low = farthest(a, -direction), high = farthest(b, direction);
    if (-low.reach - high.reach > slack * direction.lpNorm<1>()) return true;
    const Vector next = *low.point - *high.point;
    // No step can bring the hull much nearer to the origin.
    if (direction.dot(simplex.nearest() - next) <= 1e-9 * size) return false;
    if (!simplex.add(next)) return false;
  }
  return false;
}

}  // namespace tetproof::verify
