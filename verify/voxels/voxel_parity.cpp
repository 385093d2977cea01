// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the voxel centres that are inside, by the parity of exact crossings along the rows of voxels.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "io/error.hpp"
#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Kernel::Point_2;
using Point3 = Kernel::Point_3;

int sign(double x) {
  return (x > 0) - (x < 0);
}

// The side of the directed line a b on which the point q lies once it is moved by (e, e^2), where e is an
// infinitesimal: then it is never on the line. 0 only if a = b. Exact, and antisymmetric in a and b, so that
// a row meets exactly one of the two triangles at an edge.
int side(const Point2& a, const Point2& b, const Point2& q) {
  if (const int s = static_cast<int>(CGAL::orientation(a, b, q))) return s;
  if (const int s = sign(a.y() - b.y())) return s;
  return sign(b.x() - a.x());
}

class TriangleRows {
 public:
  TriangleRows(const TriangleSurface& surface, std::size_t t, const VoxelLattice& lattice)
      : lattice_(lattice) {
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3d& v = surface.vertices[surface.triangles[t][c]];
      v_[c] = v;
      p_[c] = Point3(v[0], v[1], v[2]);
      flat_[c] = Point2(v[0], v[1]);
    }
  }

  // Toggles, in every row that the triangle crosses, the first centre that is not below it.
  void toggle(VoxelBits& bits) const {
    const auto [x0, x1] = std::minmax({v_[0][0], v_[1][0], v_[2][0]});
    for (int i = first_centre(0, x0); i < lattice_.size[0] && lattice_.centre(0, i) <= x1; ++i) {
      const double x = lattice_.centre(0, i);
      const auto [y0, y1] = span(x);
      for (int j = first_centre(1, y0 - lattice_.h);
           j < lattice_.size[1] && lattice_.centre(1, j) <= y1 + lattice_.h; ++j) {
        const Point2 q(x, lattice_.centre(1, j));
        const int s = side(flat_[0], flat_[1], q);
        if (s != 0 && s == side(flat_[1], flat_[2], q) && s == side(flat_[2], flat_[0], q))
          bits.toggle(i, j, first_above(q, s));
      }
    }
  }

 private:
  // The first voxel whose centre is not below `at`, or the last one.
  int first_centre(int axis, double at) const {
    const double guess = std::ceil(lattice_.position(axis, at) - 0.5);
    int i = static_cast<int>(std::clamp(guess, 0.0, lattice_.size[axis] - 1.0));
    while (i > 0 && lattice_.centre(axis, i - 1) >= at) --i;
    while (i + 1 < lattice_.size[axis] && lattice_.centre(axis, i) < at) ++i;
    return i;
  }

  // The range of y where the line at x meets the projected triangle, to rounding (far less than h).
  std::pair<double, double> span(double x) const {
    double y0 = INFINITY, y1 = -INFINITY;
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3d &a = v_[c], &b = v_[(c + 1) % 3];
      if (std::min(a[0], b[0]) > x || std::max(a[0], b[0]) < x) continue;
      const double at = a[0] == b[0] ? a[1] : a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
      y0 = std::min(y0, a[0] == b[0] ? std::min(a[1], b[1]) : at);
      y1 = std::max(y1, a[0] == b[0] ? std::max(a[1], b[1]) : at);
    }
    return {y0, y1};
  }

  // The first k whose centre is not below the triangle, in the row at q, which crosses it. `s`: the sense of
  // the triangle seen from above.
  int first_above(const Point2& q, int s) const {
    const auto above = [&](int k) {
      return s * static_cast<int>(
                     CGAL::orientation(p_[0], p_[1], p_[2], Point3(q.x(), q.y(), lattice_.centre(2, k)))) >=
             0;
    };
    const auto [z0, z1] = std::minmax({v_[0][2], v_[1][2], v_[2][2]});
    int low = first_centre(2, z0), high = first_centre(2, z1);  // it is in [low, high]
    if (low == high) return low;
    const double ax = v_[1][0] - v_[0][0], ay = v_[1][1] - v_[0][1], az = v_[1][2] - v_[0][2];
    const double bx = v_[2][0] - v_[0][0], by = v_[2][1] - v_[0][1], bz = v_[2][2] - v_[0][2];
    const double px = q.x() - v_[0][0], py = q.y() - v_[0][1];
    const double z = v_[0][2] + (px * (az * by - ay * bz) + py * (ax * bz - az * bx)) / (ax * by - ay * bx);
    if (z > z0 && z < z1) {  // false for NaN
      const int guess = std::clamp(first_centre(2, z), low, high);
      if (guess == high || above(guess)) {
        high = guess;
        if (guess == low || !above(guess - 1)) return guess;
        high = guess - 1;
      } else {
        low = guess + 1;
      }
    }
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (above(middle))
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  }

  const VoxelLattice& lattice_;
  std::array<Eigen::Vector3d, 3> v_;
  std::array<Point3, 3> p_;
  std::array<Point2, 3> flat_;
};

// Turns toggles into flags: bit k becomes the parity of the bits 0 .. k. Returns the parity of the whole row.
bool accumulate(std::uint64_t* row, std::size_t words) {
  std::uint64_t carry = 0;
  for (std::size_t w = 0; w < words; ++w) {
    std::uint64_t x = row[w];
    for (int shift = 1; shift < 64; shift *= 2) x ^= x << shift;
    row[w] = x ^ carry;
    carry = row[w] >> 63 ? ~std::uint64_t{0} : 0;
  }
  return carry != 0;
}

}  // namespace

VoxelBits inside_voxels(const TriangleSurface& surface, const VoxelLattice& lattice) {
  VoxelBits bits(lattice);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.triangles.size(), 256),
                    [&](const auto& range) {
                      for (std::size_t t = range.begin(); t < range.end(); ++t)
                        TriangleRows(surface, t, lattice).toggle(bits);
                    });
  std::atomic<int> odd_column = lattice.size[0];  // the first one, whatever the order of the threads
  tbb::parallel_for(0, lattice.size[0], [&](int i) {
    for (int j = 0; j < lattice.size[1]; ++j)
      if (accumulate(bits.row(i, j), bits.words_per_row()))
        for (int seen = odd_column; i < seen && !odd_column.compare_exchange_weak(seen, i);) {
        }
  });
  if (const int i = odd_column; i < lattice.size[0])
    throw InputError(
        fmt::format("the surface is open: a line along z at x = {} crosses it an odd number of times",
                    lattice.centre(0, i)));
  return bits;
}

}  // namespace tetproof::verify
