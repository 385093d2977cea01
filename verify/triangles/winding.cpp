// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/winding.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/box_intersection_d.h>
#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "verify/triangles/box.hpp"
#include "verify/triangles/chunks.hpp"

namespace tetproof::verify {
namespace {

using Exact = CGAL::Mpzf;
using Point = std::array<Exact, 3>;  // three times the coordinates, so that a centroid is a sum

Point scaled(const Eigen::Vector3d& p) {
  return {Exact(3) * Exact(p.x()), Exact(3) * Exact(p.y()), Exact(3) * Exact(p.z())};
}

Point centroid(std::span<const Eigen::Vector3d> points, const Triangle& t) {
  Point sum;
  for (int k = 0; k < 3; ++k)
    sum[k] = Exact(points[t[0]][k]) + Exact(points[t[1]][k]) + Exact(points[t[2]][k]);
  return sum;
}

// The component of (b-a) x (c-a) along an axis: twice the signed area of the triangle's projection along that
// axis.
Exact normal(const Point& a, const Point& b, const Point& c, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
}

// Six times the volume of a tetrahedron, times 27 for the scaled coordinates.
Exact determinant(std::span<const Eigen::Vector3d> points, const std::array<Index, 4>& tet) {
  const Point a = scaled(points[tet[0]]), b = scaled(points[tet[1]]), c = scaled(points[tet[2]]),
              d = scaled(points[tet[3]]);
  Exact sum = 0;
  for (int k = 0; k < 3; ++k) sum += normal(a, b, c, k) * (d[k] - a[k]);
  return sum;
}

struct Ray {  // NOLINT(bugprone-exception-escape): as in volumes.cpp
  Index start;
  Point origin;
  int axis, direction;
};

Ray ray_from(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, Index start) {
  const Triangle& t = triangles[start];
  const Point a = scaled(points[t[0]]), b = scaled(points[t[1]]), c = scaled(points[t[2]]);
  // Any axis that is not in the triangle's plane is good. The one closest to the normal, by doubles, comes
  // first, because its projection has the largest area.
  const Eigen::Vector3d n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
  Ray ray{start, centroid(points, t), 0, 0};
  n.cwiseAbs().maxCoeff(&ray.axis);
  for (int tries = 0; tries < 3 && ray.direction == 0; ++tries) {
    if (tries) ray.axis = (ray.axis + 1) % 3;
    ray.direction = static_cast<int>(CGAL::sign(normal(a, b, c, ray.axis)));
  }
  return ray;
}

// The side of the projected line from a to b on which the ray's origin lies, moved by (e, e^2) for an
// infinitesimal e; 0 if a = b.
int side(const Point& a, const Point& b, const Ray& ray) {
  const int exactly = static_cast<int>(CGAL::sign(normal(a, b, ray.origin, ray.axis)));
  if (exactly != 0) return exactly;
  const int i = (ray.axis + 1) % 3, j = (ray.axis + 2) % 3;
  const int along_i = static_cast<int>(CGAL::sign(a[j] - b[j]));
  return along_i != 0 ? along_i : static_cast<int>(CGAL::sign(b[i] - a[i]));
}

// +1 or -1 as in Crossing, 0 if the ray misses the triangle.
int crossing(std::span<const Eigen::Vector3d> points, const Triangle& t, const Ray& ray) {
  const Point a = scaled(points[t[0]]), b = scaled(points[t[1]]), c = scaled(points[t[2]]);
  const int facing = side(a, b, ray);
  if (facing == 0 || side(b, c, ray) != facing || side(c, a, ray) != facing) return 0;
  Exact height = 0;  // height of the origin over the triangle's plane, times the normal's length
  for (int k = 0; k < 3; ++k) height += normal(a, b, c, k) * (ray.origin[k] - a[k]);
  const int ahead = -static_cast<int>(CGAL::sign(height)) * facing * ray.direction;  // along the ray
  return ahead > 0 ? facing * ray.direction : 0;
}

// As `crossing`, in interval arithmetic; nothing if a sign is not certain. The rounding mode must be upwards.
// Intervals cover what over- and underflows.
std::optional<int> sure_crossing(std::span<const Eigen::Vector3d> points, const Triangle& t, const Ray& ray) {
  using Interval = CGAL::Interval_nt<false>;
  std::array<Interval, 3> origin;
  for (int k = 0; k < 3; ++k) origin[k] = Interval(CGAL::to_interval(ray.origin[k]));
  const auto corner = [&](int n, int k) { return Interval(points[t[n % 3]][k]); };
  const auto from = [&](int n, int k) { return origin[k] - Interval(3) * corner(n, k); };
  const int i = (ray.axis + 1) % 3, j = (ray.axis + 2) % 3;
  bool left = true, right = true;
  int certain = 0;
  for (int n = 0; n < 3; ++n) {
    const auto sign = CGAL::sign((corner(n + 1, i) - corner(n, i)) * from(n, j) -
                                 (corner(n + 1, j) - corner(n, j)) * from(n, i));
    if (!sign.is_certain() || sign.inf() == CGAL::ZERO) continue;
    ++certain;
    (sign.inf() == CGAL::POSITIVE ? right : left) = false;
  }
  if (!left && !right) return 0;
  if (certain < 3) return std::nullopt;
  Interval height = 0;
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    height += ((corner(1, u) - corner(0, u)) * (corner(2, v) - corner(0, v)) -
               (corner(1, v) - corner(0, v)) * (corner(2, u) - corner(0, u))) *
              from(0, k);
  }
  const auto above = CGAL::sign(height);
  if (!above.is_certain()) return std::nullopt;
  const int facing = left ? 1 : -1;
  return -static_cast<int>(above.inf()) * facing * ray.direction > 0 ? facing * ray.direction : 0;
}

// A box around the ray: an enclosure of its origin, infinite in its direction.
Box box_of(const Ray& ray, std::size_t number) {
  Box box{{}, {}, number};
  for (int k = 0; k < 3; ++k) {
    std::tie(box.low[k], box.high[k]) = CGAL::to_interval(CGAL::Gmpq(ray.origin[k]) / 3);
    if (k != ray.axis) continue;
    (ray.direction > 0 ? box.high[k] : box.low[k]) = ray.direction * std::numeric_limits<double>::infinity();
  }
  return box;
}

}  // namespace

std::vector<std::vector<Crossing>> cast_rays(std::span<const Eigen::Vector3d> points,
                                             std::span<const Triangle> triangles,
                                             std::span<const Index> starts) {
  std::vector<Ray> rays;
  std::vector<Box> ray_boxes, triangle_boxes;
  for (const Index start : starts) {
    rays.push_back(ray_from(points, triangles, start));
    ray_boxes.push_back(box_of(rays.back(), triangles.size() + ray_boxes.size()));
  }
  // A few rays pass few triangles. The others need not be sorted.
  Box all = ray_boxes.empty() ? Box{} : ray_boxes[0];
  for (const Box& box : ray_boxes)
    for (int k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], box.low[k]);
      all.high[k] = std::max(all.high[k], box.high[k]);
    }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Box box = box_of(points, triangles[t], t);
    bool near = true;
    for (int k = 0; k < 3; ++k) near = near && box.low[k] <= all.high[k] && box.high[k] >= all.low[k];
    if (near) triangle_boxes.push_back(box);
  }
  std::vector<std::vector<Crossing>> crossings(rays.size());
  struct Candidate {
    std::size_t ray;
    Index triangle;
    int sign = 0;
  };
  constexpr std::size_t most_candidates = std::size_t{1} << 20, piece = 1024;
  std::vector<Candidate> candidates;
  const auto decide = [&] {
    const auto crossed = collect_in_order<Candidate>(
        candidates.size(), piece, [&](std::size_t begin, std::size_t end, std::vector<Candidate>& found) {
          std::vector<Candidate> unsure;
          const auto add = [&](Candidate c, int sign) {
            c.sign = sign;
            if (sign != 0 && c.triangle != rays[c.ray].start) found.push_back(c);
          };
          {
            const CGAL::Protect_FPU_rounding<true> upwards;
            for (std::size_t k = begin; k < end; ++k) {
              const Candidate& c = candidates[k];
              if (const auto sign = sure_crossing(points, triangles[c.triangle], rays[c.ray]))
                add(c, *sign);
              else
                unsure.push_back(c);
            }
          }
          for (const Candidate& c : unsure) add(c, crossing(points, triangles[c.triangle], rays[c.ray]));
        });
    for (const Candidate& c : crossed) crossings[c.ray].push_back({c.triangle, c.sign});
    candidates.clear();
  };
  CGAL::box_intersection_d(
      ray_boxes.begin(), ray_boxes.end(), triangle_boxes.begin(), triangle_boxes.end(),
      [&](const Box& r, const Box& t) {
        candidates.push_back({r.number - triangles.size(), static_cast<Index>(t.number)});
        if (candidates.size() == most_candidates) decide();
      });
  decide();
  for (auto& list : crossings)
    std::sort(list.begin(), list.end(),
              [](const Crossing& a, const Crossing& b) { return a.triangle < b.triangle; });
  return crossings;
}

std::vector<int> nesting_depths(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles,
                                const Sheets& sheets) {
  std::vector<Index> starts;
  for (const Sheet& sheet : sheets.sheets) starts.push_back(sheet.first_triangle);
  const auto crossings = cast_rays(points, triangles, starts);
  std::vector<int> depths;
  std::vector<Index> crossed;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    crossed.clear();
    for (const Crossing& c : crossings[i])
      if (const Index sheet = sheets.of_triangle[c.triangle]; sheet >= 0 && sheet != static_cast<Index>(i))
        crossed.push_back(sheet);
    std::sort(crossed.begin(), crossed.end());
    int depth = 0;
    for (std::size_t j = 0, k; j < crossed.size(); j = k) {
      for (k = j; k < crossed.size() && crossed[k] == crossed[j];) ++k;
      depth += (k - j) % 2;
    }
    depths.push_back(depth);
  }
  return depths;
}

Index tet_inside(const TetMesh& mesh, const std::vector<std::uint8_t>& excluded, const Triangle& triangle,
                 Index without) {
  const std::span<const Eigen::Vector3d> points = mesh.points;
  const Point a = scaled(points[triangle[0]]), b = scaled(points[triangle[1]]),
              c = scaled(points[triangle[2]]);
  const Point origin = centroid(points, triangle),
              inwards{normal(a, c, b, 0), normal(a, c, b, 1), normal(a, c, b, 2)};
  Eigen::Vector3d low, high;
  for (int k = 0; k < 3; ++k) std::tie(low[k], high[k]) = CGAL::to_interval(CGAL::Gmpq(origin[k]) / 3);
  // The point must lie inside each face's plane, or on the plane with `inwards` not leading out.
  const auto contains = [&](const std::array<Index, 4>& tet) {
    for (const auto& corners : tet_faces) {
      const Point p = scaled(points[tet[corners[0]]]), q = scaled(points[tet[corners[1]]]),
                  r = scaled(points[tet[corners[2]]]);
      Exact height = 0, way = 0;
      for (int k = 0; k < 3; ++k) {
        const Exact n = normal(p, q, r, k);
        height += n * (origin[k] - p[k]);
        way += n * inwards[k];
      }
      const CGAL::Sign outside = CGAL::sign(height) != CGAL::ZERO ? CGAL::sign(height) : CGAL::sign(way);
      if (outside == CGAL::POSITIVE) return false;
    }
    return true;
  };
  const auto first = [&](const tbb::blocked_range<std::size_t>& range, Index found) {
    for (std::size_t t = range.begin(); t < range.end() && found < 0; ++t) {
      if (static_cast<Index>(t) == without || (!excluded.empty() && excluded[t])) continue;
      const std::array<Index, 4>& tet = mesh.tets[t];
      const Eigen::Vector3d &p = points[tet[0]], &q = points[tet[1]], &r = points[tet[2]],
                            &s = points[tet[3]];
      if ((p.cwiseMin(q).cwiseMin(r.cwiseMin(s)).array() > high.array()).any()) continue;
      if ((p.cwiseMax(q).cwiseMax(r.cwiseMax(s)).array() < low.array()).any()) continue;
      if (CGAL::sign(determinant(points, tet)) == CGAL::POSITIVE && contains(tet))
        found = static_cast<Index>(t);
    }
    return found;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, mesh.tets.size(), 16384), Index{-1}, first,
                              [](Index x, Index y) { return x < 0   ? y
                                                            : y < 0 ? x
                                                                    : std::min(x, y); });
}

}  // namespace tetproof::verify
