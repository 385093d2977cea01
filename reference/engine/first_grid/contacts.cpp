// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/contacts.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

#include "reference/engine/first_grid/exact.hpp"
#include "reference/engine/first_grid/rasterise.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;

constexpr std::size_t triangles_a_task = 512;

// Runs work(first, last, result) on slices of the triangles in parallel. Returns the results in order.
template <class Result, class Work>
std::vector<Result> over_triangles(std::size_t triangles, Work work) {
  std::vector<Result> slices((triangles + triangles_a_task - 1) / triangles_a_task);
  tbb::parallel_for(std::size_t{0}, slices.size(), [&](std::size_t s) {
    work(s * triangles_a_task, std::min(triangles, (s + 1) * triangles_a_task), slices[s]);
  });
  return slices;
}

// Whether the line through a and b meets the closed triangle. The points a and b lie on different sides of
// it.
bool line_meets_triangle(const Triangle& t, const Vector3d& a, const Vector3d& b) {
  const int s0 = orientation(a, b, t[0], t[1]), s1 = orientation(a, b, t[1], t[2]);
  if (s0 * s1 < 0) return false;
  const int s2 = orientation(a, b, t[2], t[0]);
  return s0 * s2 >= 0 && s1 * s2 >= 0;
}

// The box of a triangle.
struct Box {
  Vector3d low, high;
  explicit Box(const Triangle& t)
      : low(t[0].cwiseMin(t[1]).cwiseMin(t[2])), high(t[0].cwiseMax(t[1]).cwiseMax(t[2])) {}
};

// Tells on which sides of a triangle's plane the corners of a cell lie, most of them by doubles.
//
// With u = t1 - t0, v = t2 - t0 and w = p - t0, `orientation` is the sign of H = (u x v) . w. Let h be its
// value in doubles, and M the sum of the magnitudes of its six products. A product has at most 8 roundings on
// the way from a coordinate to h, so |h - H| < 8.01 * 2^-53 M. M has as many, so its value in doubles is as
// good. Underflow adds less than 1e-220 in a lattice, where |w| < 1e97: each product of u and v loses at most
// 2^-1075, which w multiplies, and each product with w as much. So h has the sign of H if |h| > 1e-15 M +
// 1e-220. This is false if a value has overflowed: rounding is monotonic, so |h| <= M in doubles, too.
class PlaneSides {
 public:
  explicit PlaneSides(const Triangle& t) : t_(t) {
    const Vector3d u = t[1] - t[0], v = t[2] - t[0];
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      const double plus = u[y] * v[z], minus = u[z] * v[y];
      normal_[x] = plus - minus;
      magnitude_[x] = std::abs(plus) + std::abs(minus);
    }
  }

  // Corner c of the box is `high` along the axes of its bits: 1 for x, 2 for y, 4 for z. Returns the values
  // of `orientation`.
  std::array<std::int8_t, 8> of_corners(const Vector3d& low, const Vector3d& high) const {
    const Vector3d w[2] = {low - t_[0], high - t_[0]};
    const Vector3d part[2] = {normal_.cwiseProduct(w[0]), normal_.cwiseProduct(w[1])};
    const Vector3d most = magnitude_.cwiseProduct(w[0].cwiseAbs().cwiseMax(w[1].cwiseAbs()));
    const double bound = 1e-15 * (most.x() + most.y() + most.z()) + 1e-220;
    std::array<std::int8_t, 8> sides;
    for (int c = 0; c < 8; ++c) {
      const double h = part[c & 1].x() + part[c >> 1 & 1].y() + part[c >> 2].z();
      if (h > bound)
        sides[c] = 1;
      else if (h < -bound)
        sides[c] = -1;
      else
        sides[c] = static_cast<std::int8_t>(
            orientation(t_[0], t_[1], t_[2],
                        {(c & 1 ? high : low).x(), (c & 2 ? high : low).y(), (c & 4 ? high : low).z()}));
    }
    return sides;
  }

 private:
  const Triangle& t_;
  Vector3d normal_, magnitude_;
};

void touch_cell(const Lattice& lattice, const Triangle& t, const Box& box, const PlaneSides& plane,
                Index number, const std::array<int, 3>& cell, Contacts& contacts) {
  // Bits of axes: along which the cell has an extent, and along which an edge from the cell's first corner
  // must run to reach the triangle's box.
  int there = 0, required = 0;
  Vector3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double>& planes = lattice.planes[axis];
    const bool inner = cell[axis] < lattice.cells[axis];
    low[axis] = planes[cell[axis]];
    high[axis] = planes[cell[axis] + inner];
    if (low[axis] > box.high[axis] || high[axis] < box.low[axis]) return;
    there |= inner << axis;
    required |= (low[axis] < box.low[axis]) << axis;
  }
  const std::array<std::int8_t, 8> sides = plane.of_corners(low, high);
  const Vertex base = lattice.vertex(cell[0], cell[1], cell[2]);
  if (sides[0] == 0 && required == 0 && in_closed_triangle(t, low)) contacts.on_surface.push_back(base);
  for (int direction = 1; direction < 8; ++direction) {
    if ((direction & there) != direction || (direction & required) != required) continue;
    const bool along = sides[0] == 0 && sides[direction] == 0;
    if (!along && sides[0] * sides[direction] >= 0) continue;
    const Vector3d end((direction & 1 ? high : low).x(), (direction & 2 ? high : low).y(),
                       (direction & 4 ? high : low).z());
    if (along || line_meets_triangle(t, low, end))
      contacts.hits.push_back({Edge{base} * 8 + direction, number, along});
  }
}

}  // namespace

Contacts find_contacts(const Lattice& lattice, const TriangleSurface& surface) {
  const double margin = clipping_error(lattice);
  const auto slices = over_triangles<Contacts>(
      surface.triangles.size(), [&](std::size_t first, std::size_t last, Contacts& found) {
        for (std::size_t n = first; n < last; ++n) {
          const Triangle t = corners(surface, n);
          const Box box(t);
          const PlaneSides plane(t);
          for_each_cell(lattice, t, margin, [&](int i, int j, int k) {
            touch_cell(lattice, t, box, plane, static_cast<Index>(n), {i, j, k}, found);
          });
        }
      });
  Contacts all;
  for (const Contacts& slice : slices) {
    all.on_surface.insert(all.on_surface.end(), slice.on_surface.begin(), slice.on_surface.end());
    all.hits.insert(all.hits.end(), slice.hits.begin(), slice.hits.end());
  }
  std::sort(all.on_surface.begin(), all.on_surface.end());
  all.on_surface.erase(std::unique(all.on_surface.begin(), all.on_surface.end()), all.on_surface.end());
  tbb::parallel_sort(all.hits.begin(), all.hits.end(), [](const EdgeHit& a, const EdgeHit& b) {
    return std::tie(a.edge, a.triangle) < std::tie(b.edge, b.triangle);
  });
  return all;
}

std::vector<NearVertex> find_near_vertices(const Lattice& lattice, const TriangleSurface& surface,
                                           double radius, const std::function<bool(Vertex)>& wanted) {
  const double margin = radius + clipping_error(lattice);
  const auto slices = over_triangles<std::vector<NearVertex>>(
      surface.triangles.size(), [&](std::size_t first, std::size_t last, std::vector<NearVertex>& found) {
        for (std::size_t n = first; n < last; ++n) {
          const Triangle t = corners(surface, n);
          const Box box(t);
          // A vertex within the margin is the first corner of its own cell, and that cell is within the
          // margin too: so the first corners of these cells are all that have to be asked.
          for_each_cell(lattice, t, margin, [&](int i, int j, int k) {
            const Vector3d p = lattice.point(i, j, k);
            // Farther from the box than the margin, it is farther than the radius from the computed closest
            // point too.
            if (((box.low - p).array() > margin).any() || ((p - box.high).array() > margin).any()) return;
            const Vertex v = lattice.vertex(i, j, k);
            if (!wanted(v)) return;
            const bool on_triangle = orientation(t[0], t[1], t[2], p) == 0 && in_closed_triangle(t, p);
            const Vector3d q = on_triangle ? p : closest_point(t, p);
            const double d2 = (q - p).squaredNorm();
            if (d2 < radius * radius) found.push_back({v, d2, q});
          });
        }
      });
  std::vector<NearVertex> all;
  for (const auto& slice : slices) all.insert(all.end(), slice.begin(), slice.end());
  std::sort(all.begin(), all.end(), [](const NearVertex& a, const NearVertex& b) {
    if (a.vertex != b.vertex) return a.vertex < b.vertex;
    if (a.squared_distance != b.squared_distance) return a.squared_distance < b.squared_distance;
    return lexicographically_less(a.point, b.point);
  });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const NearVertex& a, const NearVertex& b) { return a.vertex == b.vertex; }),
            all.end());
  return all;
}

}  // namespace tetproof::reference
