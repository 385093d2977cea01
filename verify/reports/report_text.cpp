// SPDX-License-Identifier: GPL-3.0-or-later
// The report for people: the verdict, what is wrong and where, then counts and measures.
#include <fmt/core.h>

#include "io/bytes/words.hpp"
#include "verify/findings_text.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {
namespace {

constexpr std::size_t most_regions = 12;

std::string shape_text(const Shape& shape) {
  if (!shape.components) return "components, cavities and genus undefined: the boundary is not closed";
  const std::string cavities = *shape.cavities == 0 ? ""
                               : *shape.cavities == 1
                                   ? " (one of them a cavity)"
                                   : fmt::format(" ({} of them cavities)", *shape.cavities);
  return fmt::format("{}{}, genus {}", io::counted(*shape.components, "components"), cavities, *shape.genus);
}

}  // namespace

std::string report_text(const Report& report, const Numbering& numbering) {
  std::string text = verdict_text(report) + "\n" + scope_text(report);
  for (const Verdict verdict : {Verdict::fail, Verdict::warning})
    for (const CheckResult& result : report.checks)
      if (result.verdict == verdict) text += check_text(result, numbering);
  for (const CheckResult& result : report.checks)
    if (result.verdict == Verdict::undecided)
      text += fmt::format(
          "undecided {}: measured {:.6g}, allowed {:.6g}, the difference is inside the stated error\n",
          info(result.check).id, result.measured.value_or(0), result.allowed.value_or(0));
  text += if_mended_text(report, numbering);

  text += fmt::format("mesh      {}, {}, {}; boundary of {}\n", io::counted(report.mesh.tets, "tetrahedra"),
                      io::counted(report.mesh.points, "points"),
                      io::counted(report.mesh.boundary_faces, "boundary faces"), shape_text(report.mesh));
  for (std::size_t i = 0; i < report.regions.size() && i < most_regions; ++i) {
    const auto& [tag, shape] = report.regions[i];
    text += fmt::format("region    {}: {}, volume {:.12g}; boundary of {}, {}\n", region_text(tag),
                        io::counted(shape.tets, "tetrahedra"), shape.volume.value_or(0),
                        io::counted(shape.boundary_faces, "faces"), shape_text(shape));
  }
  if (report.regions.size() > most_regions)
    text +=
        fmt::format("          ... {}\n", io::counted(report.regions.size() - most_regions, "more regions"));
  if (report.surface)
    text += fmt::format("surface   {}, {}; {}\n", io::counted(report.surface->boundary_faces, "triangles"),
                        io::counted(report.surface->points, "vertices"), shape_text(*report.surface));
  const VolumeAccount& volume = report.volume;
  if (volume.mesh) {
    text += fmt::format("volume    mesh {:.12g}", *volume.mesh);
    if (volume.surface) text += fmt::format(", surface {:.12g}", *volume.surface);
    if (volume.relative_difference)
      text += fmt::format(", relative difference {:.3g}", *volume.relative_difference);
    if (const CheckResult& check = report[Check::volume_surface]; check.allowed)
      text += fmt::format("; difference {:.3g}, allowed {:.3g}", check.measured.value_or(0), *check.allowed);
    text += "\n";
  }
  if (volume.voxel_inside)
    text += fmt::format(
        "voxels    surface {:.12g}, off by at most {:.3g}{}\n", *volume.voxel_inside,
        volume.voxel_error_bound.value_or(0),
        volume.voxel_error_estimate ? fmt::format(", estimated {:.2g}", *volume.voxel_error_estimate) : "");
  if (report.fidelity) {
    const Fidelity& f = *report.fidelity;
    const auto length = [](const std::optional<double>& d) {
      return d ? fmt::format("{:.6g}", *d) : "not measured";
    };
    text += fmt::format(
        "fidelity  mesh to surface {}, surface to mesh {}, each at most {:.2g} more; allowed {:.6g}\n",
        length(f.mesh_to_surface), length(f.surface_to_mesh), f.error_bound, f.allowed);
  }
  if (report.quality && report.quality->tets > 0) {
    const Quality& q = *report.quality;
    text += fmt::format(
        "quality   dihedral angles {:.4g} to {:.4g} degrees, smallest solid angle {:.3g} of 4 pi, largest "
        "aspect ratio {:.4g}\n",
        q.dihedral_angles.min, q.dihedral_angles.max, q.solid_angles.min, q.aspect_ratios.max);
  }
  for (const std::string& note : report.notes) text += "note      " + note + "\n";
  for (const auto& [phase, time] : report.seconds) text += fmt::format("{:8.3f} s  {}\n", time, phase);
  return text;
}

}  // namespace tetproof::verify
