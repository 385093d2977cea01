// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of the C interface.
#include <algorithm>
#include <memory>
#include <utility>

#include "io/error.hpp"
#include "verify/c/arrays.hpp"
#include "verify/c/boundary.hpp"
#include "verify/c/handles.hpp"
#include "verify/c/options.hpp"
#include "verify/defects.hpp"
#include "verify/report_page.hpp"

using namespace tetproof;
using namespace tetproof::c;

namespace {

// A mesh with the numbers that name its elements.
struct Named {
  TetMesh mesh;
  Numbering numbering;
};

Named mesh_of(const tetproof_points& points, const tetproof_integers& tets) {
  Named named;
  named.mesh.points = points_of(points, "points");
  UnknownNumbers unknown;
  named.mesh.tets = elements_of<4>(tets, named.mesh.points.size(), unknown, "tets");
  named.numbering.first = tets.base;
  named.numbering.unknown = unknown.numbers();
  return named;
}

// The tags become positions among the sorted tags, unless all are the same.
TetRegions regions_of(const tetproof_integers& array, std::size_t tets, const std::string& kind) {
  TetRegions regions{.of_tet = tags_of(array, "regions"), .tags = {}};
  if (regions.of_tet.size() != tets)
    refuse_argument(
        fmt::format("regions: count is {}, expected {}, that of tets", regions.of_tet.size(), tets));
  std::vector<std::int64_t> tags = regions.of_tet;
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  if (tags.size() < 2) return {};
  for (const std::int64_t tag : tags) regions.tags.push_back({kind, tag, ""});
  for (std::int64_t& region : regions.of_tet)
    region = std::lower_bound(tags.begin(), tags.end(), region) - tags.begin();
  return regions;
}

verify::Report verdict(const TetMesh& mesh, const tetproof_surface* surface, verify::Options& options) {
  if (!surface) return verify::verify(mesh, options);
  verify::add_unread_surface(options.unjudged, surface->dropped);
  try {
    return verify::verify(mesh, surface->judged(), options);
  } catch (const InputError& error) {
    throw InputError((surface->name.empty() ? "the surface" : surface->name) + ": " + error.what());
  }
}

std::string no_tetrahedra(const std::string& mesh, const verify::Unjudged& unjudged) {
  std::string others;
  for (const auto* entries : {&unjudged.elements, &unjudged.unread})
    for (const verify::NotJudged& entry : *entries)
      others += fmt::format("{}{} {}", others.empty() ? ", but " : ", ", entry.count, entry.what);
  return fmt::format("{}: holds no tetrahedra{}", mesh, others);
}

std::unique_ptr<tetproof_report> judged(const TetMesh& mesh, Numbering numbering,
                                        const tetproof_surface* surface, verify::Options& options) {
  verify::Report report = verdict(mesh, surface, options);
  return std::make_unique<tetproof_report>(
      std::move(report), std::move(numbering),
      TetRegions{std::move(options.regions), std::move(options.region_tags)});
}

// Refuses another mesh than that of the report, as far as its counts tell.
void check_mesh(const TetMesh& mesh, const tetproof_report& report) {
  const verify::Shape& judged = report.report.mesh;
  if (judged.points != static_cast<std::int64_t>(mesh.points.size()) ||
      judged.tets != static_cast<std::int64_t>(mesh.tets.size()))
    refuse_argument(fmt::format("the report is of {} tetrahedra and {} points, and the mesh has {} and {}",
                                judged.tets, judged.points, mesh.tets.size(), mesh.points.size()));
}

std::unique_ptr<tetproof_document> defects_of(const TetMesh& mesh, const tetproof_report& report) {
  check_mesh(mesh, report);
  auto made = std::make_unique<tetproof_document>();
  made->document = verify::defects_document(mesh, report.numbering, report.report);
  return made;
}

char* page_of(const TetMesh& mesh, const tetproof_report& report, const tetproof_surface* surface,
              const char* mesh_name) {
  check_mesh(mesh, report);
  const std::optional<verify::Shape>& judged = report.report.surface;
  const std::int64_t triangles = surface ? static_cast<std::int64_t>(surface->surface.triangles.size()) : 0;
  if (judged.has_value() != (surface != nullptr) || (judged && judged->boundary_faces != triangles))
    refuse_argument(fmt::format("the report is of {}, and {} is given",
                                judged ? fmt::format("a surface of {} triangles", judged->boundary_faces)
                                       : "a mesh without a surface",
                                surface ? fmt::format("a surface of {} triangles", triangles) : "none"));
  return text_for_caller(
      verify::report_page(report.report, {.mesh = mesh,
                                          .numbering = report.numbering,
                                          .mesh_name = mesh_name,
                                          .surface = surface ? &surface->surface : nullptr,
                                          .surface_name = !surface                ? ""
                                                          : surface->name.empty() ? "surface"
                                                                                  : surface->name,
                                          .regions = report.regions.of_tet,
                                          .region_tags = report.regions.tags}));
}

}  // namespace

tetproof_status tetproof_judge(const tetproof_points* points, const tetproof_integers* tets,
                               const tetproof_integers* regions, const tetproof_surface* surface,
                               const tetproof_judge_options* options, tetproof_report** report,
                               tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_report*& result = result_of(report, "report");
    JudgeOptions judge = checked(options, surface != nullptr);
    Named named = mesh_of(needed(points, "points"), needed(tets, "tets"));
    if (regions) {
      TetRegions tags = regions_of(*regions, named.mesh.tets.size(), judge.region_kind);
      judge.options.regions = std::move(tags.of_tet);
      judge.options.region_tags = std::move(tags.tags);
    }
    if (named.mesh.tets.empty()) throw InputError(no_tetrahedra("the mesh", {}));
    on_threads(judge.threads, [&] {
      result = judged(named.mesh, std::move(named.numbering), surface, judge.options).release();
    });
  });
}

tetproof_status tetproof_judge_document(const tetproof_document* document, const tetproof_surface* surface,
                                        const tetproof_judge_options* options, tetproof_report** report,
                                        tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_report*& result = result_of(report, "report");
    JudgeOptions judge = checked(options, surface != nullptr);
    if (!judge.region_kind.empty()) refuse_argument("region_kind is given, but a document tells its own");
    const Document& from = needed(document, "document").document;
    on_threads(judge.threads, [&] {
      const TetMesh mesh = tet_mesh(from);
      TetRegions regions = tet_regions(from);
      judge.options.regions = std::move(regions.of_tet);
      judge.options.region_tags = std::move(regions.tags);
      judge.options.unjudged = verify::unjudged(from);
      if (mesh.tets.empty())
        throw InputError(
            no_tetrahedra(from.path.empty() ? "the document" : from.path, judge.options.unjudged));
      result = judged(mesh, numbering(from), surface, judge.options).release();
    });
  });
}

tetproof_status tetproof_report_defects(const tetproof_report* report, const tetproof_points* points,
                                        const tetproof_integers* tets, tetproof_document** defects,
                                        tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(defects, "defects");
    const Named named = mesh_of(needed(points, "points"), needed(tets, "tets"));
    on_threads(0, [&] { result = defects_of(named.mesh, needed(report, "report")).release(); });
  });
}

tetproof_status tetproof_report_document_defects(const tetproof_report* report,
                                                 const tetproof_document* document,
                                                 tetproof_document** defects, tetproof_error* error) {
  return guarded(error, [&] {
    tetproof_document*& result = result_of(defects, "defects");
    const Document& from = needed(document, "document").document;
    on_threads(0, [&] { result = defects_of(tet_mesh(from), needed(report, "report")).release(); });
  });
}

tetproof_status tetproof_report_html(const tetproof_report* report, const tetproof_points* points,
                                     const tetproof_integers* tets, const tetproof_surface* surface,
                                     const char* mesh_name, char** html, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(html, "html");
    const Named named = mesh_of(needed(points, "points"), needed(tets, "tets"));
    on_threads(0, [&] {
      result = page_of(named.mesh, needed(report, "report"), surface, &needed(mesh_name, "mesh_name"));
    });
  });
}

tetproof_status tetproof_report_document_html(const tetproof_report* report,
                                              const tetproof_document* document,
                                              const tetproof_surface* surface, const char* mesh_name,
                                              char** html, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(html, "html");
    const Document& from = needed(document, "document").document;
    on_threads(0, [&] {
      result = page_of(tet_mesh(from), needed(report, "report"), surface, &needed(mesh_name, "mesh_name"));
    });
  });
}

void tetproof_report_free(tetproof_report* report) {
  delete report;
}

const tetproof_records* tetproof_report_records(const tetproof_report* report) {
  return report ? &report->records.all() : nullptr;
}

tetproof_status tetproof_report_json(const tetproof_report* report, char** json, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(json, "json");
    needed(report, "report");
    result = text_for_caller(verify::report_json(report->report, report->numbering));
  });
}

tetproof_status tetproof_report_text(const tetproof_report* report, char** text, tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(text, "text");
    needed(report, "report");
    result = text_for_caller(verify::report_text(report->report, report->numbering));
  });
}

tetproof_status tetproof_report_junit(const tetproof_report* report, const char* mesh, char** xml,
                                      tetproof_error* error) {
  return guarded(error, [&] {
    char*& result = result_of(xml, "xml");
    needed(report, "report");
    result = text_for_caller(verify::report_junit(report->report, &needed(mesh, "mesh"), report->numbering));
  });
}

const tetproof_check_info* tetproof_check_info_at(int32_t position) {
  if (position < 0 || position >= verify::check_count) return nullptr;
  static const auto table = [] {
    std::array<tetproof_check_info, verify::check_count> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const verify::CheckInfo& of = verify::info(static_cast<verify::Check>(i));
      rows[i] = {.id = of.id,
                 .proves = of.proves,
                 .accuracy = of.accuracy,
                 .severity = static_cast<std::int32_t>(of.severity),
                 .needs_surface = of.needs_surface,
                 .for_certificate = of.certificate};
    }
    return rows;
  }();
  return &table[static_cast<std::size_t>(position)];
}
