// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/voxels/box_voxels.hpp"

namespace tetproof::verify {
namespace {

// The first voxel along an axis whose centre is not before x (strictly: is behind x).
int first_voxel(const VoxelLattice& lattice, int axis, double x, bool strictly) {
  int first = 0, count = lattice.size[static_cast<std::size_t>(axis)];
  while (count > 0) {  // centres ascend
    const int half = count / 2;
    const double centre = lattice.centre(axis, first + half);
    if (centre < x || (strictly && centre == x))
      first += half + 1, count -= half + 1;
    else
      count = half;
  }
  return first;
}

}  // namespace

VoxelBits voxels_in_boxes(const std::vector<std::array<Eigen::Vector3d, 2>>& boxes, double room,
                          const VoxelLattice& lattice) {
  VoxelBits bits(lattice);
  for (const auto& [low, high] : boxes) {
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
      first[static_cast<std::size_t>(axis)] = first_voxel(lattice, axis, low[axis] - room, false);
      last[static_cast<std::size_t>(axis)] = first_voxel(lattice, axis, high[axis] + room, true);
    }
    for (int i = first[0]; i < last[0]; ++i)
      for (int j = first[1]; j < last[1]; ++j)
        for (int k = first[2]; k < last[2]; ++k) bits.set(i, j, k);
  }
  return bits;
}

}  // namespace tetproof::verify
