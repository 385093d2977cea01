// SPDX-License-Identifier: GPL-3.0-or-later
// Lays voxels over a surface and adds them up. OpenVDB keeps the voxels. Its own sign, which a flood fill
// decides, is wrong on cavities; ours comes from parity.
#include "verify/voxel_volume.hpp"

#include <fmt/format.h>
#include <openvdb/tree/LeafNodeMask.h>
#include <openvdb/tree/Tree.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <bit>
#include <cmath>

#include "io/error.hpp"
#include "verify/voxels/surface_voxels.hpp"
#include "verify/voxels/voxel_lattice.hpp"

namespace tetproof::verify {
namespace {

// The nodes of OpenVDB's tree, without `Tree` itself. Its virtual functions for files need libopenvdb.so,
// which takes longer to load than a small mesh takes to judge; the nodes need only headers.
using MaskTree = openvdb::tree::Tree4<openvdb::ValueMask, 5, 4, 3>::Type::RootNodeType;
using Leaf = MaskTree::LeafNodeType;

// The tree of all set bits: leaves of 8 x 8 x 8 voxels, and tiles where all 512 are set.
std::unique_ptr<const MaskTree> make_tree(const VoxelBits& bits, const VoxelLattice& lattice) {
  const auto blocks = [&](int axis) { return (lattice.size[axis] + 7) / 8; };
  auto tree = std::make_unique<MaskTree>(false);
  std::vector<std::vector<std::unique_ptr<Leaf>>> columns(static_cast<std::size_t>(blocks(0)) * blocks(1));
  tbb::parallel_for(std::size_t{0}, columns.size(), [&](std::size_t column) {
    const int bi = static_cast<int>(column) / blocks(1) * 8, bj = static_cast<int>(column) % blocks(1) * 8;
    for (int bk = 0; bk < lattice.size[2]; bk += 8) {
      openvdb::util::NodeMask<3>
          mask;  // bit (x << 6) + (y << 3) + z: byte y of word x is eight voxels along z
      for (int x = 0; x < 8 && bi + x < lattice.size[0]; ++x)
        for (int y = 0; y < 8 && bj + y < lattice.size[1]; ++y) {
          const std::uint64_t byte = bits.row(bi + x, bj + y)[bk >> 6] >> (bk & 63) & 0xff;
          mask.getWord<openvdb::util::NodeMask<3>::Word>(x) |= byte << (8 * y);
        }
      if (mask.isOff()) continue;
      columns[column].push_back(std::make_unique<Leaf>(openvdb::Coord(bi, bj, bk)));
      columns[column].back()->setValueMask(mask);
    }
  });
  for (auto& column : columns)
    for (auto& leaf : column) {
      if (leaf->isValueMaskOn())
        tree->addTile(1, leaf->origin(), true, true);
      else
        tree->addLeaf(leaf.release());
    }
  return tree;
}

std::int64_t count_bits(const VoxelBits& bits, const VoxelLattice& lattice) {
  std::int64_t count = 0;
  for (int i = 0; i < lattice.size[0]; ++i)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (std::size_t w = 0; w < bits.words_per_row(); ++w) count += std::popcount(bits.row(i, j)[w]);
  return count;
}

}  // namespace

struct VoxelSets {
  std::unique_ptr<const MaskTree> inside, met;
};

VoxelLattice lay_voxels(const TriangleSurface& surface, int along_longest_side) {
  if (along_longest_side < least_voxels || along_longest_side > most_voxels)
    throw InputError(fmt::format("voxels along the longest side: expected {} to {}, found {}", least_voxels,
                                 most_voxels, along_longest_side));
  if (surface.triangles.empty()) throw InputError("the surface has no triangles");
  Eigen::Vector3d low = Eigen::Vector3d::Constant(INFINITY), high = -low;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) {
      if (v < 0 || static_cast<std::size_t>(v) >= surface.vertices.size())
        throw InputError(fmt::format("triangle {} names vertex {}, which the surface does not have", t, v));
      if (!surface.vertices[v].allFinite())
        throw InputError(fmt::format("vertex {} of the surface is not finite", v));
      low = low.cwiseMin(surface.vertices[v]);
      high = high.cwiseMax(surface.vertices[v]);
    }
  const double side = (high - low).maxCoeff();
  if (!(side >= 1e-98 && side <= 1e98))  // the volume of a voxel must be a normal double
    throw VoxelRangeError(
        fmt::format("the longest side of the surface's box is {}, expected 1e-98 to 1e98", side));
  int exponent;
  const double digits = std::frexp(side / along_longest_side, &exponent);
  const double h = std::ldexp(std::ceil(std::ldexp(digits, 12)), exponent - 12);
  VoxelLattice lattice{.h = h, .first = {}, .size = {}};
  for (int axis = 0; axis < 3; ++axis) {
    const double phase = VoxelLattice::phase[axis] / 32.0;
    const double below = std::floor(low[axis] / h - phase), above = std::floor(high[axis] / h - phase);
    if (std::max(-below, above) > 1e10)
      throw VoxelRangeError(
          fmt::format("the surface is too far from the origin for {} voxels along its longest side ({})",
                      along_longest_side, side));
    lattice.first[axis] = static_cast<std::int64_t>(below) - 1;
    lattice.size[axis] = static_cast<int>(static_cast<std::int64_t>(above) + 2 - lattice.first[axis]);
    // The quotients may have been rounded across a plane.
    if (lattice.plane(axis, 1) > low[axis]) --lattice.first[axis], ++lattice.size[axis];
    if (lattice.plane(axis, lattice.size[axis] - 1) <= high[axis]) ++lattice.size[axis];
  }
  return lattice;
}

namespace {

VoxelVolume add_up(const VoxelLattice& lattice, const VoxelBits& inside, const VoxelBits& met) {
  VoxelVolume volume;
  volume.voxel_size = lattice.h;
  volume.voxels = lattice.size;
  volume.origin = {lattice.plane(0, 0), lattice.plane(1, 0), lattice.plane(2, 0)};
  volume.inside_count = count_bits(inside, lattice);
  volume.met_count = count_bits(met, lattice);
  const double each = lattice.h * lattice.h * lattice.h;
  volume.inside = static_cast<double>(volume.inside_count) * each;
  // The two products are rounded at most four times each.
  volume.error_bound = static_cast<double>(volume.met_count) * each * (1 + 1e-15) + 1e-15 * volume.inside;
  volume.sets =
      std::make_shared<const VoxelSets>(VoxelSets{make_tree(inside, lattice), make_tree(met, lattice)});
  return volume;
}

}  // namespace

VoxelVolume voxel_volume(const TriangleSurface& surface, int voxels_along_longest_side) {
  const VoxelLattice lattice = lay_voxels(surface, voxels_along_longest_side);
  return add_up(lattice, inside_voxels(surface, lattice), met_voxels(surface, lattice));
}

namespace {

SurfaceVoxels make_voxels(const TriangleSurface& surface, int voxels_along_longest_side) {
  const VoxelLattice lattice = lay_voxels(surface, voxels_along_longest_side);
  SurfaceVoxels voxels{.lattice = lattice,
                       .inside = inside_voxels(surface, lattice),
                       .met = met_voxels(surface, lattice),
                       .volume = {},
                       .error_estimate = {}};
  voxels.volume = add_up(lattice, voxels.inside, voxels.met);
  if (const int half = voxels_along_longest_side / 2; half >= least_voxels)
    voxels.error_estimate = std::abs(voxels.volume.inside - voxel_volume(surface, half).inside);
  return voxels;
}

}  // namespace

std::shared_ptr<const SurfaceVoxels> KeptVoxels::of(const TriangleSurface& surface,
                                                    int voxels_along_longest_side) {
  const std::lock_guard lock(mutex_);
  if (voxels_ && number_ == voxels_along_longest_side) return voxels_;
  // Isolated: a thread that waits for its parts must not take up another mesh, which would wait for the lock.
  voxels_ = tbb::this_task_arena::isolate(
      [&] { return std::make_shared<const SurfaceVoxels>(make_voxels(surface, voxels_along_longest_side)); });
  number_ = voxels_along_longest_side;
  return voxels_;
}

bool is_inside(const VoxelVolume& volume, int i, int j, int k) {
  return volume.sets && volume.sets->inside->isValueOn(openvdb::Coord(i, j, k));
}

bool meets_surface(const VoxelVolume& volume, int i, int j, int k) {
  return volume.sets && volume.sets->met->isValueOn(openvdb::Coord(i, j, k));
}

Eigen::Vector3d voxel_centre(const VoxelVolume& volume, int i, int j, int k) {
  return volume.origin + volume.voxel_size * (Eigen::Vector3d(i, j, k) + Eigen::Vector3d::Constant(0.5));
}

}  // namespace tetproof::verify
