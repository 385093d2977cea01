// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/voxels/deep_voxels.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "verify/triangles/disjoint_sets.hpp"

namespace tetproof::verify {
namespace {

constexpr int block = 8;
const double half_diagonal = std::sqrt(3.0) / 2;  // of a voxel, in voxels

using Voxel = std::array<int, 3>;

// A voxel whose centre's depth is known.
struct Probe {
  Voxel voxel;
  double depth;  // [units], a lower bound
};

// Consecutive voxels of one row that belong to one region.
struct Run {
  int i, j, begin, end;
};

class Sounding {
 public:
  Sounding(const VoxelLattice& lattice, const VoxelBits& set, const TriangleTree& tree, double depth)
      : lattice_(lattice),
        set_(set),
        tree_(tree),
        deep(lattice),
        sure(lattice),
        near(lattice),
        h_(lattice.h / tree.units().scale),
        limit_(depth / tree.units().scale + distance_slack) {}

  void run() {
    std::array<int, 3> blocks;
    for (int axis = 0; axis < 3; ++axis) blocks[axis] = (lattice_.size[axis] + block - 1) / block;
    const std::size_t columns = static_cast<std::size_t>(blocks[0]) * blocks[1];
    std::vector<std::vector<Probe>> found(columns);
    tbb::parallel_for(std::size_t{0}, columns, [&](std::size_t c) {
      const int i = static_cast<int>(c) / blocks[1] * block, j = static_cast<int>(c) % blocks[1] * block;
      Index guess = -1;
      for (int k = 0; k < lattice_.size[2]; k += block) look({i, j, k}, block, guess, found[c]);
    });
    for (const auto& part : found) probes.insert(probes.end(), part.begin(), part.end());
  }

 private:
  const VoxelLattice& lattice_;
  const VoxelBits& set_;
  const TriangleTree& tree_;

 public:
  // Voxels of the set: those whose centres are deeper; those that are deeper as a whole; those whose centres
  // are not deeper, but by less than half a diagonal.
  VoxelBits deep, sure, near;
  std::vector<Probe> probes;

 private:
  template <class Visit>
  void for_each(const Voxel& corner, int size, const Visit& visit) const {
    for (int i = corner[0]; i < std::min(corner[0] + size, lattice_.size[0]); ++i)
      for (int j = corner[1]; j < std::min(corner[1] + size, lattice_.size[1]); ++j)
        for (int k = corner[2]; k < std::min(corner[2] + size, lattice_.size[2]); ++k)
          if (set_(i, j, k)) visit(Voxel{i, j, k});
  }

  // Judges a cube of voxels by the depth at its middle, and by its parts where that does not decide.
  void look(const Voxel& corner, int size, Index& guess, std::vector<Probe>& found) {
    bool any = false;
    const int last = std::min(corner[2] + size, lattice_.size[2]);
    for (int i = corner[0]; !any && i < std::min(corner[0] + size, lattice_.size[0]); ++i)
      for (int j = corner[1]; !any && j < std::min(corner[1] + size, lattice_.size[1]); ++j)
        any = (set_.row(i, j)[corner[2] >> 6] >> (corner[2] & 63) &
               ((std::uint64_t{1} << (last - corner[2])) - 1)) != 0;
    if (!any) return;
    Eigen::Vector3d middle;
    for (int axis = 0; axis < 3; ++axis)
      middle[axis] = lattice_.centre(axis, corner[axis]) + (size - 1) * lattice_.h / 2;
    const double reach = (size - 1) * half_diagonal * h_, half = half_diagonal * h_;
    const TriangleTree::Nearest nearest =
        tree_.nearest(tree_.units().to(middle), guess, std::max(0.0, limit_ - reach - half));
    guess = nearest.triangle;
    const double depth = std::sqrt(nearest.squared);
    if (depth + reach + half <= limit_) return;
    if (size > 1 && depth - reach <= limit_ + half) {
      for (int child = 0; child < 8; ++child) {
        Voxel at = corner;
        bool in = true;
        for (int axis = 0; axis < 3; ++axis) {
          at[axis] += child >> axis & 1 ? size / 2 : 0;
          in = in && at[axis] < lattice_.size[axis];
        }
        if (in) look(at, size / 2, guess, found);
      }
      return;
    }
    if (size == 1) {
      const auto& [i, j, k] = corner;
      if (depth <= limit_) return near.set(i, j, k);
      deep.set(i, j, k);
      if (depth > limit_ + half) sure.set(i, j, k);
      found.push_back({corner, depth});
      return;
    }
    Probe probe{corner, -1};  // the voxel nearest to the middle
    for_each(corner, size, [&](const Voxel& v) {
      deep.set(v[0], v[1], v[2]);
      sure.set(v[0], v[1], v[2]);
      Eigen::Vector3d off;
      for (int axis = 0; axis < 3; ++axis) off[axis] = v[axis] - corner[axis] - (size - 1) / 2.0;
      if (const double at = depth - off.norm() * h_; at > probe.depth) probe = {v, at};
    });
    found.push_back(probe);
  }

  double h_, limit_;
};

std::vector<Run> runs_of(const VoxelBits& bits, const VoxelLattice& lattice) {
  std::vector<Run> runs;
  for (int i = 0; i < lattice.size[0]; ++i)
    for (int j = 0; j < lattice.size[1]; ++j) {
      const std::uint64_t* row = bits.row(i, j);
      for (int k = 0; k < lattice.size[2]; ++k) {
        if ((k & 63) == 0 && row[k >> 6] == 0) {
          k += 63;
          continue;
        }
        if (!bits(i, j, k)) continue;
        const int begin = k;
        while (k < lattice.size[2] && bits(i, j, k)) ++k;
        runs.push_back({i, j, begin, k});
      }
    }
  return runs;
}

// The runs of row (i, j) that overlap [begin, end), as a range of positions.
std::pair<std::size_t, std::size_t> runs_at(const std::vector<Run>& runs, int i, int j, int begin, int end) {
  const auto row = [&](const Run& r) { return std::pair(r.i, r.j); };
  const auto first = std::partition_point(runs.begin(), runs.end(), [&](const Run& r) {
    return row(r) < std::pair(i, j) || (row(r) == std::pair(i, j) && r.end <= begin);
  });
  auto last = first;
  while (last != runs.end() && row(*last) == std::pair(i, j) && last->begin < end) ++last;
  return {static_cast<std::size_t>(first - runs.begin()), static_cast<std::size_t>(last - runs.begin())};
}

std::vector<std::size_t> components(const std::vector<Run>& runs) {
  DisjointSets sets(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const auto& [di, dj] : {std::pair(-1, -1), std::pair(-1, 0), std::pair(-1, 1), std::pair(0, -1)}) {
      const auto [first, last] =
          runs_at(runs, runs[r].i + di, runs[r].j + dj, runs[r].begin - 1, runs[r].end + 1);
      for (std::size_t other = first; other < last; ++other)
        sets.unite(static_cast<Index>(r), static_cast<Index>(other));
    }
  std::vector<std::size_t> lowest(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
    lowest[r] = static_cast<std::size_t>(sets.find(static_cast<Index>(r)));
  return lowest;
}

}  // namespace

DeepVoxels deep_voxels(const VoxelLattice& lattice, const VoxelBits& set, const TriangleTree& tree,
                       double depth, const std::function<VoxelBits()>& met,
                       std::span<const Eigen::Vector3d> points) {
  DeepVoxels result;
  result.region_at.assign(points.size(), -1);
  Sounding sounding(lattice, set, tree, depth);
  sounding.run();
  const std::vector<Run> runs = runs_of(sounding.deep, lattice);
  if (runs.empty()) return result;
  std::vector<std::size_t> component = components(runs);

  // Numbers the regions, the largest first.
  std::vector<std::int64_t> voxels(runs.size(), 0);
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    voxels[component[r]] += runs[r].end - runs[r].begin;
    if (component[r] == r) order.push_back(r);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return voxels[a] > voxels[b]; });
  std::vector<std::int32_t> number(runs.size(), -1);
  for (std::size_t n = 0; n < order.size(); ++n) {
    number[order[n]] = static_cast<std::int32_t>(n);
    result.regions.push_back({.voxels = voxels[order[n]]});
  }
  const auto region_of = [&](std::size_t run) { return number[component[run]]; };
  const auto centre = [&](const Voxel& v) {
    return Eigen::Vector3d(lattice.centre(0, v[0]), lattice.centre(1, v[1]), lattice.centre(2, v[2]));
  };

  std::vector<Probe> deepest(result.regions.size(), Probe{{}, -1});
  for (const Probe& probe : sounding.probes) {
    const auto& [i, j, k] = probe.voxel;
    Probe& best = deepest[static_cast<std::size_t>(region_of(runs_at(runs, i, j, k, k + 1).first))];
    if (probe.depth > best.depth) best = probe;
  }
  for (std::size_t n = 0; n < result.regions.size(); ++n) {
    // Moves on to deeper neighbours, as long as there are any.
    TriangleTree::Nearest here = tree.nearest(tree.units().to(centre(deepest[n].voxel)));
    for (bool deeper = true; deeper;) {
      deeper = false;
      const Voxel from = deepest[n].voxel;
      for (int step = 0; step < 27; ++step) {
        const Voxel v{from[0] + step % 3 - 1, from[1] + step / 3 % 3 - 1, from[2] + step / 9 - 1};
        bool in = true;
        for (int axis = 0; axis < 3; ++axis) in = in && v[axis] >= 0 && v[axis] < lattice.size[axis];
        if (!in || !sounding.deep(v[0], v[1], v[2])) continue;
        const TriangleTree::Nearest there = tree.nearest(tree.units().to(centre(v)), here.triangle);
        if (!(there.squared > here.squared)) continue;
        here = there;
        deepest[n].voxel = v;
        deeper = true;
      }
    }
    result.regions[n].deepest = centre(deepest[n].voxel);
    result.regions[n].nearest = here.triangle;
    result.regions[n].depth = std::max(0.0, std::sqrt(here.squared) - distance_slack) * tree.units().scale;
  }

  // The voxels next to a region are in the rows around its runs. A voxel next to two regions counts for both.
  const VoxelBits cut = met();
  std::vector<std::vector<std::size_t>> runs_of_region(result.regions.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
    runs_of_region[static_cast<std::size_t>(region_of(r))].push_back(r);
  tbb::parallel_for(std::size_t{0}, result.regions.size(), [&](std::size_t n) {
    std::vector<Run> reach;
    for (const std::size_t r : runs_of_region[n])
      for (int i = std::max(0, runs[r].i - 1); i < std::min(lattice.size[0], runs[r].i + 2); ++i)
        for (int j = std::max(0, runs[r].j - 1); j < std::min(lattice.size[1], runs[r].j + 2); ++j)
          reach.push_back({i, j, std::max(0, runs[r].begin - 1), std::min(lattice.size[2], runs[r].end + 1)});
    std::sort(reach.begin(), reach.end(), [](const Run& a, const Run& b) {
      return std::tie(a.i, a.j, a.begin, a.end) < std::tie(b.i, b.j, b.begin, b.end);
    });
    int i = -1, j = -1, done = 0;
    for (const Run& run : reach) {
      if (run.i != i || run.j != j) i = run.i, j = run.j, done = 0;
      for (int k = std::max(done, run.begin); k < run.end; ++k) {
        const bool unsure =
            cut(i, j, k) || sounding.near(i, j, k) || (sounding.deep(i, j, k) && !sounding.sure(i, j, k));
        result.regions[n].unsure += unsure;
      }
      done = std::max(done, run.end);
    }
  });

  for (std::size_t p = 0; p < points.size(); ++p) {
    Voxel v;
    bool near = true;  // the point may be beside the lattice
    for (int axis = 0; axis < 3; ++axis) {
      const double at = std::floor(lattice.position(axis, points[p][axis])), last = lattice.size[axis] - 1.0;
      near = near && at >= -1 && at <= last + 1;
      v[axis] = static_cast<int>(std::clamp(at, 0.0, last));
    }
    if (!near) continue;
    for (int i = v[0] - 1; i <= v[0] + 1; ++i)
      for (int j = v[1] - 1; j <= v[1] + 1; ++j)
        if (const auto [first, last] = runs_at(runs, i, j, v[2] - 1, v[2] + 2);
            first < last && result.region_at[p] < 0)
          result.region_at[p] = region_of(first);
  }
  return result;
}

}  // namespace tetproof::verify
