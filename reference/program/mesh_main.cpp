// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh SURFACE -o GRID: makes the paper's grid of a closed surface and judges it before writing it.
#include <fmt/core.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "corpus/surfaces.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "io/program/report_losses.hpp"
#include "io/surface/used_vertices.hpp"
#include "reference/program/mesh_options.hpp"
#include "reference/program/mesh_page.hpp"
#include "reference/program/mesh_report.hpp"
#include "reference/reduce.hpp"
#include "verify/reports/report_json.hpp"
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
    "  tetproof-mesh skull.off --v0 0.05 --figure skull.svg --view 3d\n"
    "  zcat part.stl.gz | tetproof-mesh - -o part.msh\n"
    "  tetproof-mesh wing:naca=0012 -o wing.vtu --cells 200,40,40 --on-surface 0.1 --json wing.json\n";

// Each phase's share of the whole time, measured on ct_skull.off: without adaptation with a million
// tetrahedra, with adaptation from 48 cells.
std::vector<std::pair<std::string, double>> phase_shares(bool adapts, bool reduces) {
  std::vector<std::pair<std::string, double>> shares;
  if (!adapts)
    shares = {{"reading", 0.02},       {"judging the surface", 0.11}, {"contacts", 0.06},
              {"intersections", 0.01}, {"indicators", 0.01},          {"extraction", 0.04},
              {"positivity", 0.01},    {"verification", 0.69},        {"writing", 0.05}};
  else
    shares = {{"reading", 0.02}, {"judging the surface", 0.10}, {"contacts", 0.02},     {"extraction", 0.01},
              {"weights", 0.09}, {"insertion", 0.48},           {"verification", 0.26}, {"writing", 0.02}};
  if (reduces) {
    for (auto& [name, share] : shares) share /= 2;
    shares.insert(shares.begin() + 2, {"reduction", 0.5});
  }
  return shares;
}

// Measures the wall time of named phases, one after the other.
class Stopwatch {
 public:
  void enter(std::string_view name) {
    const auto now = std::chrono::steady_clock::now();
    if (!phases_.empty()) phases_.back().second += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    for (std::size_t p = 0; p < phases_.size(); ++p)  // a phase that is entered again goes on
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

// Writes the trace, record by record, to a file or to standard output. Without a path it does nothing.
class TraceOutput {
 public:
  TraceOutput(const std::string& path, const std::string& surface, trace::Settings settings) : path_(path) {
    if (path.empty()) return;
    if (path != "-") file_.emplace(path);
    settings.program = "tetproof-mesh";
    settings.surface = surface;
    write(settings);
  }
  explicit operator bool() const { return !path_.empty(); }
  void write(const trace::Record& record) {
    const std::string line = trace::to_line(record) + "\n";
    if (file_)
      file_->write(line);
    else
      program::write_text(path_, line);
  }
  void commit() {
    if (file_) file_->commit();
  }

 private:
  std::string path_;
  std::optional<AtomicFile> file_;
};

verify::JudgedSurface judge(const TriangleSurface& surface, const std::string& name,
                            const program::Common& common, SurfaceNumbering numbering = {}) {
  verify::JudgedSurface judged(surface, std::move(numbering));
  if (!judged.report().fault.empty()) throw InputError(name + ": " + judged.report().fault);
  for (const std::string& note : judged.report().notes)
    program::say(common, fmt::format("{}: {}", name, note));
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

// The surface without vertices that no triangle names, and says how many there are. `numbering` follows.
TriangleSurface used_part(TriangleSurface surface, SurfaceNumbering& numbering, const Arguments& a,
                          const program::Common& common) {
  std::optional<TriangleSurface> used = io::without_unused_vertices(surface, numbering);
  if (!used) return surface;
  const auto left_out = surface.vertices.size() - used->vertices.size();
  program::say(common, fmt::format("{}: without {} that no triangle names", a.surface,
                                   io::counted(left_out, "vertices")));
  return std::move(*used);
}

// Declares the run's files, and refuses outputs that could not be written after the work.
program::FilesInUse files_of(const Arguments& a, const WriteOptions& write, const program::Common& common) {
  program::FilesInUse files(common);
  if (!corpus::is_generated(a.surface))
    files.reads_mesh("SURFACE", a.surface, a.read);
  else if (!a.read.format.empty())
    throw InputError("--from needs a SURFACE that is a file");
  if (!a.options.follow.empty()) files.reads("--follow", a.options.follow);
  if (!a.grid.empty()) {
    encoding_of(a.grid, write);
    program::check_holds_tetrahedra(a.grid);
  }
  files.writes_mesh("-o", a.grid, write);
  files.writes_mesh("--save-surface", a.save_surface, {});
  files.writes("--trace", a.trace);
  files.writes("--figure", a.figure);
  files.writes("--html", a.html);
  return files;
}

void write_grid(const TetMesh& grid, const Arguments& a, const WriteOptions& write,
                program::FilesInUse& files, const program::Common& common, Json& json) {
  const Document document = document_of(grid);
  program::MeshOutput output(common, files, "-o", a.grid, document, write);
  output.write();
  json["losses"] = program::losses_json(output.losses());
  json["kept_aside"] = program::losses_json(output.kept_aside().items);
}

// Writes the surface as it is used, with its (u,v) if it has them and the format holds them.
void save_surface(const TriangleSurface& surface, const Arguments& a, program::FilesInUse& files,
                  const program::Common& common) {
  if (a.save_surface.empty()) return;
  const Document document = document_of(surface);
  program::MeshOutput(common, files, "--save-surface", a.save_surface, document).write();
}

int mesh(const Arguments& a, const program::Common& common) {
  if (a.list_surfaces) {
    fmt::print("{}", corpus::list_surfaces());
    return program::sound;
  }
  if (a.surface.empty()) throw InputError("expected a SURFACE (see tetproof-mesh --help)");
  if (a.grid.empty() && a.options.follow.empty() && a.trace.empty() && a.figure.empty() &&
      a.save_surface.empty() && a.html.empty())
    throw InputError("expected -o GRID (see tetproof-mesh --help)");
  WriteOptions write;
  if (a.ascii || a.binary) write.binary = a.binary;
  program::FilesInUse files = files_of(a, write, common);

  reference::Options options = generate_options(a);
  Stopwatch watch;
  program::Progress progress(common, phase_shares(options.adapt.has_value(), a.reduce > 0));
  const auto enter = [&](std::string_view phase) {
    watch.enter(phase);
    progress.enter(phase);
  };
  options.listener.phase = enter;
  if (program::shows_progress(common))
    options.listener.inserted = [&](std::int64_t made, std::int64_t wanted) {
      progress.at(static_cast<std::uint64_t>(made), static_cast<std::uint64_t>(wanted));
    };
  ReadOptions read = a.read;
  read.progress = progress.part_listener();

  enter("reading");
  SurfaceFile file = corpus::open_surface_file(a.surface, read);
  program::report_reading(common, file.warnings, file.dropped);
  TriangleSurface surface = used_part(std::move(file.surface), file.numbering, a, common);
  const std::size_t triangles_read = surface.triangles.size();
  enter("judging the surface");
  std::optional<verify::JudgedSurface> judged_surface(
      judge(surface, a.surface, common, std::move(file.numbering)));
  if (a.reduce) {
    enter("reduction");
    surface = reduced(surface, a, common);
    judged_surface.emplace(judge(surface, a.surface + ", reduced", common));
  }
  save_surface(surface, a, files, common);
  const verify::SurfaceReport& judged = judged_surface->report();
  const reference::FigureOptions figure_asked = figure_options(a, surface);

  TraceOutput trace(a.trace, a.surface, settings_of(options, static_cast<bool>(surface.evaluate)));
  std::vector<double> e_avg;  // after each insertion, for the page
  if (trace || !a.html.empty())
    options.listener.record = [&](const trace::Record& record) {
      if (trace) trace.write(record);
      if (const auto* insertion = std::get_if<trace::Insertion>(&record)) e_avg.push_back(insertion->e_avg);
      if (const auto* flip = std::get_if<trace::Flip>(&record); flip && !e_avg.empty())
        e_avg.back() = flip->e_avg;
    };
  const reference::Generation made = generate(surface, options);
  const bool empty = made.mesh().tets.empty();
  const int cells = *std::max_element(made.lattice.cells.begin(), made.lattice.cells.end());
  if (empty)
    program::say(
        common,
        fmt::format("the grid is empty: the surface is thinner than the lattice of {} cells everywhere; "
                    "use more --cells",
                    cells));
  else if (options.raise_cells && cells > reference::Options().cells[0])
    program::say(common,
                 fmt::format("the grid with {} cells is empty, because the surface is thin: {} are taken",
                             reference::Options().cells[0], cells));

  enter("verification");
  verify::Unjudged unjudged;
  verify::add_unread_surface(unjudged, file.dropped);
  const double cell_diagonal = (made.lattice.point(1, 1, 1) - made.lattice.point(0, 0, 0)).norm();
  const verify::Report report =
      verify::verify(made.mesh(), *judged_surface,
                     {.region = options.region == reference::Region::inside ? verify::Region::inside
                                                                            : verify::Region::outside,
                      .fidelity = cell_diagonal / (judged.box_max - judged.box_min).norm(),
                      .voxels = a.voxels,
                      .coarse = true,
                      .unjudged = std::move(unjudged),
                      .timings = a.timings});
  enter("writing");
  const std::string page = a.html.empty() ? ""
                                          : reference::mesh_page(report, {.made = made,
                                                                          .surface = surface,
                                                                          .surface_name = a.surface,
                                                                          .grid_name = a.grid,
                                                                          .e_avg = std::move(e_avg)});
  const std::string figure = a.figure.empty() ? "" : reference::figure(made.mesh(), surface, figure_asked);
  Json json = verify::report_json_object(report);
  add_generation(json, a.surface, judged, made);
  if (a.reduce) json["generation"]["surface"]["reduced_from"] = triangles_read;
  json["dropped"] = program::losses_json(file.dropped);
  if (!a.grid.empty()) write_grid(made.mesh(), a, write, files, common, json);
  trace.commit();
  if (!a.figure.empty()) program::write_text(a.figure, figure);
  if (!a.html.empty()) program::write_text(a.html, page);
  progress.end();
  const auto& seconds = watch.stop();

  if (!files.standard_output_is_taken())
    fmt::print("{}{}{}", generation_text(made), verify::report_text(report),
               a.grid.empty() ? "" : fmt::format("written: {}\n", a.grid));
  if (a.timings)
    for (const auto& [name, s] : seconds) {
      program::say(common, fmt::format("{:>8.3f} s  {}", s, name));
      json["seconds"][name] = s;
    }
  if (!common.json.empty()) program::write_json(common.json, json);
  const bool admissible = !made.follow || made.follow->admissible;
  if (verify::defective(report) || !admissible || empty) return program::wrong;
  const bool all_checked = !made.follow || made.follow->not_checked.empty();
  return verify::sound(report) && all_checked ? program::sound : program::incomplete;
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
