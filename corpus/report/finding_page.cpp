// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/report/finding_page.hpp"

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

// The mesh against its surface, as the judge shows it.
io::Page page_of_mesh(const std::string& name, const std::string& path, const TriangleSurface& surface) {
  const Document document = read_document(path);
  const TetMesh mesh = tet_mesh(document);
  const Numbering numbers = numbering(document);
  TetRegions regions = tet_regions(document);
  verify::Options options{.region = verify::Region::inside,
                          .regions = regions.of_tet,
                          .region_tags = regions.tags,
                          .unjudged = verify::unjudged(document)};
  const verify::JudgedSurface judged(surface);
  const verify::Report report =
      judged.report().fault.empty() ? verify::verify(mesh, judged, options) : verify::verify(mesh, options);
  return verify::report_page_parts(report, {.mesh = mesh,
                                            .numbering = numbers,
                                            .mesh_name = name,
                                            .surface = &surface,
                                            .surface_name = "surface.off",
                                            .regions = regions.of_tet,
                                            .region_tags = regions.tags});
}

io::Page page_of_surface(const std::string& name, const TriangleSurface& surface) {
  io::Page page(name, {.text = "no mesh", .kind = "fail"});
  io::Scene scene;
  scene.points = surface.vertices;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    scene.point_numbers.push_back(static_cast<std::int64_t>(v));
  scene.layers.push_back(
      {.id = "surface", .name = "the surface", .triangles = surface.triangles, .boundary = true});
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
  io::Page page = mesh.empty() ? page_of_surface(name, surface)
                               : page_of_mesh(name + "/" + mesh, folder + "/" + mesh, surface);
  page.part("finding", "The finding");
  page.lines(readme);
  if (const std::string picture = picture_address(folder); !picture.empty())
    page.table("picture-of-the-defect", {"picture.svg"},
               {{{.text = "surface and defect", .image = picture}}});
  return page.text();
}

}  // namespace tetproof::corpus
