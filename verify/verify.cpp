// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of the judgement, in their order.
#include "verify/verify.hpp"

#include <fmt/core.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "io/error.hpp"
#include "verify/checks/check_against_surface.hpp"
#include "verify/checks/evidence.hpp"
#include "verify/checks/whole_mesh.hpp"
#include "verify/mesh/quality.hpp"
#include "verify/mesh/regions.hpp"

namespace tetproof::verify {
namespace {

// Measures the wall time from one call of `done` to the next, keeps the deadline, and tells the listener what
// begins.
class Phases {
 public:
  Phases(const Options& options, Report& report)
      : on_(options.timings), deadline_(options.deadline), progress_(options.progress), report_(report) {}
  void begin(const char* phase) {
    if (progress_) progress_(phase, 0, 0);
  }
  void done(const char* phase) {
    keep(deadline_);
    const auto now = Clock::now();
    if (on_) report_.seconds.emplace_back(phase, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  const Deadline& deadline_;
  const ProgressListener& progress_;
  Report& report_;
  Clock::time_point last_ = Clock::now();
};

void refuse_unusable(const TetMesh& mesh, const JudgedSurface* surface, const Options& options) {
  if (!(options.fidelity >= 0) || !std::isfinite(options.fidelity))
    throw InputError(fmt::format("fidelity is {}, expected a number >= 0", options.fidelity));
  if (!options.regions.empty() && options.regions.size() != mesh.tets.size())
    throw InputError(fmt::format("regions of {} tetrahedra are given, expected those of all {}",
                                 options.regions.size(), mesh.tets.size()));
  const auto tags = static_cast<std::int64_t>(options.region_tags.size());
  for (const std::int64_t region : options.regions)
    if (tags > 0 && (region < 0 || region >= tags))
      throw InputError(fmt::format("region {} is given, expected one of the {} region tags", region, tags));
  if (surface && !surface->report().fault.empty()) throw InputError(surface->report().fault);
}

// What the verdict does not cover, before any check runs.
void add_scope(const Options& options, Report& report) {
  const auto add = [](std::vector<NotJudged>& list, const std::vector<NotJudged>& entries) {
    list.insert(list.end(), entries.begin(), entries.end());
  };
  const Unjudged& unjudged = options.unjudged;
  add(options.only_tets ? report.left_out : report.not_judged, unjudged.elements);
  add(report.not_judged, unjudged.unread);
  report.by_corners = unjudged.curved > 0;
  if (report.by_corners)
    report.not_judged.push_back({"curved shapes", unjudged.curved,
                                 "tetrahedra of second or higher order are judged by their corners"});
}

Shape shape_of_mesh(const TetMesh& mesh, const TetrahedraEvidence& tetrahedra, const Boundary& boundary,
                    const MeshVolumes& volumes) {
  Shape shape = shape_of(boundary, volumes);
  shape.points = static_cast<std::int64_t>(mesh.points.size());
  shape.tets = static_cast<std::int64_t>(mesh.tets.size());
  shape.boundary_faces = static_cast<std::int64_t>(tetrahedra.faces.boundary.size());  // with cracks open
  return shape;
}

Report judge_mesh(const TetMesh& mesh, const JudgedSurface* surface, const Options& options);

// Judges the mended mesh, and names its elements as in the mesh as it is written.
Mended judge_mended(const MendedMesh& mended, const JudgedSurface* surface) {
  Report report = judge_mesh(mended.mesh, surface, mended.options);
  const auto tet = [&](Index& t) { t = mended.tets[static_cast<std::size_t>(t)]; };
  const auto vertex = [&](Index& v) {
    if (v >= 0 && v < static_cast<Index>(mended.vertices.size()))
      v = mended.vertices[static_cast<std::size_t>(v)];
  };
  for (CheckResult& result : report.checks)
    for (Finding& finding : result.findings) {
      std::for_each(finding.tets.begin(), finding.tets.end(), tet);
      for (auto& run : finding.tet_runs) std::for_each(run.begin(), run.end(), tet);
      std::for_each(finding.vertices.begin(), finding.vertices.end(), vertex);
      for (auto& face : finding.faces) std::for_each(face.begin(), face.end(), vertex);
    }
  return {.how = mended.how, .certificate = report.certificate, .checks = std::move(report.checks)};
}

Report judge_mesh(const TetMesh& mesh, const JudgedSurface* surface, const Options& options) {
  Record record(options, surface);
  refuse_unusable(mesh, surface, options);
  Report& report = record.report;
  Phases phases(options, report);
  if (surface) report.notes = surface->report().notes;
  add_scope(options, report);

  phases.begin("points");
  const PointEvidence points = examine_points(mesh, record);
  check_points(mesh, points, options.unjudged, record);
  phases.done("points");

  tbb::task_group beside;  // keeps threads busy where the stages below use one
  if (options.quality)
    beside.run(
        [&mesh, &points, &quality = report.quality] { quality = measure_quality(mesh, points.excluded); });

  phases.begin("tetrahedra");
  const TetrahedraEvidence tetrahedra = examine_tetrahedra(mesh, points, record);
  check_tetrahedra(mesh, tetrahedra, record);
  const WholeMeshEvidence whole = examine_whole_mesh(mesh, points, tetrahedra, options, record);
  Cracks cracks = examine_cracks(mesh, points, tetrahedra, record);
  check_cracks(mesh, points, cracks, record);
  const BoundaryEvidence boundary = examine_boundary(mesh, points, tetrahedra, cracks);
  cracks.closed.reset();  // a copy of the mesh; the pairs of faces are still needed
  phases.done("tetrahedra");

  phases.begin("volume");
  const MeshVolumes volumes = mesh_volumes(mesh, boundary.boundary);
  report.mesh = shape_of_mesh(mesh, tetrahedra, boundary.boundary, volumes);
  report.volume.mesh = report.mesh.volume;
  if (!options.regions.empty()) report.regions = account_of_regions(mesh, options.regions, points.excluded);
  if (!options.region_tags.empty())
    for (RegionAccount& account : report.regions)
      account.tag = options.region_tags[static_cast<std::size_t>(account.tag.tag)];
  phases.done("volume");

  phases.begin("boundary");
  const UnjudgedPlaces unjudged(mesh, boundary.boundary, options);
  ContactEvidence contacts = examine_contacts(mesh, boundary.boundary, record);
  examine_interfaces(mesh, points, tetrahedra, cracks, boundary.boundary, contacts, record);
  check_conformity(mesh, boundary.boundary, contacts, record);
  check_cavities(mesh, boundary.boundary, contacts.conformity, volumes,
                 surface ? right_cavities(options.region, surface->report()) : 0, unjudged, record);
  check_manifold(mesh, boundary.boundary, contacts.conformity, unjudged, record);
  check_self_intersection(mesh, boundary.boundary, contacts, record);
  check_overlap(mesh, points, boundary, contacts, record);
  check_interfaces(mesh, points, boundary.boundary, contacts, record);
  phases.done("boundary");

  if (surface) {
    check_against_surface({mesh, points.excluded, boundary.boundary, volumes, unjudged, options}, *surface,
                          record);
    phases.done("against the surface");
  }
  if (options.quality) phases.begin("quality");
  beside.wait();
  if (options.quality) phases.done("quality");
  phases.begin("findings");
  check_whole_mesh(mesh, points, tetrahedra, whole, record);
  record.settle(mesh, options);
  phases.done("findings");
  if (auto mended = mend(mesh, points, whole, options, record)) {
    phases.begin("without the faults of the whole mesh");
    mended->options.progress = {};  // its stages would seem to be the mesh's again
    report.if_mended = judge_mended(*mended, surface);
    phases.done("without the faults of the whole mesh");
  }
  return std::move(record.report);
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
