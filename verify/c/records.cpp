// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/c/records.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace tetproof::c {
namespace {

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::int64_t or_unknown(const std::optional<std::int64_t>& count) {
  return count.value_or(-1);
}

std::int32_t certificate_of(const std::optional<bool>& certificate) {
  return certificate ? (*certificate ? 1 : 0) : -1;
}

std::int32_t verdict_of(verify::Verdict verdict) {
  switch (verdict) {
    case verify::Verdict::pass:
      return TETPROOF_CHECK_PASS;
    case verify::Verdict::warning:
      return TETPROOF_CHECK_WARNING;
    case verify::Verdict::fail:
      return TETPROOF_CHECK_FAIL;
    case verify::Verdict::undecided:
      return TETPROOF_CHECK_UNDECIDED;
    case verify::Verdict::skipped:
      break;
  }
  return TETPROOF_CHECK_SKIPPED;
}

template <class Items>
std::int64_t count_of(const Items& items) {
  return static_cast<std::int64_t>(items.size());
}

tetproof_distribution distribution(const verify::Distribution& of, bool measured) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {.min = measured ? of.min : none,
          .max = measured ? of.max : none,
          .bin_count = count_of(of.counts),
          .edges = of.edges.data(),
          .counts = of.counts.data()};
}

}  // namespace

template <class Record, class Items, class Make>
const Record* const* Records::list(List<Record>& to, const Items& items, const Make& make) {
  std::vector<const Record*> pointers;
  for (const auto& item : items) pointers.push_back(&to.records.emplace_back(make(item)));
  return to.lists.emplace_back(std::move(pointers)).data();
}

const std::int64_t* Records::keep(std::vector<std::int64_t> numbers) {
  return numbers_.emplace_back(std::move(numbers)).data();
}

const tetproof_consequence* const* Records::consequences(const std::vector<verify::Consequence>& all) {
  return list(consequences_, all, [](const verify::Consequence& one) {
    return tetproof_consequence{.check = verify::info(one.check).id, .count = one.count};
  });
}

const tetproof_not_judged* const* Records::not_judged(const std::vector<verify::NotJudged>& all) {
  return list(not_judged_, all, [](const verify::NotJudged& one) {
    return tetproof_not_judged{.what = one.what.c_str(), .count = one.count, .why = one.why.c_str()};
  });
}

tetproof_finding Records::finding(const verify::Finding& of) {
  std::vector<std::int64_t> tets, positions, runs, vertices, vertex_positions, faces;
  for (const Index t : of.tets) tets.push_back(numbering_.tet(t)), positions.push_back(t);
  for (const auto& [first, last] : of.tet_runs)
    runs.push_back(numbering_.tet(first)), runs.push_back(numbering_.tet(last));
  for (const Index v : of.vertices)
    vertices.push_back(numbering_.point(v)), vertex_positions.push_back(std::max<Index>(v, -1));
  for (const auto& face : of.faces)
    for (const Index v : face) faces.push_back(numbering_.point(v));
  tetproof_finding record{.tet_count = count_of(of.tets),
                          .tets = keep(std::move(tets)),
                          .tet_positions = keep(std::move(positions)),
                          .tet_run_count = count_of(of.tet_runs),
                          .tet_runs = keep(std::move(runs)),
                          .vertex_count = count_of(of.vertices),
                          .vertices = keep(std::move(vertices)),
                          .vertex_positions = keep(std::move(vertex_positions)),
                          .face_count = count_of(of.faces),
                          .faces = keep(std::move(faces)),
                          .has_point = of.point.has_value(),
                          .what = of.what.c_str(),
                          .consequence_count = count_of(of.consequences),
                          .consequences = consequences(of.consequences)};
  for (std::size_t k = 0; k < 3; ++k) {
    record.point[k] =
        of.point ? (*of.point)[static_cast<Eigen::Index>(k)] : std::numeric_limits<double>::quiet_NaN();
    record.point_exact[k] = of.point_exact[k].empty() ? nullptr : of.point_exact[k].c_str();
  }
  return record;
}

tetproof_check Records::check(const verify::CheckResult& of) {
  return {.id = verify::info(of.check).id,
          .verdict = verdict_of(of.verdict),
          .exact = verify::info(of.check).all_exact,
          .count = of.count,
          .consequences = of.consequences,
          .measured = or_nan(of.measured),
          .allowed = or_nan(of.allowed),
          .why = of.why.c_str(),
          .finding_count = count_of(of.findings),
          .findings = list(findings_, of.findings, [&](const verify::Finding& one) { return finding(one); })};
}

const tetproof_check* const* Records::checks(const std::vector<verify::CheckResult>& results) {
  return list(checks_, results, [&](const verify::CheckResult& one) { return check(one); });
}

tetproof_shape Records::shape(const verify::Shape& of) {
  return {.points = of.points,
          .tets = of.tets,
          .boundary_faces = of.boundary_faces,
          .components = or_unknown(of.components),
          .cavities = or_unknown(of.cavities),
          .genus = or_unknown(of.genus),
          .genus_count = count_of(of.genus_per_component),
          .genus_per_component = of.genus_per_component.data(),
          .volume = or_nan(of.volume)};
}

void Records::take_measures(const verify::Report& report) {
  const verify::VolumeAccount& v = report.volume;
  volume_ = {.mesh = or_nan(v.mesh),
             .surface = or_nan(v.surface),
             .relative_difference = or_nan(v.relative_difference),
             .voxel_inside = or_nan(v.voxel_inside),
             .voxel_error_bound = or_nan(v.voxel_error_bound),
             .voxel_error_estimate = or_nan(v.voxel_error_estimate),
             .missing = or_nan(v.missing),
             .excess = or_nan(v.excess)};
  all_.volume = &volume_;
  if (report.fidelity) {
    fidelity_ = {.mesh_to_surface = or_nan(report.fidelity->mesh_to_surface),
                 .surface_to_mesh = or_nan(report.fidelity->surface_to_mesh),
                 .error_bound = report.fidelity->error_bound,
                 .allowed = report.fidelity->allowed};
    all_.fidelity = &fidelity_;
  }
  if (report.quality) {
    const bool measured = report.quality->tets > 0;
    quality_ = {.tets = report.quality->tets,
                .dihedral_angles = distribution(report.quality->dihedral_angles, measured),
                .solid_angles = distribution(report.quality->solid_angles, measured),
                .aspect_ratios = distribution(report.quality->aspect_ratios, measured)};
    all_.quality = &quality_;
  }
}

Records::Records(const verify::Report& report, const Numbering& numbering) : numbering_(numbering) {
  all_.verdict = verify::sound(report)       ? TETPROOF_SOUND
                 : verify::defective(report) ? TETPROOF_DEFECTIVE
                                             : TETPROOF_INCOMPLETE;
  all_.certificate = certificate_of(report.certificate);
  all_.by_corners = report.by_corners;
  all_.check_count = count_of(report.checks);
  all_.checks = checks(report.checks);
  all_.not_judged_count = count_of(report.not_judged);
  all_.not_judged = not_judged(report.not_judged);
  all_.left_out_count = count_of(report.left_out);
  all_.left_out = not_judged(report.left_out);
  all_.allowed_count = count_of(report.allowed);
  all_.allowed = consequences(report.allowed);
  mesh_ = shape(report.mesh);
  all_.mesh = &mesh_;
  if (report.surface) {
    surface_ = shape(*report.surface);
    all_.surface = &surface_;
  }
  all_.region_count = count_of(report.regions);
  all_.regions = list(regions_, report.regions, [&](const verify::RegionAccount& one) {
    return tetproof_region{.tag = one.tag.tag,
                           .kind = one.tag.kind.c_str(),
                           .name = one.tag.name.c_str(),
                           .shape = shape(one.shape)};
  });
  take_measures(report);
  for (const std::string& note : report.notes) notes_.push_back(note.c_str());
  all_.note_count = count_of(notes_);
  all_.notes = notes_.data();
  all_.mended_certificate = -1;
  if (!report.if_mended) return;
  all_.mended_how = report.if_mended->how.c_str();
  all_.mended_certificate = certificate_of(report.if_mended->certificate);
  all_.mended_check_count = count_of(report.if_mended->checks);
  all_.mended_checks = checks(report.if_mended->checks);
}

}  // namespace tetproof::c
