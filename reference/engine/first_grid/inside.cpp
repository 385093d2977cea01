// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/inside.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "reference/engine/first_grid/exact.hpp"
#include "reference/engine/first_grid/rasterise.hpp"

namespace tetproof::reference {
namespace {

// The sign of the triangle's projection along x: +1 if its corners run anticlockwise in (y, z), so that its
// normal points to +x.
int facing(const Triangle& t) {
  return orientation(t[0].y(), t[0].z(), t[1].y(), t[1].z(), t[2].y(), t[2].z());
}

// Whether (y + epsilon, z + epsilon^2) is inside the projected triangle, whose corners run anticlockwise if
// `facing` is +1.
bool projection_holds(const Triangle& t, int facing, double y, double z) {
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d &a = t[c], &b = t[(c + 1) % 3];
    int side = orientation(a.y(), a.z(), b.y(), b.z(), y, z);
    if (side == 0) side = a.z() != b.z() ? (a.z() > b.z() ? 1 : -1) : (b.y() > a.y() ? 1 : -1);
    if (side != facing) return false;
  }
  return true;
}

// The first i on the lattice line (j, k) whose vertex does not lie on the -x side of the triangle's plane.
int first_beyond(const Lattice& lattice, const Triangle& t, int facing, int j, int k) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double y = lattice.planes[1][j] - t[0].y(), z = lattice.planes[2][k] - t[0].z();
  const double guess = t[0].x() - (normal.y() * y + normal.z() * z) / normal.x();
  const auto beyond = [&](int i) {
    return facing * orientation(t[0], t[1], t[2], lattice.point(i, j, k)) >= 0;
  };
  // The guess may be far off where the triangle is almost parallel to the line. The extent of the triangle,
  // which lies inside the lattice, bounds it.
  const auto [lo, hi] = ClippedTriangle{{t[0], t[1], t[2]}, 3}.extent(0);
  int i = lattice.cell_of(0, guess > lo ? (guess < hi ? guess : hi) : lo);
  while (i > 0 && beyond(i - 1)) --i;
  while (i < lattice.cells[0] && !beyond(i)) ++i;
  return i;
}

}  // namespace

std::vector<std::int8_t> inside_by_parity(const Lattice& lattice, const TriangleSurface& surface) {
  // First, `parity` is 1 at a vertex if the surface crosses the line an odd number of times between this
  // vertex and the one before it. Then a running sum along each line turns this into +1 and -1.
  std::vector<std::int8_t> parity(lattice.vertices(), 0);
  const double margin = clipping_error(lattice);
  tbb::parallel_for(std::size_t{0}, surface.triangles.size(), [&](std::size_t n) {
    const Triangle t = corners(surface, n);
    const int side = facing(t);
    if (side == 0) return;  // parallel to x: the moved line never crosses it
    for_each_x_line(lattice, t, margin, [&](int j, int k) {
      if (!projection_holds(t, side, lattice.planes[1][j], lattice.planes[2][k])) return;
      std::atomic_ref(parity[lattice.vertex(first_beyond(lattice, t, side, j, k), j, k)])
          .fetch_xor(1, std::memory_order_relaxed);
    });
  });
  const int row = lattice.cells[0] + 1;
  tbb::parallel_for(0, lattice.vertices() / row, [&](int r) {
    std::int8_t inside = 0;
    for (int v = r * row; v < (r + 1) * row; ++v) {
      inside ^= parity[v];
      parity[v] = inside ? 1 : -1;
    }
    if (inside) throw std::logic_error("a lattice line ends inside the surface, which is not closed");
  });
  return parity;
}

InsideTest::InsideTest(const Lattice& lattice, const TriangleSurface& surface)
    : lattice_(&lattice), surface_(&surface) {
  const std::int64_t row = lattice.cells[1] + 1;
  const double margin = clipping_error(lattice);
  std::vector<std::pair<std::int64_t, Index>> entries;  // column, triangle
  for (std::size_t n = 0; n < surface.triangles.size(); ++n) {
    // The triangle is projected along x into the first layer of cells, to find the columns over it.
    Triangle flat = corners(surface, n);
    for (auto& corner : flat) corner.x() = lattice.planes[0].front();
    for_each_cell(lattice, flat, margin, [&](int i, int j, int k) {
      if (i == 0) entries.emplace_back(j + row * k, static_cast<Index>(n));
    });
  }
  first_.assign(row * (lattice.cells[2] + 1) + 1, 0);
  for (const auto& [column, n] : entries) ++first_[column + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  triangles_.resize(entries.size());
  std::vector<std::int64_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [column, n] : entries) triangles_[next[column]++] = n;
}

int InsideTest::operator()(const Eigen::Vector3d& p) const {
  const std::int64_t column =
      lattice_->cell_of(1, p.y()) + (lattice_->cells[1] + 1LL) * lattice_->cell_of(2, p.z());
  bool inside = false;
  for (std::int64_t e = first_[column]; e < first_[column + 1]; ++e) {
    const Triangle t = corners(*surface_, triangles_[e]);
    const int side = facing(t);
    const int beyond = orientation(t[0], t[1], t[2], p);  // 0: in its plane
    if (beyond == 0 && in_closed_triangle(t, p)) return 0;
    if (side != 0 && projection_holds(t, side, p.y(), p.z()) && side * beyond > 0) inside = !inside;
  }
  return inside ? 1 : -1;
}

}  // namespace tetproof::reference
