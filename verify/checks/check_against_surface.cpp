// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/check_against_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "verify/checks/surface_comparison.hpp"
#include "verify/triangles/winding.hpp"

namespace tetproof::verify {
namespace {

// Marks the sheets of the boundary that are the mesh's own outer boundary, and not the surface's. With region
// outside these are the sheets that lie in no other one.
std::vector<int> own_sheets(const JudgedMesh& mesh) {
  std::vector<int> own(mesh.boundary.sheets.sheets.size(), 0);
  if (mesh.options.region == Region::outside) {
    const std::vector<int> depths =
        nesting_depths(mesh.mesh.points, mesh.boundary.boundary_triangles(), mesh.boundary.sheets);
    std::transform(depths.begin(), depths.end(), own.begin(), [](int depth) { return depth == 0; });
  }
  return own;
}

Shape shape_of(const SurfaceReport& surface) {
  Shape shape{.points = surface.vertices,
              .tets = 0,
              .boundary_faces = surface.triangles,
              .components = static_cast<std::int64_t>(surface.components.size()),
              .cavities = surface.cavities(),
              .genus = surface.genus,
              .volume = surface.volume};
  for (const SurfaceComponent& c : surface.components) shape.genus_per_component.push_back(c.genus);
  return shape;
}

// The voxels of the surface, or the reason why there are none. Both empty: nobody asks for them.
struct VoxelEvidence {
  std::shared_ptr<const SurfaceVoxels> voxels;
  std::string fault;
};
VoxelEvidence examine_voxels(const JudgedSurface& surface, const Options& options, const Record& record) {
  if (!record.wants(Check::missing_region) && !record.wants(Check::excess_region) &&
      !record.wants(Check::volume_voxel))
    return {};
  try {
    return {surface.judgement().voxels->of(surface.surface(), options.voxels), {}};
  } catch (const VoxelRangeError& error) {
    return {{}, error.what()};
  }
}

// The volume of a layer as thick as the allowed distance would let a thin solid be lost as a whole. So no
// more than this share of the solid's volume may differ.
constexpr double largest_volume_share = 0.25;

// Says that the allowed distance lets whole walls of the solid be lost. 2 V / A is the mean thickness of a
// thin solid: the width of a plate with the same volume and area.
void note_thin_solid(const SurfaceJudgement& surface, double allowed, Report& report) {
  const double thickness =
      std::ldexp(2 * surface.volumes->weighted_sum_in_units(surface.weights, surface.exponent) / surface.area,
                 surface.exponent);
  if (!(allowed > thickness)) return;
  report.notes.push_back(
      fmt::format("the allowed distance {:.6g} is wider than the solid is thick (2 V / A = {:.6g}): a "
                  "distance within it does not show that the solid is there",
                  allowed, thickness));
}

// The volume that the mesh has, beside the one that it should have. Volumes are in cubes of the surface's
// unit, a power of two: they fit into doubles whatever the scale.
struct VolumeEvidence {
  int exponent = 0;       // the unit is 2^exponent
  double difference = 0;  // what the mesh has more than it should, the nearest double to the exact value
  double outer = 0;       // volume inside the mesh's own outer boundary
  double right = 0;       // volume that the mesh should have
  double allowed = 0;

  double in_cubes(double units) const { return std::ldexp(units, 3 * exponent); }  // [length^3]
};
VolumeEvidence compare_volumes(const JudgedMesh& mesh, const SurfaceJudgement& judged,
                               const std::vector<int>& own) {
  // Inside: mesh - surface. Outside: mesh - (outer boundary - surface).
  const bool outside = mesh.options.region == Region::outside;
  const MeshVolumes& volumes = mesh.volumes;
  std::vector<int> mesh_weights = volumes.all, surface_weights = judged.weights, outer(volumes.all.size(), 0);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i]) outer[i] = 1, mesh_weights[i] -= 1;
  if (outside)
    for (int& weight : surface_weights) weight = -weight;
  const int exponent = judged.exponent;
  const SurfaceReport& s = judged.report;
  const double diagonal = std::ldexp((s.box_max - s.box_min).stableNorm(), -exponent);
  const double solid = judged.volumes->weighted_sum_in_units(judged.weights, exponent);
  VolumeEvidence evidence{
      .exponent = exponent,
      .difference = volumes.sets.difference(mesh_weights, *judged.volumes, surface_weights, exponent),
      .outer = volumes.sets.weighted_sum_in_units(outer, exponent),
      .allowed = mesh.options.fidelity * diagonal * judged.area};
  if (!mesh.options.coarse) evidence.allowed = std::min(evidence.allowed, largest_volume_share * solid);
  evidence.right = outside ? evidence.outer - solid : solid;
  return evidence;
}

void check_volume_surface(const VolumeEvidence& volumes, Record& record) {
  record.report.volume.relative_difference = volumes.difference / volumes.right;
  if (!record.wants(Check::volume_surface)) return;
  CheckResult& result = record.result(Check::volume_surface);
  result.measured = volumes.in_cubes(std::abs(volumes.difference));
  result.allowed = volumes.in_cubes(volumes.allowed);
  if (!(std::abs(volumes.difference) > volumes.allowed)) return;
  record[Check::volume_surface] = Suspects::complete(
      {{.what = fmt::format("the mesh's volume is {:.17g}, {:.6g} {} than the surface asks for",
                            *record.report.volume.mesh, *result.measured,
                            volumes.difference < 0 ? "less" : "more")}});
}

void check_volume_voxel(const VolumeEvidence& volumes, Region region, const VoxelEvidence& evidence,
                        Record& record) {
  if (!record.wants(Check::volume_voxel)) return;
  Report& report = record.report;
  if (!evidence.voxels) {
    record.could_not_run({Check::volume_voxel}, evidence.fault);
    report.notes.push_back(fmt::format("no voxel account: {}", evidence.fault));
    return;
  }
  const VoxelVolume& voxels = evidence.voxels->volume;
  report.volume.voxel_inside = voxels.inside;
  report.volume.voxel_error_bound = voxels.error_bound;
  report.volume.voxel_error_estimate = evidence.voxels->error_estimate;
  const double outer = volumes.in_cubes(volumes.outer), allowed = volumes.in_cubes(volumes.allowed);
  const double apart =
      std::abs(*report.volume.mesh - (region == Region::outside ? outer - voxels.inside : voxels.inside));
  CheckResult& result = record.result(Check::volume_voxel);
  result.measured = apart;
  // An account that agrees within its own error contradicts nothing.
  result.allowed = allowed + voxels.error_bound;
  if (!(apart > *result.allowed)) return;
  record[Check::volume_voxel] = Suspects::complete(
      {{.what = fmt::format("the mesh's volume and the voxels' differ by {:.6g}, allowed {:.6g} and the "
                            "voxels' error of at most {:.6g}",
                            apart, allowed, voxels.error_bound)}});
}

RegionEvidence check_regions(const Comparison& comparison, const DistanceEvidence& distances,
                             const std::vector<int>& own, const SurfaceVoxels* voxels, Record& record) {
  if (!record.wants(Check::missing_region) && !record.wants(Check::excess_region)) return {};
  try {
    return check_missing_and_excess(comparison, distances, own, voxels, record);
  } catch (const VoxelRangeError& error) {
    record.could_not_run({Check::missing_region, Check::excess_region}, error.what());
    record.report.notes.push_back(
        fmt::format("missing and excess regions were not looked for: {}", error.what()));
    return {};
  }
}

// Names the region that is missing or in excess as the cause of what it makes differ.
void name_region(const RegionEvidence& regions, Record& record) {
  if (!regions.largest) return;
  const Cause largest = *regions.largest, excess{Check::excess_region, 0};
  for (const Check check :
       {Check::topology, Check::volume_surface, Check::volume_voxel, Check::surface_to_mesh})
    record[check].cause = [largest](std::size_t) { return largest; };
  auto& cause = record[Check::mesh_to_surface].cause;
  if ((!cause || !cause(0)) && record[Check::excess_region].count > 0)
    cause = [excess](std::size_t) { return excess; };
  record[Check::off_surface_vertex].cause = [at = regions.at_off_vertex](std::size_t i) { return at[i]; };
}

// Checks of which the mesh's unjudged parts leave nothing. A region that the tetrahedra have in excess is in
// excess whatever the other elements fill.
void leave_unjudged(const JudgedMesh& mesh, Record& record) {
  if (mesh.unjudged.any())
    record.could_not_run({Check::bounding_box, Check::topology, Check::volume_surface, Check::volume_voxel,
                          Check::surface_to_mesh},
                         "elements that are not judged may fill a part of the region");
  if (mesh.unjudged.any() && !mesh.unjudged.known())
    record.could_not_run({Check::missing_region}, "elements that are not judged may be anywhere");
  if (record.report.by_corners)
    record.could_not_run(
        {Check::bounding_box, Check::missing_region, Check::excess_region, Check::volume_surface,
         Check::volume_voxel, Check::mesh_to_surface, Check::surface_to_mesh, Check::normals},
        "the tetrahedra are curved between their corners");
}

// Boundary faces of tetrahedra that may be inside the mesh, because elements that are not judged are there.
void leave_faces_at_unjudged(const Comparison& comparison, Record& record) {
  if (comparison.at_unjudged == 0) return;
  constexpr const char* why = "they are at elements that are not judged, and may be inside the mesh";
  if (comparison.faces.empty())
    record.could_not_run({Check::off_surface_vertex, Check::mesh_to_surface, Check::normals},
                         fmt::format("all boundary faces of the tetrahedra: {}", why));
  else if (record.wants(Check::off_surface_vertex) || record.wants(Check::mesh_to_surface) ||
           record.wants(Check::normals))
    record.report.not_judged.push_back({"boundary faces", comparison.at_unjudged, why});
}

}  // namespace

std::size_t right_cavities(Region region, const SurfaceReport& surface) {
  if (region == Region::none) return 0;
  const auto inner = static_cast<std::size_t>(surface.cavities());
  return region == Region::outside ? surface.components.size() - inner : inner;
}

void check_against_surface(const JudgedMesh& mesh, const JudgedSurface& surface, Record& record) {
  Report& report = record.report;
  const Options& options = mesh.options;
  report.surface = shape_of(surface.report());
  report.volume.surface = report.surface->volume;
  if (options.region == Region::none) return;

  // A boundary that cannot be compared was found defective before.
  const bool whole = mesh.boundary.closed && report.mesh.components;
  constexpr const char* not_whole = "the boundary is not closed, or faces do not match";
  const std::vector<int> own = whole ? own_sheets(mesh) : std::vector<int>(mesh.volumes.all.size() - 1, 0);
  if (!whole) {
    record.could_not_run({Check::topology}, not_whole);
    report.notes.push_back(fmt::format("the topology was not compared with the surface's: {}", not_whole));
  }
  if (!whole && options.region == Region::outside) {
    record.could_not_run({Check::bounding_box, Check::missing_region, Check::excess_region,
                          Check::off_surface_vertex, Check::volume_surface, Check::volume_voxel,
                          Check::mesh_to_surface, Check::surface_to_mesh, Check::normals},
                         not_whole);
    return;
  }

  leave_unjudged(mesh, record);
  if (options.coarse)
    record.does_not_apply({Check::normals, Check::bounding_box}, "a grid from a coarse lattice");
  if (options.voxels == 0)
    record.leave_out({Check::missing_region, Check::excess_region, Check::volume_voxel},
                     "no voxels are asked for");
  const auto begin = [&](const char* stage) {
    if (options.progress) options.progress(stage, 0, 0);
  };
  begin("voxels");
  const VoxelEvidence voxels = examine_voxels(surface, options, record);
  begin("distances");
  const Comparison comparison(mesh, surface, own);
  check_bounding_box(comparison, record);
  leave_faces_at_unjudged(comparison, record);
  RegionEvidence regions;
  if (comparison.mesh_tree) {
    if (record.wants(Check::topology)) check_topology(comparison, record);
    const DistanceEvidence distances = measure_distances(comparison, record);
    check_distances(comparison, distances, record);
    check_normals(comparison, distances, record);
    begin("missing and excess regions");
    regions = check_regions(comparison, distances, own, voxels.voxels.get(), record);
  } else {
    constexpr const char* why = "doubles cannot measure the box of mesh and surface";
    record.could_not_run({Check::missing_region, Check::excess_region, Check::off_surface_vertex,
                          Check::topology, Check::mesh_to_surface, Check::surface_to_mesh, Check::normals},
                         why);
    report.notes.push_back(fmt::format("distances were not measured, components not paired: {}", why));
  }
  note_thin_solid(surface.judgement(), comparison.allowed, report);
  if (mesh.unjudged.any() || report.by_corners) return name_region(regions, record);
  const VolumeEvidence volumes = compare_volumes(mesh, surface.judgement(), own);
  check_volume_surface(volumes, record);
  check_volume_voxel(volumes, options.region, voxels, record);
  name_region(regions, record);
  name_bounding_box(record);
}

}  // namespace tetproof::verify
