// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh SURFACE -o GRID: the paper's grid of a closed surface, judged before it is written.
#include <fmt/core.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "corpus/surfaces.hpp"
#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program.hpp"
#include "reference/mesh_options.hpp"
#include "reference/mesh_report.hpp"
#include "reference/trace_records.hpp"
#include "verify/surface.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;
using reference::Arguments;
using Json = nlohmann::ordered_json;

const char* const examples =
    "  tetproof-mesh skull.off -o skull.msh --cells 64\n"
    "  tetproof-mesh torus:R=1,r=0.4 -o torus.node --region outside\n"
    "  tetproof-mesh ball.stl -o ball.msh --v0 0.1 --v1 1 --curvature --trace ball.jsonl\n"
    "  tetproof-mesh ball.stl --v0 0.1 --v1 1 --curvature --follow yours.jsonl\n"
    "  tetproof-mesh wing:naca=0012 -o wing.vtu --cells 200,40,40 --on-surface 0.1 --json wing.json\n";

// What part of the whole time each phase takes, measured on ct_skull.off: without adaptation with a million
// tetrahedra, with it from 48 cells.
std::vector<std::pair<std::string, double>> phase_shares(bool adapts) {
  if (!adapts)
    return {{"reading", 0.02},       {"judging the surface", 0.15}, {"contacts", 0.12},
            {"intersections", 0.04}, {"indicators", 0.02},          {"extraction", 0.14},
            {"positivity", 0.01},    {"verification", 0.42},        {"writing", 0.08}};
  return {{"reading", 0.05}, {"judging the surface", 0.16}, {"contacts", 0.06},     {"extraction", 0.02},
          {"weights", 0.11}, {"insertion", 0.35},           {"verification", 0.22}, {"writing", 0.03}};
}

// Wall time of named phases, one after the other.
class Stopwatch {
 public:
  void enter(std::string_view name) {
    const auto now = std::chrono::steady_clock::now();
    if (!phases_.empty()) phases_.back().second += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    for (std::size_t p = 0; p < phases_.size(); ++p)  // a phase entered again goes on
      if (phases_[p].first == name) std::rotate(phases_.begin() + p, phases_.begin() + p + 1, phases_.end());
    if (phases_.empty() || phases_.back().first != name) phases_.emplace_back(name, 0.0);
  }
  const std::vector<std::pair<std::string, double>>& stop() {
    enter("end");
    phases_.pop_back();
    return phases_;
  }

 private:
  std::vector<std::pair<std::string, double>> phases_;
  std::chrono::steady_clock::time_point since_;
};

// The trace as it grows; nothing without a name.
class TraceFile {
 public:
  TraceFile(const std::string& path, const std::string& surface, const reference::Options& options) {
    if (path.empty()) return;
    file_.emplace(path);
    trace::Settings settings = settings_of(options);
    settings.program = "tetproof-mesh";
    settings.surface = surface;
    write(settings);
  }
  explicit operator bool() const { return file_.has_value(); }
  void write(const trace::Record& record) { file_->write(trace::to_line(record) + "\n"); }
  void commit() {
    if (file_) file_->commit();
  }

 private:
  std::optional<AtomicFile> file_;
};

int mesh(const Arguments& a, const program::Common& common) {
  if (a.list_surfaces) {
    fmt::print("{}", corpus::list_surfaces());
    return program::sound;
  }
  if (a.surface.empty()) throw InputError("expected a SURFACE (see tetproof-mesh --help)");
  if (a.grid.empty() && a.options.follow.empty() && a.trace.empty())
    throw InputError("expected -o GRID (see tetproof-mesh --help)");
  if (!a.grid.empty()) {
    format_of(a.grid);  // refuses an unknown ending before the work
    check_creatable(a.grid);
  }

  reference::Options options = generate_options(a);
  Stopwatch watch;
  program::Progress progress(common, phase_shares(options.adapt.has_value()));
  const auto enter = [&](std::string_view phase) {
    watch.enter(phase);
    progress.enter(phase);
  };
  options.listener.phase = enter;
  TraceFile trace(a.trace, a.surface, options);
  if (trace) options.listener.record = [&](const trace::Record& record) { trace.write(record); };

  enter("reading");
  const TriangleSurface surface = corpus::open_surface(a.surface);
  enter("judging the surface");
  const verify::JudgedSurface judged_surface(surface);
  const verify::SurfaceReport& judged = judged_surface.report();
  if (!judged.fault.empty()) throw InputError(a.surface + ": " + judged.fault);
  for (const std::string& note : judged.notes) program::say(common, a.surface + ": " + note);

  const reference::Generation made = generate(surface, options);
  if (made.mesh().tets.empty())
    program::say(common,
                 "the grid is empty: the surface is thinner than the lattice everywhere; use more --cells");

  enter("verification");
  const double cell_diagonal = (made.lattice.point(1, 1, 1) - made.lattice.point(0, 0, 0)).norm();
  const verify::Report report =
      verify::verify(made.mesh(), judged_surface,
                     {.region = options.region == reference::Region::inside ? verify::Region::inside
                                                                            : verify::Region::outside,
                      .fidelity = cell_diagonal / (judged.box_max - judged.box_min).norm(),
                      .voxels = a.voxels,
                      .timings = a.timings});
  enter("writing");
  WriteOptions write;
  if (a.ascii || a.binary) write.binary = a.binary;
  if (!a.grid.empty()) write_document(a.grid, document_of(made.mesh()), write);
  trace.commit();
  progress.end();
  const auto& seconds = watch.stop();

  if (common.json != "-")
    fmt::print("{}{}{}", generation_text(made), verify::report_text(report),
               a.grid.empty() ? "" : fmt::format("written: {}\n", a.grid));
  if (a.timings)
    for (const auto& [name, s] : seconds) program::say(common, fmt::format("{:>8.3f} s  {}", s, name));
  if (!common.json.empty()) {
    Json json = Json::parse(verify::report_json(report));
    add_generation(json, a.surface, judged, made);
    if (a.timings)
      for (const auto& [name, s] : seconds) json["seconds"][name] = s;
    program::write_text(common.json, json.dump(2) + "\n");
  }
  const bool admissible = !made.follow || made.follow->admissible;
  return verify::sound(report) && admissible ? program::sound : program::wrong;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run(argc, argv,
                      {.purpose = "Fills a closed surface, or the space around it, with tetrahedra by the "
                                  "method of Hamann, Chen and Hong (1994).",
                       .examples = examples,
                       .libraries = {"CGAL " CGAL_VERSION_STR, "OpenVDB " OPENVDB_LIBRARY_VERSION_STRING}},
                      [](CLI::App& app, program::Common& common) -> std::function<int()> {
                        auto a = std::make_shared<Arguments>();
                        reference::declare_options(app, *a);
                        return [a, &common] { return mesh(*a, common); };
                      });
}
