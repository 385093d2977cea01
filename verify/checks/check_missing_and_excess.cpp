// SPDX-License-Identifier: GPL-3.0-or-later
// What of the solid the mesh lacks and what it has too much, found by voxels and confirmed exactly.
#include <fmt/core.h>

#include <algorithm>

#include "verify/checks/surface_comparison.hpp"
#include "verify/mesh/tets_at.hpp"
#include "verify/voxel_volume.hpp"
#include "verify/voxels/deep_voxels.hpp"

namespace tetproof::verify {
namespace {

TriangleSurface surface_of(const Judgement& j, const std::vector<Triangle>& triangles) {
  return {.vertices = j.mesh.points, .triangles = triangles, .parameters = {}, .evaluate = {}};
}

// target = a and not b, a voxel at a time.
void keep_difference(const VoxelLattice& lattice, const VoxelBits& a, const VoxelBits& b, VoxelBits& target) {
  for (int i = 0; i < lattice.size[0]; ++i)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (std::size_t w = 0; w < a.words_per_row(); ++w)
        target.row(i, j)[w] = a.row(i, j)[w] & ~b.row(i, j)[w];
}

}  // namespace

void check_missing_and_excess(Judgement& j, Comparison& c, const std::vector<int>& own) {
  std::vector<Triangle> outer;
  const std::span<const Triangle> boundary = j.boundary.boundary_triangles();
  for (std::size_t i = 0; i < boundary.size(); ++i)
    if (const Index sheet = j.boundary.sheets.of_triangle[i]; sheet >= 0 && own[sheet])
      outer.push_back(boundary[i]);

  // All faces of the mesh that do not cancel: a point is in an odd number of tetrahedra if it is so of them.
  const TriangleSurface mesh = surface_of(j, j.boundary.triangles);
  TriangleSurface all = mesh;
  const auto shift = static_cast<Index>(all.vertices.size());
  all.vertices.insert(all.vertices.end(), c.surface.vertices.begin(), c.surface.vertices.end());
  for (const Triangle& t : c.surface.triangles)
    all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const VoxelLattice lattice = lay_voxels(all, j.options.voxels);
  all = {};

  VoxelBits in_mesh = mesh.triangles.empty() ? VoxelBits(lattice) : inside_voxels(mesh, lattice);
  VoxelBits wanted = inside_voxels(c.surface, lattice);
  const bool outside = j.options.region == Region::outside;
  if (outside) {
    VoxelBits around = outer.empty() ? VoxelBits(lattice) : inside_voxels(surface_of(j, outer), lattice);
    keep_difference(lattice, around, wanted, wanted);
  }
  const auto met = [&] {
    VoxelBits bits = met_voxels(c.surface, lattice);
    if (mesh.triangles.empty()) return bits;
    const VoxelBits other = met_voxels(mesh, lattice);
    for (int i = 0; i < lattice.size[0]; ++i)
      for (int k = 0; k < lattice.size[1]; ++k)
        for (std::size_t w = 0; w < bits.words_per_row(); ++w) bits.row(i, k)[w] |= other.row(i, k)[w];
    return bits;
  };
  // How far from the mesh: with its own outer boundary.
  std::optional<TriangleTree> whole_boundary;
  if (!outer.empty()) whole_boundary.emplace(TriangleSet{j.mesh.points, boundary}, c.mesh_tree->units());
  const TriangleTree& mesh_tree = whole_boundary ? *whole_boundary : *c.mesh_tree;

  std::vector<Eigen::Vector3d> off;
  for (const Index v : c.off_vertices) off.push_back(j.mesh.points[static_cast<std::size_t>(v)]);
  c.region_at_off_vertex.assign(off.size(), std::nullopt);
  const double each = lattice.h * lattice.h * lattice.h;
  for (const Check check : {Check::missing_region, Check::excess_region}) {
    if (!j.wants(check)) continue;
    const bool missing = check == Check::missing_region;
    VoxelBits difference(lattice);
    keep_difference(lattice, missing ? wanted : in_mesh, missing ? in_mesh : wanted, difference);
    const DeepVoxels deep =
        deep_voxels(lattice, difference, missing ? mesh_tree : *c.surface_tree, c.allowed, met, off);
    // Exactly: the voxels' parity is exact; in which tetrahedra the deepest centre lies is asked of them.
    std::vector<Eigen::Vector3d> centres;
    for (const VoxelRegion& region : deep.regions) centres.push_back(region.deepest);
    const std::vector<std::vector<Index>> tets = tets_at(j.mesh, j.excluded, centres);
    std::vector<Finding> findings;
    std::vector<std::size_t> place(deep.regions.size(), 0);
    double volume = 0, largest = 0;
    for (std::size_t i = 0; i < deep.regions.size(); ++i) {
      const VoxelRegion& region = deep.regions[i];
      if (tets[i].empty() != missing) continue;
      Finding finding{.tets = tets[i], .point = region.deepest};
      if (missing && region.nearest >= 0)
        finding.faces = {mesh_tree.set().triangles[static_cast<std::size_t>(region.nearest)]};
      const double size = static_cast<double>(region.voxels) * each;
      volume += size;
      largest = std::max(largest, size);
      finding.what = fmt::format(
          "a region of volume {:.6g} ({} voxels), off by at most {:.3g} within the voxels that it reaches, "
          "is {}; this "
          "point of it is {} from the {}",
          size, region.voxels, static_cast<double>(region.unsure) * each,
          missing ? "not filled by the mesh" : "in the mesh and should not be",
          region.nearest < 0 ? "infinitely far" : fmt::format("{:.6g}", region.depth),
          missing   ? "mesh"
          : outside ? "outside of the surface"
                    : "solid");
      place[i] = findings.size() + 1;
      findings.push_back(std::move(finding));
    }
    (missing ? j.report.volume.missing : j.report.volume.excess) = volume;
    CheckResult& result = j.report.checks[static_cast<std::size_t>(check)];
    result.measured = largest;
    for (std::size_t v = 0; v < off.size(); ++v)
      if (const std::int32_t region = deep.region_at[v];
          region >= 0 && place[static_cast<std::size_t>(region)] && !c.region_at_off_vertex[v])
        c.region_at_off_vertex[v] = Cause{check, place[static_cast<std::size_t>(region)] - 1};
    if (!findings.empty() && !c.region) c.region = Cause{check, 0};
    const std::size_t count = findings.size();
    j[check] = {.count = count,
                .finding = [findings](std::size_t i) { return findings[i]; },
                .describe = [](std::size_t, Finding&) {}};
  }
}

}  // namespace tetproof::verify
