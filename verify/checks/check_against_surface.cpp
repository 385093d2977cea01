// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/check_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "verify/checks/surface_comparison.hpp"
#include "verify/triangles/winding.hpp"
#include "verify/voxel_volume.hpp"

namespace tetproof::verify {
namespace {

// Sheets of the mesh's boundary that are its own outer boundary and not the surface's: with region outside
// those in no other.
std::vector<int> own_sheets(const Judgement& j) {
  const Boundary& boundary = j.boundary;
  std::vector<int> own(boundary.sheets.sheets.size(), 0);
  if (j.options.region == Region::outside) {
    const std::vector<int> depths =
        nesting_depths(j.mesh.points, boundary.boundary_triangles(), boundary.sheets);
    std::transform(depths.begin(), depths.end(), own.begin(), [](int depth) { return depth == 0; });
  }
  return own;
}

Suspects one_if(bool found, std::string what) {
  return {found ? std::size_t{1} : 0, [](std::size_t) { return Finding{}; },
          [what = std::move(what)](std::size_t, Finding& finding) { finding.what = what; }};
}

// volume-surface, volume-voxel.
void check_volumes(Judgement& j, const MeshVolumes& volumes, const TriangleSurface& surface,
                   const SurfaceJudgement& judged, const std::vector<int>& own) {
  const SurfaceReport& s = judged.report;
  Report& report = j.report;
  // Inside: mesh - surface. Outside: mesh - (outer boundary - surface).
  const bool outside = j.options.region == Region::outside;
  std::vector<int> mesh_weights = volumes.all, surface_weights = judged.weights, outer(volumes.all.size(), 0);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i]) outer[i] = 1, mesh_weights[i] -= 1;
  if (outside)
    for (int& weight : surface_weights) weight = -weight;
  const double difference = volumes.sets.difference(mesh_weights, *judged.volumes, surface_weights);
  const double outer_volume = volumes.sets.weighted_sum(outer);
  const double right_volume = outside ? outer_volume - s.volume : s.volume;
  const double allowed = j.options.fidelity * (s.box_max - s.box_min).norm() * s.area;
  report.volume.relative_difference = difference / right_volume;
  if (j.wants(Check::volume_surface)) {
    CheckResult& result = report.checks[static_cast<std::size_t>(Check::volume_surface)];
    result.measured = std::abs(difference);
    result.allowed = allowed;
    j[Check::volume_surface] =
        one_if(std::abs(difference) > allowed,
               fmt::format("the mesh's volume is {:.17g}, {:.6g} {} than the surface asks for",
                           *report.volume.mesh, std::abs(difference), difference < 0 ? "less" : "more"));
  }
  if (j.options.voxels == 0) j.skip({Check::volume_voxel});
  if (!j.wants(Check::volume_voxel)) return;
  VoxelVolume voxels;
  try {
    voxels = voxel_volume(surface, j.options.voxels);
  } catch (const VoxelRangeError& error) {
    j.skip({Check::volume_voxel});
    report.notes.push_back(fmt::format("no voxel account: {}", error.what()));
    return;
  }
  report.volume.voxel_inside = voxels.inside;
  report.volume.voxel_error_bound = voxels.error_bound;
  if (j.options.voxels / 2 >= least_voxels)
    report.volume.voxel_error_estimate =
        std::abs(voxels.inside - voxel_volume(surface, j.options.voxels / 2).inside);
  const double apart =
      std::abs(*report.volume.mesh - (outside ? outer_volume - voxels.inside : voxels.inside));
  CheckResult& result = report.checks[static_cast<std::size_t>(Check::volume_voxel)];
  result.measured = apart;
  result.allowed = allowed;
  if (apart > allowed && apart <= allowed + voxels.error_bound) result.verdict = Verdict::undecided;
  j[Check::volume_voxel] = one_if(apart > allowed + voxels.error_bound,
                                  fmt::format("the mesh's volume and the voxels' differ by {:.6g}, allowed "
                                              "{:.6g} and the voxels' error of at most {:.6g}",
                                              apart, allowed, voxels.error_bound));
}

// Distances, normals, and regions that are missing or too much.
void compare(Judgement& j, Comparison& comparison, const std::vector<int>& own) {
  if (!comparison.mesh_tree) {
    j.skip({Check::missing_region, Check::excess_region, Check::off_surface_vertex, Check::topology,
            Check::mesh_to_surface, Check::surface_to_mesh, Check::normals});
    j.report.notes.push_back(
        "distances were not measured, components not paired: doubles cannot measure the box of mesh and "
        "surface");
    return;
  }
  check_distances(j, comparison);
  if (j.wants(Check::normals)) check_normals(j, comparison);
  if (j.options.voxels == 0) j.skip({Check::missing_region, Check::excess_region});
  if (!j.wants(Check::missing_region) && !j.wants(Check::excess_region)) return;
  try {
    check_missing_and_excess(j, comparison, own);
  } catch (const VoxelRangeError& error) {
    j.skip({Check::missing_region, Check::excess_region});
    j.report.notes.push_back(fmt::format("missing and excess regions were not looked for: {}", error.what()));
  }
}

// What follows from a region that is missing or too much.
void name_region(Judgement& j, const Comparison& c) {
  if (!c.region) return;
  for (const Check check :
       {Check::topology, Check::volume_surface, Check::volume_voxel, Check::surface_to_mesh})
    j[check].cause = [region = c.region](std::size_t) { return region; };
  if (!j[Check::mesh_to_surface].cause || !j[Check::mesh_to_surface].cause(0))
    if (c.region->check == Check::excess_region || j[Check::excess_region].count > 0)
      j[Check::mesh_to_surface].cause = [](std::size_t) { return Cause{Check::excess_region, 0}; };
  j[Check::off_surface_vertex].cause = [at = c.region_at_off_vertex](std::size_t i) { return at[i]; };
}

}  // namespace

std::size_t right_cavities(Region region, const SurfaceReport& surface) {
  if (region == Region::none) return 0;
  const auto inner = static_cast<std::size_t>(surface.cavities());
  return region == Region::outside ? surface.components.size() - inner : inner;
}

void check_against_surface(Judgement& j, const MeshVolumes& volumes, const TriangleSurface& surface,
                           const SurfaceJudgement& judged) {
  const SurfaceReport& s = judged.report;
  Report& report = j.report;
  report.surface = Shape{.points = s.vertices,
                         .tets = 0,
                         .boundary_faces = s.triangles,
                         .components = static_cast<std::int64_t>(s.components.size()),
                         .cavities = s.cavities(),
                         .genus = s.genus};
  for (const SurfaceComponent& c : s.components) report.surface->genus_per_component.push_back(c.genus);
  report.surface->volume = report.volume.surface = s.volume;
  if (j.options.region == Region::none) return;

  // What cannot be compared was found defective before.
  const bool whole = j.boundary.closed && report.mesh.components;
  std::vector<int> own(volumes.all.size() - 1, 0);
  if (whole) own = own_sheets(j);
  if (!whole) {
    j.skip({Check::topology});
    report.notes.push_back(
        "the topology was not compared with the surface's: the boundary is not closed, or faces do not "
        "match");
  }
  if (!whole && j.options.region == Region::outside) {
    j.skip({Check::missing_region, Check::excess_region, Check::off_surface_vertex, Check::volume_surface,
            Check::volume_voxel, Check::mesh_to_surface, Check::surface_to_mesh, Check::normals});
    return;
  }

  if (j.options.coarse) j.skip({Check::normals});
  Comparison comparison(j, surface, judged, own);
  if (j.wants(Check::topology) && comparison.mesh_tree) check_topology(j, volumes, comparison);
  compare(j, comparison, own);
  check_volumes(j, volumes, surface, judged, own);
  name_region(j, comparison);
}

}  // namespace tetproof::verify
