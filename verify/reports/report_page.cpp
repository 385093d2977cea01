// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report_page.hpp"

#include <fmt/format.h>

#include "io/bytes/words.hpp"
#include "io/page/page.hpp"
#include "io/page/picture.hpp"
#include "io/page/plots.hpp"
#include "verify/findings_text.hpp"
#include "verify/reports/report_parts.hpp"
#include "verify/reports/report_scene.hpp"
#include "verify/reports/verdict.hpp"

namespace tetproof::verify {
namespace {

using io::PageCell;
using io::PageRow;

constexpr std::size_t most_regions = 1000;

std::string kind_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::warning:
    case Verdict::undecided:
      return "warning";
    case Verdict::fail:
      return "fail";
    case Verdict::skipped:
      return "skipped";
  }
  return "";
}

PageCell number(const std::optional<double>& value) {
  return {.text = value ? fmt::format("{}", *value) : "", .number = true};
}

PageCell count(std::int64_t value) {
  return {.text = fmt::format("{}", value), .number = true};
}

PageCell count(const std::optional<std::int64_t>& value) {
  return value ? count(*value) : PageCell{.text = "undefined", .number = true};
}

void add_findings(io::Page& page, const Report& report, const PageSubject& subject,
                  const ReportScene& scene) {
  std::vector<PageRow> rows;
  std::int64_t all = 0;
  std::size_t place = 0;
  for (const CheckResult& result : report.checks) {
    all += result.count;
    for (const Finding& finding : result.findings) {
      std::string text = finding_text(finding, subject.numbering);
      if (text.ends_with('\n')) text.pop_back();
      rows.push_back({{.text = fmt::format("{}", rows.size() + 1), .number = true},
                      {.text = info(result.check).id, .kind = kind_of(result.verdict)},
                      {.text = text, .target = scene.targets[place++]}});
    }
  }
  page.part("what-is-wrong", "Findings");
  if (rows.empty()) {
    page.paragraph("No check found anything.");
    return;
  }
  page.paragraph(fmt::format(
      "{}, causes before their consequences{}. A click flies to the place; numbers are those of the file.",
      io::counted(all, "findings"),
      all > static_cast<std::int64_t>(rows.size()) ? fmt::format(", of which {} are listed", rows.size())
                                                   : ""));
  page.table("findings", {"", "check", "what and where"}, rows);
}

std::string what_it_proves(const CheckResult& result) {
  const CheckInfo& check = info(result.check);
  if (!result.why.empty()) return "skipped: " + result.why;
  return fmt::format("{} ({})", check.proves, check.all_exact ? "exact" : check.accuracy);
}

void add_checks(io::Page& page, const Report& report) {
  std::vector<PageRow> rows;
  for (const CheckResult& result : report.checks)
    rows.push_back({{.text = info(result.check).id},
                    {.text = verdict_name(result.verdict), .kind = kind_of(result.verdict)},
                    count(result.count),
                    count(result.consequences),
                    number(result.measured),
                    number(result.allowed),
                    {.text = what_it_proves(result)}});
  page.part("all-checks", "Checks");
  page.table(
      "checks",
      {"check", "verdict", "findings", "consequences", "measured", "allowed", "what it proves, how exactly"},
      rows);
}

PageRow shape_row(const std::string& name, const Shape& shape, bool is_mesh) {
  return {{.text = name},
          count(shape.points),
          {.text = is_mesh ? fmt::format("{}", shape.tets) : "", .number = true},
          count(shape.boundary_faces),
          count(shape.components),
          count(shape.cavities),
          count(shape.genus),
          number(shape.volume)};
}

void add_shapes(io::Page& page, const Report& report) {
  std::vector<PageRow> rows{shape_row("mesh", report.mesh, true)};
  if (report.surface) rows.push_back(shape_row("surface", *report.surface, false));
  for (std::size_t i = 0; i < report.regions.size() && i < most_regions; ++i)
    rows.push_back(shape_row("region " + region_text(report.regions[i].tag), report.regions[i].shape, true));
  page.part("shape", "Counts, shape and volume");
  page.table("shapes",
             {"", "points", "tetrahedra", "boundary faces", "components", "cavities", "genus", "volume"},
             rows);
  if (report.regions.size() > most_regions)
    page.paragraph(fmt::format(
        "{} are not listed here; the JSON report has them.",
        io::counted(static_cast<std::int64_t>(report.regions.size() - most_regions), "more regions")));
}

void add_surface(io::Page& page, const Report& report, const ReportScene& scene) {
  if (!report.surface) return;
  page.part("against-surface", "Against the surface");
  const VolumeAccount& v = report.volume;
  std::vector<PageRow> rows{{{.text = "volume of the mesh"}, number(v.mesh)},
                            {{.text = "volume of the surface"}, number(v.surface)},
                            {{.text = "relative difference"}, number(v.relative_difference)},
                            {{.text = "volume of the surface by voxels"}, number(v.voxel_inside)},
                            {{.text = "off by at most"}, number(v.voxel_error_bound)},
                            {{.text = "off by about (estimate)"}, number(v.voxel_error_estimate)},
                            {{.text = "volume of missing regions"}, number(v.missing)},
                            {{.text = "volume of regions in excess"}, number(v.excess)}};
  std::erase_if(rows, [](const PageRow& row) { return row[1].text.empty(); });
  if (report.fidelity) {
    const Fidelity& f = *report.fidelity;
    rows.push_back({{.text = "largest distance from mesh to surface, at least", .target = scene.to_surface},
                    number(f.mesh_to_surface)});
    rows.push_back({{.text = "largest distance from surface to mesh, at least", .target = scene.to_mesh},
                    number(f.surface_to_mesh)});
    rows.push_back({{.text = "each at most so much more"}, number(f.error_bound)});
    rows.push_back({{.text = "allowed distance"}, number(f.allowed)});
  }
  page.table("surface-measures", {"measure", "value"}, rows);
}

void add_quality(io::Page& page, const Report& report) {
  if (!report.quality) return;
  const Quality& q = *report.quality;
  page.part("quality", "Quality");
  if (q.tets == 0) {
    page.paragraph("No tetrahedron has a positive volume: nothing was measured.");
    return;
  }
  const auto plot = [&](const char* id, const char* title, const Distribution& d) {
    page.svg(io::histogram_svg({.id = id,
                                .title = title,
                                .edges = d.edges,
                                .counts = d.counts,
                                .below = fmt::format("least {:.6g}, largest {:.6g}", d.min, d.max)}));
  };
  plot("dihedral-angles", "dihedral angles [degrees], six a tetrahedron", q.dihedral_angles);
  plot("solid-angles", "solid angles / full angle 4\u03c0, four a tetrahedron", q.solid_angles);
  plot("aspect-ratios", "aspect ratios (the regular tetrahedron: 1)", q.aspect_ratios);
  if (q.tets < report.mesh.tets)
    page.paragraph(fmt::format("{} of {} tetrahedra have a positive volume and were measured.", q.tets,
                               report.mesh.tets));
}

}  // namespace

io::Page report_page_parts(const Report& report, const PageSubject& subject) {
  const ReportScene scene = report_scene(report, subject);
  const std::string kind = sound(report) ? "pass" : defective(report) ? "fail" : "warning";
  io::Page page(subject.surface ? subject.mesh_name + " against " + subject.surface_name : subject.mesh_name,
                {.text = verdict_word(report), .kind = kind});
  page.paragraph(verdict_text(report));
  if (const std::string scope = scope_text(report); !scope.empty()) page.lines(scope);
  if (const std::string mended = if_mended_text(report, subject.numbering); !mended.empty())
    page.lines(mended);
  for (const std::string& note : report.notes) page.paragraph("Note: " + note);
  page.view(scene.scene, io::picture_svg(scene.scene));
  for (const std::string& sentence : scene.left_out) page.paragraph(sentence);
  add_findings(page, report, subject, scene);
  add_checks(page, report);
  add_shapes(page, report);
  add_surface(page, report, scene);
  add_quality(page, report);
  return page;
}

std::string report_page(const Report& report, const PageSubject& subject) {
  return report_page_parts(report, subject).text();
}

}  // namespace tetproof::verify
