// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mesh SURFACE -o GRID: the paper's grid of a closed surface, judged before it is written.
#include <fmt/core.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <nlohmann/json.hpp>

#include "corpus/surfaces.hpp"
#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program.hpp"
#include "reference/generate.hpp"
#include "verify/surface.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;
using Json = nlohmann::ordered_json;

const char* const examples =
    "  tetproof-mesh skull.off -o skull.msh --cells 64\n"
    "  tetproof-mesh torus:R=1,r=0.4 -o torus.node --region outside\n"
    "  tetproof-mesh wing:naca=0012 -o wing.vtu --cells 200,40,40 --on-surface 0.1 --json wing.json\n";

struct Arguments {
  std::string surface, grid, cells = "24", points = "0";
  reference::Options options;
  int voxels = 128;
  bool list_surfaces = false, timings = false, ascii = false, binary = false;
};

// Adds the options of reference::Options and of this program.
void declare_options(CLI::App& app, Arguments& a) {
  const std::map<std::string, reference::Region> regions{{"inside", reference::Region::inside},
                                                         {"outside", reference::Region::outside}};
  const std::map<std::string, reference::Diagonals> diagonals{{"lowest", reference::Diagonals::lowest},
                                                              {"shortest", reference::Diagonals::shortest}};
  app.add_option("SURFACE", a.surface,
                 "a closed surface: .stl .off .obj .ply .msh, or a generated one (--list-surfaces)");
  app.add_option("-o,--output", a.grid, "the grid; its ending says the format")
      ->type_name("GRID")
      ->always_capture_default(false);
  app.add_option("--region", a.options.region, "fill the inside, or the outside up to the scaled box")
      ->transform(CLI::CheckedTransformer(regions))
      ->option_text("inside|outside [inside]");
  app.add_option("--cells", a.cells, "lattice cells along the longest side, or along each")
      ->type_name("N|NX,NY,NZ");
  app.add_option("--box-scale", a.options.box_scale, "the lattice's box over the surface's, more than 1")
      ->type_name("S");
  app.add_option(
         "--on-surface", a.options.on_surface,
         "lattice vertices closer to the surface than this go there, in shortest cell edges, 0 to 0.15")
      ->type_name("T");
  app.add_option("--diagonals", a.options.diagonals,
                 "the diagonal of a quadrilateral that two tetrahedra share")
      ->transform(CLI::CheckedTransformer(diagonals))
      ->option_text("lowest|shortest [lowest]");
  app.add_flag("--literal", a.options.literal,
               "as printed: case 5 always kept, --on-surface 0, rounding reported and not mended");
  app.add_option("--points", a.points,
                 "points to insert; only 0 so far: section 3 of the paper is not here yet")
      ->type_name("0");
  app.add_option("--voxels", a.voxels,
                 "voxels along the longest side for the independent volume account; 0: without")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  app.add_flag("--ascii", a.ascii, "write text where the format has both");
  app.add_flag("--binary", a.binary, "write binary where the format has both")->excludes("--ascii");
  app.add_flag("--timings", a.timings, "seconds per phase in the JSON and in the talk");
  app.add_flag("--list-surfaces", a.list_surfaces, "print the generated surfaces with their parameters");
}

// "24" or "24,12,12".
std::array<int, 3> parse_cells(const std::string& text) {
  std::array<int, 3> cells{};
  std::size_t n = 0, at = 0;
  for (; n < 3; ++n) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, comma - at);
    if (word.empty() || word.size() > 8 || word.find_first_not_of("0123456789") != std::string::npos) break;
    cells[n] = std::stoi(word);
    at = comma + 1;
    if (comma == text.size()) {
      ++n;
      break;
    }
  }
  if (at != text.size() + 1 || n == 2 || std::count(cells.begin(), cells.begin() + n, 0) > 0)
    throw InputError(fmt::format(
        "--cells: expected one positive number or three, as in 24 or 24,12,12, found '{}'", text));
  return cells;
}

// What part of the whole time each phase takes, measured on ct_skull.off with a million tetrahedra.
const std::vector<std::pair<std::string, double>> phase_shares{
    {"reading", 0.02},       {"judging the surface", 0.15}, {"contacts", 0.12},
    {"intersections", 0.04}, {"indicators", 0.02},          {"extraction", 0.14},
    {"positivity", 0.01},    {"verification", 0.42},        {"writing", 0.08}};

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

std::string orientation_of(const verify::SurfaceReport& surface) {
  const auto outward = std::count_if(surface.components.begin(), surface.components.end(),
                                     [](const verify::SurfaceComponent& c) { return c.outward; });
  if (outward == static_cast<std::ptrdiff_t>(surface.components.size())) return "outward";
  return outward == 0 ? "inward" : "mixed";
}

Json generation_json(const Arguments& a, const verify::SurfaceReport& surface,
                     const reference::Generation& made) {
  Json cases, table3;
  for (std::size_t r = 0; r < made.grid.rows.size(); ++r)
    cases[std::string(reference::tables::table2[r].name)] = made.grid.rows[r];
  for (std::size_t r = 0; r < made.table3.size(); ++r)
    table3[std::string(reference::tables::table3[r].name)] = made.table3[r];
  return {
      {"surface",
       {{"file", a.surface},
        {"triangles", surface.triangles},
        {"components", surface.components.size()},
        {"orientation", orientation_of(surface)}}},
      {"lattice",
       {{"cells", made.lattice.cells}, {"points", made.lattice.vertices()}, {"tets", made.lattice.tets()}}},
      {"cases", cases},
      {"table3", table3},
      {"dropped_intersections", made.dropped_intersections},
      {"moved_to_surface", made.moved_to_surface},
      {"mended", made.mended},
      {"collapsed", made.grid.collapsed},
      {"not_positive", made.not_positive}};
}

std::string generation_text(const reference::Generation& made) {
  const auto [nx, ny, nz] = made.lattice.cells;
  std::string text = fmt::format("grid: {} tetrahedra, {} points, from a lattice of {} x {} x {} cells\n",
                                 made.grid.mesh.tets.size(), made.grid.mesh.points.size(), nx, ny, nz);
  if (made.moved_to_surface)
    text += fmt::format("  {} lattice vertices moved to the surface\n", made.moved_to_surface);
  if (made.mended)
    text += fmt::format("  {} more moved there because rounding had inverted a tetrahedron\n", made.mended);
  if (made.dropped_intersections)
    text += fmt::format(
        "  the surface has features thinner than the lattice: {} intersections on lattice edges dropped "
        "(Table 3)\n",
        made.dropped_intersections);
  if (made.not_positive)
    text += fmt::format("  {} tetrahedra are not positive after rounding\n", made.not_positive);
  return text;
}

int mesh(const Arguments& a, const program::Common& common) {
  if (a.list_surfaces) {
    fmt::print("{}", corpus::list_surfaces());
    return program::sound;
  }
  if (a.surface.empty()) throw InputError("expected a SURFACE (see tetproof-mesh --help)");
  if (a.grid.empty()) throw InputError("expected -o GRID (see tetproof-mesh --help)");
  if (a.points != "0")
    throw InputError("--points: expected 0, found '" + a.points +
                     "': section 3 of the paper is not here yet");
  format_of(a.grid);  // refuses an unknown ending before the work
  check_creatable(a.grid);

  Stopwatch watch;
  program::Progress progress(common, phase_shares);
  const auto enter = [&](std::string_view phase) {
    watch.enter(phase);
    progress.enter(phase);
  };
  reference::Options options = a.options;
  options.cells = parse_cells(a.cells);
  options.listener.phase = enter;

  enter("reading");
  const TriangleSurface surface = corpus::open_surface(a.surface);
  enter("judging the surface");
  const verify::JudgedSurface judged_surface(surface);
  const verify::SurfaceReport& judged = judged_surface.report();
  if (!judged.fault.empty()) throw InputError(a.surface + ": " + judged.fault);
  for (const std::string& note : judged.notes) program::say(common, a.surface + ": " + note);

  const reference::Generation made = generate(surface, options);
  if (made.grid.mesh.tets.empty())
    program::say(common,
                 "the grid is empty: the surface is thinner than the lattice everywhere; use more --cells");

  enter("verification");
  const double cell_diagonal = (made.lattice.point(1, 1, 1) - made.lattice.point(0, 0, 0)).norm();
  const verify::Report report =
      verify::verify(made.grid.mesh, judged_surface,
                     {.region = options.region == reference::Region::inside ? verify::Region::inside
                                                                            : verify::Region::outside,
                      .fidelity = cell_diagonal / (judged.box_max - judged.box_min).norm(),
                      .voxels = a.voxels,
                      .timings = a.timings});
  enter("writing");
  WriteOptions write;
  if (a.ascii || a.binary) write.binary = a.binary;
  write_document(a.grid, document_of(made.grid.mesh), write);
  progress.end();
  const auto& seconds = watch.stop();

  if (common.json != "-")
    fmt::print("{}{}written: {}\n", generation_text(made), verify::report_text(report), a.grid);
  if (a.timings)
    for (const auto& [name, s] : seconds) program::say(common, fmt::format("{:>8.3f} s  {}", s, name));
  if (!common.json.empty()) {
    Json json = Json::parse(verify::report_json(report));
    json["generation"] = generation_json(a, judged, made);
    if (a.timings)
      for (const auto& [name, s] : seconds) json["seconds"][name] = s;
    program::write_text(common.json, json.dump(2) + "\n");
  }
  return verify::sound(report) ? program::sound : program::wrong;
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
                        declare_options(app, *a);
                        return [a, &common] { return mesh(*a, common); };
                      });
}
