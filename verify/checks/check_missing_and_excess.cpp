// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for regions that the mesh lacks or has in excess: found by voxels, confirmed exactly.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "verify/checks/surface_comparison.hpp"
#include "verify/mesh/tets_at.hpp"
#include "verify/voxel_volume.hpp"
#include "verify/voxels/box_voxels.hpp"
#include "verify/voxels/deep_voxels.hpp"

namespace tetproof::verify {
namespace {

TriangleSurface surface_of(const TetMesh& mesh, std::vector<Triangle> triangles) {
  return {.vertices = mesh.points, .triangles = std::move(triangles), .parameters = {}, .evaluate = {}};
}

// Mesh and surface in one lattice.
struct Voxels {
  VoxelLattice lattice;
  VoxelBits in_mesh, wanted;
  std::function<VoxelBits()> met;  // voxels that mesh or surface meet
};

// `mesh`: all faces that do not cancel. A point is in an odd number of tetrahedra if it is so in these faces.
// `outer`: those that are the mesh's own outer boundary. `own`: the surface in its own lattice, or null;
// where that is this lattice, its voxels are not made again.
Voxels voxelise(const Comparison& c, const VoxelLattice& lattice, const TriangleSurface& mesh,
                const std::vector<Triangle>& outer, const SurfaceVoxels* own) {
  const Options& options = c.judged_mesh.options;
  if (own && !(own->lattice == lattice)) own = nullptr;
  VoxelBits wanted = own ? own->inside : inside_voxels(c.surface, lattice);
  if (options.region == Region::outside)
    wanted =
        (outer.empty() ? VoxelBits(lattice) : inside_voxels(surface_of(c.judged_mesh.mesh, outer), lattice))
            .without(wanted);
  return {.lattice = lattice,
          .in_mesh = mesh.triangles.empty() ? VoxelBits(lattice) : inside_voxels(mesh, lattice),
          .wanted = std::move(wanted),
          .met = [&c, &mesh, own, lattice] {
            VoxelBits bits = own ? own->met : met_voxels(c.surface, lattice);
            if (!mesh.triangles.empty()) bits |= met_voxels(mesh, lattice);
            return bits;
          }};
}

// The lattice lies over all that can lack the mesh, or be too much, and over no more. So it resolves that,
// even if the other of mesh and surface is a thousand times as large, or far away: units were mixed up, say.
VoxelLattice lattice_for(Check check, const Comparison& c, const TriangleSurface& mesh) {
  const bool in_surface = check == Check::missing_region && c.judged_mesh.options.region == Region::inside;
  return lay_voxels(in_surface || mesh.triangles.empty() ? c.surface : mesh, c.judged_mesh.options.voxels);
}

// A region, before its deepest point is confirmed.
Finding finding_of(const VoxelRegion& region, double voxel_volume, const char* is, const char* from) {
  Finding finding{.point = region.deepest};
  finding.what = fmt::format(
      "a region of volume {:.6g} ({} voxels), off by at most {:.3g} within the voxels that it reaches, "
      "is {}; this point of it is {} from the {}",
      static_cast<double>(region.voxels) * voxel_volume, region.voxels,
      static_cast<double>(region.unsure) * voxel_volume, is,
      region.nearest < 0 ? "infinitely far" : fmt::format("{:.6g}", region.depth), from);
  return finding;
}

bool can_lay(Check check, const Comparison& c, const TriangleSurface& mesh) {
  try {
    lattice_for(check, c, mesh);
    return true;
  } catch (const VoxelRangeError&) {
    return false;
  }
}

}  // namespace

RegionEvidence check_missing_and_excess(const Comparison& c, const DistanceEvidence& distances,
                                        const std::vector<int>& own, const SurfaceVoxels* surface_voxels,
                                        Record& record) {
  const JudgedMesh& judged = c.judged_mesh;
  const std::span<const Triangle> boundary = judged.boundary.boundary_triangles();
  std::vector<Triangle> outer;
  for (std::size_t i = 0; i < boundary.size(); ++i)
    if (const Index sheet = judged.boundary.sheets.of_triangle[i]; sheet >= 0 && own[sheet])
      outer.push_back(boundary[i]);
  const TriangleSurface mesh = surface_of(judged.mesh, judged.boundary.triangles);
  // Depth in what is missing is the distance from the mesh, its own outer boundary included.
  std::optional<TriangleTree> whole_boundary;
  if (!outer.empty() || c.at_unjudged > 0)
    whole_boundary.emplace(TriangleSet{judged.mesh.points, boundary}, c.mesh_tree->units());
  const TriangleTree& mesh_tree = whole_boundary ? *whole_boundary : *c.mesh_tree;

  std::vector<Eigen::Vector3d> off;
  for (const OffVertex& o : distances.off_vertices)
    off.push_back(judged.mesh.points[static_cast<std::size_t>(o.vertex)]);
  RegionEvidence evidence;
  evidence.at_off_vertex.assign(off.size(), std::nullopt);
  std::optional<Voxels> made;
  for (const Check check : {Check::missing_region, Check::excess_region}) {
    if (!record.wants(check)) continue;
    try {
      const VoxelLattice lattice = lattice_for(check, c, mesh);
      if (!made || !(made->lattice == lattice))
        made.emplace(voxelise(c, lattice, mesh, outer, surface_voxels));
    } catch (const VoxelRangeError& error) {
      const bool none_ran = check == Check::missing_region || !record.wants(Check::missing_region);
      if (none_ran && !can_lay(Check::excess_region, c, mesh)) throw;  // both are named in one line
      record.could_not_run({check}, error.what());
      record.report.notes.push_back(fmt::format("{} was not looked for: {}", info(check).id, error.what()));
      continue;
    }
    const Voxels& voxels = *made;
    const double voxel_volume = voxels.lattice.h * voxels.lattice.h * voxels.lattice.h;
    const bool missing = check == Check::missing_region;
    VoxelBits wrong = missing ? voxels.wanted.without(voxels.in_mesh) : voxels.in_mesh.without(voxels.wanted);
    // An element that is not judged may fill the voxels in its box, and reach the surface within the allowed
    // distance.
    if (missing && judged.unjudged.any())
      wrong = wrong.without(voxels_in_boxes(judged.unjudged.boxes(), c.allowed, voxels.lattice));
    const DeepVoxels deep =
        deep_voxels(voxels.lattice, wrong, missing ? mesh_tree : *c.surface_tree, c.allowed, voxels.met, off);
    const char* const is = missing ? "not filled by the mesh" : "in the mesh and should not be";
    const char* const from = missing                                    ? "mesh"
                             : judged.options.region == Region::outside ? "outside of the surface"
                                                                        : "solid";
    // The parity of the voxels is exact. So is this: which tetrahedra contain the deepest centre.
    std::vector<Eigen::Vector3d> centres;
    for (const VoxelRegion& region : deep.regions) centres.push_back(region.deepest);
    const std::vector<std::vector<Index>> tets = tets_at(judged.mesh, judged.excluded, centres);
    std::vector<Finding> findings;
    std::vector<std::size_t> place(deep.regions.size(), 0);  // in `findings`, from 1; 0: not confirmed
    double volume = 0, largest = 0;
    for (std::size_t i = 0; i < deep.regions.size(); ++i) {
      const VoxelRegion& region = deep.regions[i];
      if (tets[i].empty() != missing) continue;
      Finding finding = finding_of(region, voxel_volume, is, from);
      finding.tets = tets[i];
      if (missing && region.nearest >= 0)
        finding.faces = {mesh_tree.set().triangles[static_cast<std::size_t>(region.nearest)]};
      findings.push_back(std::move(finding));
      place[i] = findings.size();
      const double size = static_cast<double>(region.voxels) * voxel_volume;
      volume += size;
      largest = std::max(largest, size);
    }
    (missing ? record.report.volume.missing : record.report.volume.excess) = volume;
    record.result(check).measured = largest;
    for (std::size_t v = 0; v < off.size(); ++v)
      if (const std::int32_t region = deep.region_at[v];
          region >= 0 && place[static_cast<std::size_t>(region)] && !evidence.at_off_vertex[v])
        evidence.at_off_vertex[v] = Cause{check, place[static_cast<std::size_t>(region)] - 1};
    if (!findings.empty() && !evidence.largest) evidence.largest = Cause{check, 0};
    record[check] = Suspects::complete(std::move(findings));
  }
  return evidence;
}

}  // namespace tetproof::verify
