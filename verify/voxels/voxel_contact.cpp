// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the voxels that the surface meets: a descent through cubes of 2^l voxels. A cube is left out only if
// it is certainly separate from the triangle.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {
namespace {

bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// Why the result contains all voxels that the surface meets. Coordinates are in voxels, relative to a corner
// `base_` of the triangle's first voxel, whose planes are exact doubles. So each is off by at most 2^-52 of
// itself: below 3e-13 up to 1100 voxels away, the longest side of a lattice. (`margin_` is wider for a
// triangle that reaches farther out of the lattice.) A convex cube and a convex triangle are disjoint if
// their projections on some direction are disjoint. The directions below are the classical ones, the normal
// and edges x axes, as floating point computes them. Whatever they are, the dot products of three terms with
// |direction|_1 = A are off by less than 1.3e-12 A, the error above included, and only a gap of more than
// `margin_` A, at least 4e-12 A, counts. So no voxel that the surface meets is left out. That the directions
// are close to the classical ones only keeps the set small.
class TriangleVoxels {
 public:
  TriangleVoxels(const TriangleSurface& surface, std::size_t t, const VoxelLattice& lattice) {
    std::array<Eigen::Vector3d, 3> v;
    for (int c = 0; c < 3; ++c) v[c] = surface.vertices[surface.triangles[t][c]];
    std::sort(v.begin(), v.end(), before);  // the order of the corners must not matter
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({v[0][axis], v[1][axis], v[2][axis]});
      const double first = std::floor(lattice.position(axis, low));
      base_[axis] = static_cast<int>(std::clamp(first, 0.0, lattice.size[axis] - 1.0));
      const double plane = lattice.plane(axis, base_[axis]);
      for (int c = 0; c < 3; ++c) u_[c][axis] = (v[c][axis] - plane) / lattice.h;
    }
    double farthest = 0;
    for (const Eigen::Vector3d& u : u_) farthest = std::max(farthest, u.lpNorm<Eigen::Infinity>());
    margin_ = 4e-12 * std::max(1.0, farthest / 1100);
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({u_[0][axis], u_[1][axis], u_[2][axis]});
      const double least = -base_[axis], most = lattice.size[axis] - 1 - base_[axis];
      // Nothing of a triangle beside the lattice is in it: then the first voxel comes after the last.
      first_[axis] = static_cast<int>(std::clamp(std::ceil(low - margin_) - 1, least, most + 1));
      last_[axis] = static_cast<int>(std::clamp(std::floor(high + margin_), least - 1, most));
    }
  }

  void set(VoxelBits& bits) {
    int long_sides = 0, longest = 1;
    for (int axis = 0; axis < 3; ++axis) {
      long_sides += last_[axis] > first_[axis];
      longest = std::max(longest, last_[axis] - first_[axis] + 1);
    }
    if (long_sides > 1) find_directions();  // in a single row every voxel between the ends is met
    int size = 1;
    while (size < longest) size *= 2;
    descend(first_, size, bits);
  }

 private:
  struct Direction {
    Eigen::Vector3d a;
    double low, high;           // the triangle's projection, widened by the margin
    double positive, negative;  // sums of the positive and of the negative components
  };

  void add(const Eigen::Vector3d& a) {
    const std::array<double, 3> p{a.dot(u_[0]), a.dot(u_[1]), a.dot(u_[2])};
    const auto [low, high] = std::minmax({p[0], p[1], p[2]});
    const double slack = margin_ * a.lpNorm<1>();
    directions_[count_++] = {a, low - slack, high + slack, a.cwiseMax(0).sum(), a.cwiseMin(0).sum()};
  }

  void find_directions() {
    const std::array<Eigen::Vector3d, 3> edges{u_[1] - u_[0], u_[2] - u_[1], u_[0] - u_[2]};
    add(edges[0].cross(edges[1]));
    for (const Eigen::Vector3d& e : edges) {
      add({0, -e[2], e[1]});
      add({e[2], 0, -e[0]});
      add({-e[1], e[0], 0});
    }
  }

  bool apart(const Eigen::Vector3d& corner, int size) const {
    for (int d = 0; d < count_; ++d) {
      const Direction& direction = directions_[d];
      const double at = direction.a.dot(corner);
      if (at + size * direction.positive < direction.low || at + size * direction.negative > direction.high)
        return true;
    }
    return false;
  }

  void descend(const std::array<int, 3>& corner, int size, VoxelBits& bits) const {
    for (int axis = 0; axis < 3; ++axis)
      if (corner[axis] > last_[axis]) return;
    if (apart(Eigen::Vector3d(corner[0], corner[1], corner[2]), size)) return;
    if (size == 1) return bits.set(base_[0] + corner[0], base_[1] + corner[1], base_[2] + corner[2]);
    const int half = size / 2;
    for (int child = 0; child < 8; ++child)
      descend({corner[0] + (child & 1 ? half : 0), corner[1] + (child & 2 ? half : 0),
               corner[2] + (child & 4 ? half : 0)},
              half, bits);
  }

  std::array<int, 3> base_, first_, last_;
  std::array<Eigen::Vector3d, 3> u_;
  double margin_;
  std::array<Direction, 10> directions_;
  int count_ = 0;
};

}  // namespace

VoxelBits met_voxels(const TriangleSurface& surface, const VoxelLattice& lattice) {
  VoxelBits bits(lattice);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.triangles.size(), 256),
                    [&](const auto& range) {
                      for (std::size_t t = range.begin(); t < range.end(); ++t)
                        TriangleVoxels(surface, t, lattice).set(bits);
                    });
  return bits;
}

}  // namespace tetproof::verify
