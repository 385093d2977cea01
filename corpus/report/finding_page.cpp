// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/finding_page.hpp"
#include "corpus/meshing/judgement.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/bytes/base64.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/page/page.hpp"
#include "io/page/picture.hpp"
#include "io/page/surface_layer.hpp"
#include "io/surface_files.hpp"
#include "verify/reports/report_parts.hpp"
#include "verify/verify.hpp"

namespace tetproof::corpus {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened");
  return {std::istreambuf_iterator<char>(file), {}};
}

// As the campaign judged a mesh against the surface. What finding.json does not say, because an earlier
// version wrote it, is taken from the finding's report.
void judge_as_then(verify::Options& options, const nlohmann::json& facts, const nlohmann::json& report,
                   double diagonal) {
  const nlohmann::json judged = facts.value("judged", nlohmann::json::object());
  set_against_surface(options, judged.value("coarse", false));
  const bool measured = report.contains("fidelity") && report["fidelity"].is_object();
  if (judged.contains("allowed"))
    options.fidelity = judged.value("allowed", 0.0) / diagonal;
  else if (measured)
    options.fidelity = report["fidelity"].value("allowed", 0.0) / diagonal;
}

// The mesh as the finding's own report judged it: alone, or against the surface within the distance that was
// allowed then.
io::Page page_of_mesh(const std::string& name, const std::string& folder, const std::string& file,
                      const TriangleSurface& surface, const nlohmann::json& facts) {
  const Document document = read_document(folder + "/" + file);
  const TetMesh mesh = tet_mesh(document);
  const Numbering numbers = numbering(document);
  const TetRegions regions = tet_regions(document);
  const auto then = nlohmann::json::parse(text_of(folder + "/report.json"), nullptr, false);
  if (!then.is_object()) throw InputError(folder + "/report.json: expected a JSON object");
  verify::Options options{
      .regions = regions.of_tet, .region_tags = regions.tags, .unjudged = verify::unjudged(document)};
  if (facts.contains("judged")) options.check = facts["judged"].value("check", std::vector<std::string>{});
  verify::Report report;
  const bool alone = !then.contains("surface") || then["surface"].is_null();
  if (alone) {
    report = verify::verify(mesh, options);
  } else {
    const verify::JudgedSurface judged(surface);
    const double diagonal = (judged.report().box_max - judged.report().box_min).stableNorm();
    judge_as_then(options, facts, then, diagonal);
    report = verify::verify(mesh, judged, options);
  }
  return verify::report_page_parts(report, {.mesh = mesh,
                                            .numbering = numbers,
                                            .mesh_name = name + "/" + file,
                                            .surface = alone ? nullptr : &surface,
                                            .surface_name = "surface.off",
                                            .regions = regions.of_tet,
                                            .region_tags = regions.tags});
}

io::Page page_of_surface(const std::string& name, const TriangleSurface& surface) {
  io::Page page(name, {.text = "no mesh", .kind = "fail"});
  io::Scene scene;
  io::SurfaceLayer drawn = io::surface_layer(scene, surface);
  drawn.layer.boundary = true;
  scene.layers.push_back(std::move(drawn.layer));
  if (!drawn.left_out.empty()) page.paragraph(drawn.left_out);
  page.view(scene, io::picture_svg(scene));
  return page;
}

}  // namespace

std::string picture_address(const std::string& folder) {
  std::ifstream file(folder + "/picture.svg", std::ios::binary);
  if (!file) return "";
  const std::string picture{std::istreambuf_iterator<char>(file), {}};
  return "data:image/svg+xml;base64," + io::base64(picture);
}

std::string finding_page(const std::string& folder) {
  const std::string readme = text_of(folder + "/README.md");
  const auto facts = nlohmann::json::parse(text_of(folder + "/finding.json"), nullptr, false);
  if (!facts.is_object()) throw InputError(folder + "/finding.json: expected a JSON object");
  const TriangleSurface surface = read_surface(folder + "/surface.off");
  const std::string name = std::filesystem::path(folder).filename().string(), mesh = facts.value("mesh", "");
  io::Page page =
      mesh.empty() ? page_of_surface(name, surface) : page_of_mesh(name, folder, mesh, surface, facts);
  page.part("finding", "The finding");
  page.lines(readme);
  if (const std::string picture = picture_address(folder); !picture.empty())
    page.table("picture-of-the-defect", {"picture.svg"},
               {{{.text = "surface and defect", .image = picture}}});
  return page.text();
}

}  // namespace tetproof::corpus
