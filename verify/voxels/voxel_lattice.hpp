// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice of voxels over a surface, and sets of its voxels. Internal.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::verify {

/// Cubes of side h. Voxel i along an axis reaches from plane(axis, i) to plane(axis, i + 1), with its centre
/// halfway. Plane i is at (k + phase / 32) h with k = first[axis] + i. With h of 12 significant bits and
/// |k| < 2^34, planes and centres are exact doubles. The phases keep the planes away from the symmetry planes
/// and round numbers of models. Without them all eight octants of a sphere about the origin would have the
/// same errors, and the faces of boxes would meet two layers of voxels.
struct VoxelLattice {
  static constexpr std::array<int, 3> phase{5, 9, 13};

  double h = 0;
  std::array<std::int64_t, 3> first{};
  std::array<int, 3> size{};

  double plane(int axis, int i) const {
    return static_cast<double>(32 * (first[axis] + i) + phase[axis]) * (h / 32);
  }
  double centre(int axis, int i) const {
    return static_cast<double>(32 * (first[axis] + i) + phase[axis] + 16) * (h / 32);
  }
  /// The place of `x`, counted in voxels from plane 0, to rounding.
  double position(int axis, double x) const { return (x - plane(axis, 0)) / h; }

  bool operator==(const VoxelLattice&) const = default;
};

/// Lays about `along_longest_side` voxels along the longest side of the surface's box, and at least one more
/// on every side, so that the outermost centres are outside the box. InputError if the surface has no extent,
/// is not finite, or lies so far from the origin that the planes would not be exact.
VoxelLattice lay_voxels(const TriangleSurface& surface, int along_longest_side);

/// A set of voxels: one bit for each voxel of a lattice, in rows along z of whole 64-bit words. Many threads
/// may set bits at once, or toggle them; both commute, so the result does not depend on the order.
class VoxelBits {
 public:
  explicit VoxelBits(const VoxelLattice& lattice)
      : ny_(lattice.size[1]),
        words_per_row_((static_cast<std::size_t>(lattice.size[2]) + 63) / 64),
        words_(words_per_row_ * lattice.size[0] * lattice.size[1], 0) {}

  std::size_t words_per_row() const { return words_per_row_; }
  std::uint64_t* row(int i, int j) {
    return words_.data() + (static_cast<std::size_t>(i) * ny_ + j) * words_per_row_;
  }
  const std::uint64_t* row(int i, int j) const {
    return words_.data() + (static_cast<std::size_t>(i) * ny_ + j) * words_per_row_;
  }
  void set(int i, int j, int k) {
    std::atomic_ref word(row(i, j)[k >> 6]);
    const std::uint64_t bit = std::uint64_t{1} << (k & 63);
    if (!(word.load(std::memory_order_relaxed) & bit)) word.fetch_or(bit, std::memory_order_relaxed);
  }
  bool operator()(int i, int j, int k) const { return row(i, j)[k >> 6] >> (k & 63) & 1; }
  void toggle(int i, int j, int k) {
    std::atomic_ref(row(i, j)[k >> 6]).fetch_xor(std::uint64_t{1} << (k & 63), std::memory_order_relaxed);
  }

  // Both sets are of the same lattice.
  VoxelBits& operator|=(const VoxelBits& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
    return *this;
  }
  /// The voxels of this set that are not in `other`.
  VoxelBits without(const VoxelBits& other) const {
    VoxelBits rest = *this;
    for (std::size_t w = 0; w < words_.size(); ++w) rest.words_[w] &= ~other.words_[w];
    return rest;
  }

 private:
  std::size_t ny_, words_per_row_;
  std::vector<std::uint64_t> words_;
};

/// The voxels whose centres are inside: on their line along z, the surface is crossed an odd number of times
/// below them. Exact for every centre that is not on the surface. InputError if a line crosses the surface an
/// odd number of times in all, which cannot happen with a closed surface. The surface may reach out of the
/// lattice; then the last voxel of each row may be wrong.
VoxelBits inside_voxels(const TriangleSurface& surface, const VoxelLattice& lattice);

/// The closed voxels that the surface meets, and perhaps some that it misses by at most 1e-11 h.
VoxelBits met_voxels(const TriangleSurface& surface, const VoxelLattice& lattice);

}  // namespace tetproof::verify
