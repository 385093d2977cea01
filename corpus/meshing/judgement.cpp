// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/meshing/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "verify/verify.hpp"

namespace tetproof::corpus {
namespace {

using Clock = std::chrono::steady_clock;

// Voxels along the longest side, for the name of a region that is missing or in excess.
constexpr int voxels_for_regions = 64;

double largest_coordinate(const TriangleSurface& surface) {
  double largest = 0;
  for (const Eigen::Vector3d& p : surface.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

// How far numbers of this size move if they are written with so many significant digits [length].
double rounding_of_text(double largest, int digits) {
  if (digits <= 0 || digits >= std::numeric_limits<double>::max_digits10 || largest == 0) return 0;
  return 0.5 * std::pow(10.0, std::floor(std::log10(largest)) + 1 - digits);
}

// The first failing check, causes before their consequences. Null: none failed.
const verify::CheckResult* root_failure(const verify::Report& report) {
  for (const verify::CheckResult& result : report.checks)
    if (result.verdict == verify::Verdict::fail && result.count > 0) return &result;
  for (const verify::CheckResult& result : report.checks)
    if (result.verdict == verify::Verdict::fail) return &result;
  return nullptr;
}

class Judge {
 public:
  Judge(const MesherRun& run, const Mesher& mesher, const verify::JudgedSurface& surface,
        const JudgeOptions& asked)
      : run_(run), surface_(surface), coarse_(mesher.coarse()) {
    options_.check = asked.check;
    options_.quality = false;
    options_.voxels = 0;
    options_.decide_only = true;
    if (run.document) {
      TetRegions regions = tet_regions(*run.document);
      options_.regions = std::move(regions.of_tet);
      options_.region_tags = std::move(regions.tags);
      options_.unjudged = verify::unjudged(*run.document);
    }
    options_.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(asked.seconds));
    const verify::SurfaceReport& box = surface.report();
    const double diagonal = (box.box_max - box.box_min).stableNorm();
    const double largest = largest_coordinate(surface.surface());
    const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    judgement_.allowed = (mesher.may_change_boundary() ? mesher.fidelity() : asked.tolerance) * diagonal +
                         8 * ulp + rounding_of_text(largest, run.digits);
    options_.fidelity = judgement_.allowed / diagonal;
  }

  Judgement judge() {
    if (asks(false) && !passes(verify::verify(run_.mesh, options_), Outcome::wrong)) return judgement_;
    if (!asks(true)) return judgement_;
    verify::Options against = options_;
    if (against.check.empty()) against.check = checks_of_pass_2();
    set_against_surface(against, coarse_);
    if (!passes(verify::verify(run_.mesh, surface_, against), Outcome::wrong_against_surface) &&
        judgement_.outcome == Outcome::wrong_against_surface && options_.check.empty())
      name_region(against);
    return judgement_;
  }

 private:
  // Whether checks that need a surface (or none) are asked for. Without any, that pass is not made.
  bool asks(bool with_surface) const {
    return options_.check.empty() ||
           std::any_of(options_.check.begin(), options_.check.end(), [&](const std::string& id) {
             return verify::info(verify::check_of_id(id)).needs_surface == with_surface;
           });
  }

  // Pass 1 has answered the rest, and what a mesh alone may have (cavities, edges where walls touch), a mesh
  // of this surface may not. Regions that are missing or in excess are looked for if something differs: where
  // boundary and surface are as near as this, have the same volume, components and cavities, there are none.
  static std::vector<std::string> checks_of_pass_2() {
    using verify::Check;
    std::vector<std::string> ids;
    for (const Check check :
         {Check::cavity, Check::boundary_nonmanifold_edge, Check::boundary_nonmanifold_vertex,
          Check::bounding_box, Check::off_surface_vertex, Check::topology, Check::volume_surface,
          Check::mesh_to_surface, Check::surface_to_mesh})
      ids.emplace_back(verify::info(check).id);
    return ids;
  }

  // Keeps the report, and what it makes of the run. False: there is nothing more to ask.
  bool passes(verify::Report report, Outcome failure) {
    judgement_.report = std::move(report);
    if (const verify::CheckResult* root = root_failure(*judgement_.report)) {
      judgement_.outcome = failure;
      judgement_.signature = verify::info(root->check).id;
      judgement_.what = root->findings.empty() ? judgement_.signature : root->findings[0].what;
      return false;
    }
    if (judgement_.report->not_judged.empty()) return true;
    const verify::NotJudged& open = judgement_.report->not_judged.front();
    judgement_.outcome = Outcome::not_judged;
    judgement_.signature = open.what;
    judgement_.what = fmt::format("{} not judged: {}", open.what, open.why);
    return false;
  }

  // The same once more with voxels: a region that is missing or in excess is the cause of the rest.
  void name_region(verify::Options options) {
    options.voxels = voxels_for_regions;
    for (const verify::Check check : {verify::Check::missing_region, verify::Check::excess_region})
      options.check.emplace_back(verify::info(check).id);
    try {
      verify::Report report = verify::verify(run_.mesh, surface_, options);
      if (root_failure(report)) passes(std::move(report), Outcome::wrong_against_surface);
    } catch (const verify::OutOfTime&) {  // the verdict is given already; only its best name is not
    }
  }

  const MesherRun& run_;
  const verify::JudgedSurface& surface_;
  bool coarse_;
  verify::Options options_;
  Judgement judgement_;
};

Judgement judge_against(const MesherRun& run, const Mesher& mesher, const verify::JudgedSurface& surface,
                        const JudgeOptions& options) {
  if (run.failure) return {.outcome = *run.failure, .signature = run.signature, .what = run.message};
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Judgement judgement;
  try {
    judgement = Judge(run, mesher, surface, options).judge();
  } catch (const verify::OutOfTime& late) {
    judgement = {.outcome = Outcome::not_judged,
                 .signature = late.what(),
                 .what = fmt::format("{}: {} s", late.what(), options.seconds)};
  }
  judgement.seconds = seconds();
  return judgement;
}

}  // namespace

void set_against_surface(verify::Options& options, bool coarse) {
  options.region = verify::Region::inside;
  options.coarse = coarse;
  options.strict_topology = !coarse;
  if (!coarse || options.check.size() == 1) return;  // without its only check a list would mean all checks
  const std::string box = verify::info(verify::Check::bounding_box).id;
  if (options.check.empty())
    options.skip = {box};
  else
    std::erase(options.check, box);
}

Judgement judge_run(const MesherRun& run, const Mesher& mesher, const verify::JudgedSurface& surface,
                    const JudgeOptions& options) {
  if (run.given) {
    // Its file rounded the surface: what the mesher got counts, and it may be no valid surface any more.
    const verify::JudgedSurface given(*run.given);
    if (!given.report().fault.empty())
      return {.outcome = Outcome::not_judged,
              .signature = "the file rounds the surface to an invalid one",
              .what = given.report().fault};
    return judge_against(run, mesher, given, options);
  }
  return judge_against(run, mesher, surface, options);
}

}  // namespace tetproof::corpus
