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

void touch_cell(const Lattice& lattice, const Triangle& t, Index number, const std::array<int, 3>& cell,
                Contacts& contacts) {
  const auto [i, j, k] = cell;
  const int there =
      (i < lattice.cells[0] ? 1 : 0) | (j < lattice.cells[1] ? 2 : 0) | (k < lattice.cells[2] ? 4 : 0);
  const Vertex base = lattice.vertex(i, j, k);
  const Vector3d origin = lattice.point(i, j, k);
  const int side = orientation(t[0], t[1], t[2], origin);
  if (side == 0 && in_closed_triangle(t, origin)) contacts.on_surface.push_back(base);
  for (int direction = 1; direction < 8; ++direction) {
    if ((direction & there) != direction) continue;
    const Vector3d end = lattice.point(i + (direction & 1), j + (direction >> 1 & 1), k + (direction >> 2));
    const int end_side = orientation(t[0], t[1], t[2], end);
    const bool along = side == 0 && end_side == 0;
    if (along || (side * end_side < 0 && line_meets_triangle(t, origin, end)))
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
          for_each_cell(lattice, t, margin, [&](int i, int j, int k) {
            touch_cell(lattice, t, static_cast<Index>(n), {i, j, k}, found);
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
          // A vertex within the margin is the first corner of its own cell, and that cell is within the
          // margin too: so the first corners of these cells are all that have to be asked.
          for_each_cell(lattice, t, margin, [&](int i, int j, int k) {
            const Vertex v = lattice.vertex(i, j, k);
            if (!wanted(v)) return;
            const Vector3d p = lattice.point(i, j, k);
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
