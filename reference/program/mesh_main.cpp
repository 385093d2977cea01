// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh SURFACE -o GRID: the paper's grid of a closed surface, judged before it is written.
#include <fmt/core.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "corpus/surfaces.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/program.hpp"
#include "reference/program/mesh_options.hpp"
#include "reference/program/mesh_report.hpp"
#include "reference/reduce.hpp"
#include "reference/trace/trace_records.hpp"
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
    "  tetproof-mesh sphere:r=1 --region outside --figure sphere.svg --plane x=0\n"
    "  tetproof-mesh wing:naca=0012 -o wing.vtu --cells 200,40,40 --on-surface 0.1 --json wing.json\n";

// What part of the whole time each phase takes, measured on ct_skull.off: without adaptation with a million
// tetrahedra, with it from 48 cells.
std::vector<std::pair<std::string, double>> phase_shares(bool adapts, bool reduces) {
  std::vector<std::pair<std::string, double>> shares;
  if (!adapts)
    shares = {{"reading", 0.02},       {"judging the surface", 0.15}, {"contacts", 0.12},
              {"intersections", 0.04}, {"indicators", 0.02},          {"extraction", 0.14},
              {"positivity", 0.01},    {"verification", 0.42},        {"writing", 0.08}};
  else
    shares = {{"reading", 0.05}, {"judging the surface", 0.16}, {"contacts", 0.06},     {"extraction", 0.02},
              {"weights", 0.11}, {"insertion", 0.35},           {"verification", 0.22}, {"writing", 0.03}};
  if (reduces) {
    for (auto& [name, share] : shares) share /= 2;
    shares.insert(shares.begin() + 2, {"reduction", 0.5});
  }
  return shares;
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
  TraceFile(const std::string& path, const std::string& surface, trace::Settings settings) {
    if (path.empty()) return;
    file_.emplace(path);
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

verify::JudgedSurface judge(const TriangleSurface& surface, const std::string& name,
                            const program::Common& common) {
  verify::JudgedSurface judged(surface);
  if (!judged.report().fault.empty()) throw InputError(name + ": " + judged.report().fault);
  for (const std::string& note : judged.report().notes) program::say(common, name + ": " + note);
  return judged;
}

TriangleSurface reduced(const TriangleSurface& surface, const Arguments& a, const program::Common& common) {
  TriangleSurface fewer = reference::reduce(surface, a.reduce);
  const auto before = surface.triangles.size(), after = fewer.triangles.size(),
             wanted = static_cast<std::size_t>(a.reduce);
  std::string text = before <= wanted
                         ? fmt::format("{}: not reduced, it has {} triangles", a.surface, before)
                         : fmt::format("{}: reduced from {} to {} triangles", a.surface, before, after);
  if (after > wanted) text += "; with fewer its topology would change, or it would intersect itself";
  if (surface.evaluate && !fewer.evaluate) text += "; its parametric definition is not followed";
  program::say(common, text);
  return fewer;
}

std::string figure_of(const TetMesh& mesh, const TriangleSurface& surface, const reference::Plane& plane,
                      const Arguments& a) {
  const std::string name = a.surface.substr(a.surface.find_last_of('/') + 1);
  const char* const where = a.options.region == reference::Region::inside ? "inside" : "around";
  return reference::figure(
      mesh, surface,
      {.plane = plane, .colour = a.colour, .title = fmt::format("Unstructured grid {} {}", where, name)});
}

int mesh(const Arguments& a, const program::Common& common) {
  if (a.list_surfaces) {
    fmt::print("{}", corpus::list_surfaces());
    return program::sound;
  }
  if (a.surface.empty()) throw InputError("expected a SURFACE (see tetproof-mesh --help)");
  if (a.grid.empty() && a.options.follow.empty() && a.trace.empty() && a.figure.empty())
    throw InputError("expected -o GRID (see tetproof-mesh --help)");
  if (!a.grid.empty()) {
    format_of(a.grid);  // refuses an unknown ending before the work
    check_creatable(a.grid);
  }
  for (const std::string& path : {a.trace, a.figure})
    if (!path.empty()) check_creatable(path);

  reference::Options options = generate_options(a);
  Stopwatch watch;
  program::Progress progress(common, phase_shares(options.adapt.has_value(), a.reduce > 0));
  const auto enter = [&](std::string_view phase) {
    watch.enter(phase);
    progress.enter(phase);
  };
  options.listener.phase = enter;

  enter("reading");
  TriangleSurface surface = corpus::open_surface(a.surface);
  const std::size_t triangles_read = surface.triangles.size();
  enter("judging the surface");
  std::optional<verify::JudgedSurface> judged_surface(judge(surface, a.surface, common));
  if (a.reduce) {
    enter("reduction");
    surface = reduced(surface, a, common);
    judged_surface.emplace(judge(surface, a.surface + ", reduced", common));
  }
  const verify::SurfaceReport& judged = judged_surface->report();
  const reference::Plane plane = reference::parse_plane(a.plane, surface);

  TraceFile trace(a.trace, a.surface, settings_of(options, surface));
  if (trace) options.listener.record = [&](const trace::Record& record) { trace.write(record); };
  const reference::Generation made = generate(surface, options);
  if (made.mesh().tets.empty())
    program::say(common,
                 "the grid is empty: the surface is thinner than the lattice everywhere; use more --cells");

  enter("verification");
  const double cell_diagonal = (made.lattice.point(1, 1, 1) - made.lattice.point(0, 0, 0)).norm();
  const verify::Report report =
      verify::verify(made.mesh(), *judged_surface,
                     {.region = options.region == reference::Region::inside ? verify::Region::inside
                                                                            : verify::Region::outside,
                      .fidelity = cell_diagonal / (judged.box_max - judged.box_min).norm(),
                      .voxels = a.voxels,
                      .coarse = true,
                      .timings = a.timings});
  enter("writing");
  const std::string figure = a.figure.empty() ? "" : figure_of(made.mesh(), surface, plane, a);
  WriteOptions write;
  if (a.ascii || a.binary) write.binary = a.binary;
  if (!a.grid.empty()) write_document(a.grid, document_of(made.mesh()), write);
  trace.commit();
  if (!a.figure.empty()) program::write_text(a.figure, figure);
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
    if (a.reduce) json["generation"]["surface"]["reduced_from"] = triangles_read;
    if (a.timings)
      for (const auto& [name, s] : seconds) json["seconds"][name] = s;
    program::write_text(common.json, json.dump(2) + "\n");
  }
  const bool admissible = !made.follow || made.follow->admissible;
  if (verify::defective(report) || !admissible) return program::wrong;
  return verify::sound(report) ? program::sound : program::incomplete;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run(argc, argv,
                      {.purpose = "Fills a closed surface, or the space around it, with tetrahedra by the "
                                  "method of Hamann, Chen and Hong (1994).",
                       .examples = examples,
                       .libraries = {"CGAL " CGAL_VERSION_STR, "OpenVDB " OPENVDB_LIBRARY_VERSION_STRING,
                                     reference::vertex_tree_library()}},
                      [](CLI::App& app, program::Common& common) -> std::function<int()> {
                        auto a = std::make_shared<Arguments>();
                        reference::declare_options(app, *a);
                        return [a, &common] { return mesh(*a, common); };
                      });
}
