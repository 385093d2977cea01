// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are a contract: see report.schema.json.
#include "verify/reports/report_json.hpp"

#include <algorithm>

#include "verify/reports/verdict.hpp"

namespace tetproof::verify {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

// Which of those with its number each element is; empty if none shares its number.
template <class Nth>
Json nth_of(const std::vector<Index>& elements, const Nth& nth) {
  Json all = Json::array();
  if (std::any_of(elements.begin(), elements.end(), [&](Index i) { return nth(i) > 0; }))
    for (const Index i : elements) all.push_back(std::max(nth(i), 1));
  return all;
}

Json point(const std::optional<Eigen::Vector3d>& p) {
  return p ? Json{p->x(), p->y(), p->z()} : Json();
}

Json json(const Finding& finding, const Numbering& numbering) {
  Json tets = Json::array(), vertices = Json::array(), faces = Json::array(), consequences = Json::array();
  for (const Index t : finding.tets) tets.push_back(numbering.tet(t));
  for (const Index v : finding.vertices) vertices.push_back(numbering.point(v));
  for (const auto& [a, b, c] : finding.faces)
    faces.push_back({numbering.point(a), numbering.point(b), numbering.point(c)});
  for (const Consequence& c : finding.consequences)
    consequences.push_back({{"check", info(c.check).id}, {"count", c.count}});
  Json exact;
  if (!finding.point_exact[0].empty()) exact = finding.point_exact;
  Json all = {{"tets", tets},
              {"vertices", vertices},
              {"faces", faces},
              {"point", point(finding.point)},
              {"point_exact", exact},
              {"what", finding.what},
              {"consequences", consequences}};
  for (const auto& [first, last] : finding.tet_runs)
    all["tet_runs"].push_back({numbering.tet(first), numbering.tet(last)});
  if (const Json nth = nth_of(finding.tets, [&](Index t) { return numbering.nth_tet(t); }); !nth.empty())
    all["tets_nth"] = nth;
  if (const Json nth = nth_of(finding.vertices, [&](Index v) { return numbering.nth_point(v); });
      !nth.empty())
    all["vertices_nth"] = nth;
  return all;
}

Json json(const CheckResult& result, const Numbering& numbering) {
  Json findings = Json::array();
  for (const Finding& finding : result.findings) findings.push_back(json(finding, numbering));
  Json all = {{"id", info(result.check).id},           {"verdict", verdict_name(result.verdict)},
              {"exact", info(result.check).all_exact}, {"count", result.count},
              {"consequences", result.consequences},   {"measured", or_null(result.measured)},
              {"allowed", or_null(result.allowed)},    {"findings", findings}};
  if (!result.why.empty()) all["why"] = result.why;
  return all;
}

Json json(const std::vector<NotJudged>& entries) {
  Json list = Json::array();
  for (const NotJudged& entry : entries)
    list.push_back({{"what", entry.what}, {"count", entry.count}, {"why", entry.why}});
  return list;
}

Json json(const std::vector<CheckResult>& results, const Numbering& numbering) {
  Json checks = Json::array();
  for (const CheckResult& result : results) checks.push_back(json(result, numbering));
  return checks;
}

Json json(const Shape& shape, bool is_mesh) {
  Json json = {{"points", shape.points}};
  if (is_mesh) json["tets"] = shape.tets;
  json[is_mesh ? "boundary_faces" : "triangles"] = shape.boundary_faces;
  json["components"] = or_null(shape.components);
  json["cavities"] = or_null(shape.cavities);
  json["genus"] = or_null(shape.genus);
  json["genus_per_component"] = shape.genus_per_component;
  json["volume"] = or_null(shape.volume);
  return json;
}

Json json(const Distribution& distribution, std::int64_t tets) {
  return {{"min", tets ? Json(distribution.min) : Json()},
          {"max", tets ? Json(distribution.max) : Json()},
          {"histogram", {{"edges", distribution.edges}, {"counts", distribution.counts}}}};
}

}  // namespace

Json report_json_object(const Report& report, const Numbering& numbering) {
  Json regions = Json::array();
  for (const RegionAccount& region : report.regions) {
    regions.push_back({{"tag", region.tag.tag}, {"kind", region.tag.kind}, {"name", region.tag.name}});
    regions.back().update(json(region.shape, true));
  }
  Json all = {{"verdict", verdict_word(report)},
              {"certificate", or_null(report.certificate)},
              {"not_judged", json(report.not_judged)},
              {"left_out", json(report.left_out)},
              {"by_corners", report.by_corners},
              {"checks", json(report.checks, numbering)},
              {"mesh", json(report.mesh, true)},
              {"regions", regions},
              {"surface", report.surface ? json(*report.surface, false) : Json()},
              {"volume",
               {{"mesh", or_null(report.volume.mesh)},
                {"surface", or_null(report.volume.surface)},
                {"relative_difference", or_null(report.volume.relative_difference)},
                {"voxel_inside", or_null(report.volume.voxel_inside)},
                {"voxel_error_bound", or_null(report.volume.voxel_error_bound)},
                {"voxel_error_estimate", or_null(report.volume.voxel_error_estimate)}}}};
  if (report.volume.missing) all["volume"]["missing"] = *report.volume.missing;
  if (report.volume.excess) all["volume"]["excess"] = *report.volume.excess;
  if (report.fidelity)
    all["fidelity"] = {{"mesh_to_surface", or_null(report.fidelity->mesh_to_surface)},
                       {"surface_to_mesh", or_null(report.fidelity->surface_to_mesh)},
                       {"error_bound", report.fidelity->error_bound},
                       {"allowed", report.fidelity->allowed},
                       {"mesh_to_surface_at", point(report.fidelity->mesh_to_surface_at)},
                       {"surface_to_mesh_at", point(report.fidelity->surface_to_mesh_at)}};
  if (report.quality) {
    const Quality& q = *report.quality;
    all["quality"] = {{"tets", q.tets},
                      {"dihedral_angles", json(q.dihedral_angles, q.tets)},
                      {"solid_angles", json(q.solid_angles, q.tets)},
                      {"aspect_ratios", json(q.aspect_ratios, q.tets)}};
  }
  for (const Consequence& meant : report.allowed)
    all["allowed"].push_back({{"check", info(meant.check).id}, {"count", meant.count}});
  if (report.if_mended)
    all["if_mended"] = {{"how", report.if_mended->how},
                        {"certificate", or_null(report.if_mended->certificate)},
                        {"checks", json(report.if_mended->checks, numbering)}};
  all["notes"] = report.notes;
  if (!report.seconds.empty()) {
    Json seconds = Json::object();
    for (const auto& [phase, time] : report.seconds) seconds[phase] = time;
    all["seconds"] = seconds;
  }
  return all;
}

std::string json_text(const Json& object) {
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_json(const Report& report, const Numbering& numbering) {
  return json_text(report_json_object(report, numbering));
}

}  // namespace tetproof::verify
