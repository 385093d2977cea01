// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the judgement.
#include "verify/verify.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cmath>

#include "io/error.hpp"
#include "verify/checks/check_surface.hpp"
#include "verify/checks/judgement.hpp"
#include "verify/checks/surface_judgement.hpp"
#include "verify/mesh/mesh_volumes.hpp"
#include "verify/mesh/quality.hpp"
#include "verify/mesh/regions.hpp"

namespace tetproof::verify {
namespace {

// Wall time from one call to the next.
class Phases {
 public:
  Phases(bool on, Report& report) : on_(on), report_(report) {}
  void done(const char* phase) {
    const auto now = Clock::now();
    if (on_) report_.seconds.emplace_back(phase, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  Report& report_;
  Clock::time_point last_ = Clock::now();
};

std::array<bool, check_count> asked_checks(const Options& options, bool with_surface) {
  std::array<bool, check_count> asked;
  asked.fill(options.check.empty());
  for (const std::string& id : options.check) asked[static_cast<std::size_t>(check_of_id(id))] = true;
  for (const std::string& id : options.skip) asked[static_cast<std::size_t>(check_of_id(id))] = false;
  if (!with_surface || options.region == Region::none)
    for (int i = 0; i < check_count; ++i)
      if (info(static_cast<Check>(i)).needs_surface) asked[static_cast<std::size_t>(i)] = false;
  return asked;
}

void settle_verdicts(const Judgement& j, Report& report) {
  const auto fails = [&](const CheckInfo& row) {
    if (row.severity == Severity::topology)
      return j.options.strict_topology || (report.surface && j.options.fidelity == 0);
    return row.severity == Severity::fail &&
           !(j.options.coarse && (row.check == Check::surface_to_mesh || row.check == Check::missing_region));
  };
  bool violated = false, open = false;
  for (CheckResult& result : report.checks) {
    const CheckInfo& row = info(result.check);
    const bool held = result.count + result.consequences == 0;
    if (row.certificate) {
      violated = violated || !held;
      open = open || !j.wants(result.check);
    }
    if (!j.wants(result.check))
      result.verdict = Verdict::skipped;
    else if (!held)
      result.verdict = fails(row) ? Verdict::fail : Verdict::warning;
    else if (result.verdict != Verdict::undecided)
      result.verdict = Verdict::pass;
  }
  if (violated)
    report.certificate = false;
  else if (!open)
    report.certificate = true;
}

Report judge_mesh(const TetMesh& mesh, const JudgedSurface* surface, const Options& options) {
  if (!(options.fidelity >= 0) || !std::isfinite(options.fidelity))
    throw InputError(fmt::format("fidelity is {}, expected a number >= 0", options.fidelity));
  if (!options.regions.empty() && options.regions.size() != mesh.tets.size())
    throw InputError(fmt::format("regions of {} tetrahedra are given, expected those of all {}",
                                 options.regions.size(), mesh.tets.size()));
  Judgement j{.mesh = mesh, .options = options, .asked = asked_checks(options, surface)};
  Report& report = j.report;
  for (int i = 0; i < check_count; ++i) report.checks.push_back({.check = static_cast<Check>(i)});
  Phases phases(options.timings, report);

  if (surface) {
    if (!surface->report().fault.empty()) throw InputError(surface->report().fault);
    report.notes = surface->report().notes;
  }
  check_numbers_and_points(j);
  phases.done("points");
  check_tetrahedra(j);
  phases.done("tetrahedra");
  const MeshVolumes volumes = mesh_volumes(mesh, j.boundary);
  report.mesh = shape_of(j.boundary, volumes);
  report.mesh.points = static_cast<std::int64_t>(mesh.points.size());
  report.mesh.tets = static_cast<std::int64_t>(mesh.tets.size());
  report.mesh.boundary_faces = j.boundary_faces;
  report.volume.mesh = report.mesh.volume;
  if (!options.regions.empty()) report.regions = account_of_regions(mesh, options.regions, j.excluded);
  phases.done("volume");
  check_boundary(j, volumes, surface ? right_cavities(options.region, surface->report()) : 0);
  phases.done("boundary");
  if (surface) {
    check_against_surface(j, volumes, surface->surface(), surface->judgement());
    phases.done("against the surface");
  }
  if (options.quality) {
    report.quality = measure_quality(mesh, j.excluded);
    phases.done("quality");
  }
  settle(mesh, j.suspects, report);
  settle_verdicts(j, report);
  phases.done("findings");
  return std::move(report);
}

}  // namespace

Report verify(const TetMesh& mesh, const Options& options) {
  return judge_mesh(mesh, nullptr, options);
}

Report verify(const TetMesh& mesh, const TriangleSurface& surface, const Options& options) {
  return verify(mesh, JudgedSurface(surface), options);
}

Report verify(const TetMesh& mesh, const JudgedSurface& surface, const Options& options) {
  return judge_mesh(mesh, &surface, options);
}

}  // namespace tetproof::verify
