// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-verify MESH [SURFACE]: judges a tetrahedral mesh, and whether it fills a surface.
#include <fmt/core.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "corpus/surfaces.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "io/program/program.hpp"
#include "verify/defects.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;

constexpr const char* examples =
    R"(  tetproof-verify grid.msh                        is it a valid triangulation?
  tetproof-verify grid.1.ele bunny.off            and does it fill the surface?
  tetproof-verify air.msh car.stl --region outside
  tetproof-verify tetgen.1.node part.stl --fidelity 0 --json -
  tetproof-verify grid.msh --junit grid.xml       for a CI system
)";

struct Arguments {
  std::string mesh, surface, region, defects, junit;
  verify::Options options;
  bool list_checks = false, list_surfaces = false;
};

struct Loaded {
  TetMesh mesh;
  Numbering numbering;
  std::vector<std::int64_t> regions;
  verify::Unjudged unjudged;
  std::vector<std::string> notes;
};

// The document, which may be many times as large, is gone before the judge starts.
Loaded load(const std::string& path) {
  const Document document = read_document(path);
  Loaded loaded{
      tet_mesh(document), numbering(document), tet_regions(document), verify::unjudged(document), {}};
  if (loaded.mesh.tets.empty()) {
    std::string others;
    for (const verify::NotJudged& entry : loaded.unjudged.elements)
      others += fmt::format("{}{} {}", others.empty() ? ", but " : ", ", entry.count, entry.what);
    throw InputError(path + ": holds no tetrahedra" + others);
  }
  std::size_t higher = 0;
  for (const ElementBlock& block : document.blocks) {
    const io::ElementType* type = io::element_type(block.type);
    if (type && type->shape == io::Shape::tetrahedron && type->nodes > type->corners) higher += block.count;
  }
  if (higher > 0)
    loaded.notes.push_back(
        fmt::format("{} tetrahedra of second or higher order are judged by their corners", higher));
  return loaded;
}

verify::Report judge(const TetMesh& mesh, const Arguments& arguments) {
  if (arguments.surface.empty()) return verify::verify(mesh, arguments.options);
  const TriangleSurface surface = corpus::open_surface(arguments.surface);
  try {
    return verify::verify(mesh, surface, arguments.options);
  } catch (const InputError& error) {
    throw InputError(arguments.surface + ": " + error.what());
  }
}

int work(const Arguments& given, const program::Common& common) {
  if (given.list_checks || given.list_surfaces) {
    program::write_text("-", given.list_checks ? verify::list_checks() : corpus::list_surfaces());
    return program::sound;
  }
  if (given.mesh.empty()) throw InputError("MESH is required (see tetproof-verify --help)");
  Arguments arguments = given;
  for (const auto* ids : {&arguments.options.check, &arguments.options.skip})
    for (const std::string& id : *ids) verify::check_of_id(id);
  if (arguments.surface.empty()) {
    if (!arguments.region.empty() && arguments.region != "none")
      throw InputError(fmt::format("--region {} needs a SURFACE", arguments.region));
  } else {
    const std::map<std::string, verify::Region> regions{{"", verify::Region::inside},
                                                        {"inside", verify::Region::inside},
                                                        {"outside", verify::Region::outside},
                                                        {"none", verify::Region::none}};
    arguments.options.region = regions.at(arguments.region);
  }

  // Measuring costs half as much as the proof; who wants the numbers reads the JSON.
  arguments.options.quality = !common.json.empty();

  if (common.json == "-" && arguments.junit == "-")
    throw InputError("--json - and --junit -: only one of them fits on standard output");
  if (!arguments.defects.empty()) check_creatable(arguments.defects);
  if (!arguments.junit.empty() && arguments.junit != "-") check_creatable(arguments.junit);
  const auto start = std::chrono::steady_clock::now();
  Loaded loaded = load(arguments.mesh);
  arguments.options.regions = std::move(loaded.regions);
  arguments.options.unjudged = std::move(loaded.unjudged);
  const double reading = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  verify::Report report = judge(loaded.mesh, arguments);
  report.notes.insert(report.notes.begin(), loaded.notes.begin(), loaded.notes.end());
  if (arguments.options.timings) report.seconds.insert(report.seconds.begin(), {"reading", reading});

  if (!arguments.defects.empty())
    verify::write_defects(arguments.defects, loaded.mesh, loaded.numbering, report);
  if (!common.json.empty()) program::write_text(common.json, verify::report_json(report, loaded.numbering));
  if (!arguments.junit.empty())
    program::write_text(arguments.junit, verify::report_junit(report, arguments.mesh, loaded.numbering));
  if (common.json != "-" && arguments.junit != "-")
    program::write_text("-", arguments.mesh + ": " + verify::report_text(report, loaded.numbering));
  return verify::sound(report)       ? program::sound
         : verify::defective(report) ? program::wrong
                                     : program::incomplete;
}

}  // namespace

int main(int argc, char** argv) {
  const program::Description description{
      "Judges a tetrahedral mesh as it is written, whoever made it: is it a valid triangulation of a solid, "
      "decided exactly, and does it fill the surface? Exit code 0: sound, 1: defective, 2: bad input, 3: own "
      "failure, 4: nothing wrong was found, but not everything could be judged.",
      examples,
      {"CGAL " CGAL_VERSION_STR, "OpenVDB " OPENVDB_LIBRARY_VERSION_STRING}};
  return program::run(
      argc, argv, description, [](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto arguments = std::make_shared<Arguments>();
        verify::Options& options = arguments->options;
        app.add_option("MESH", arguments->mesh, "the mesh: .msh, .node/.ele")->always_capture_default(false);
        app.add_option("SURFACE", arguments->surface, "a surface file, or a generated one: sphere:r=1,n=5000")
            ->always_capture_default(false);
        app.add_option("--region", arguments->region,
                       "what of the surface the mesh should fill; inside when a SURFACE is given")
            ->type_name("inside|outside|none")
            ->check(CLI::IsMember({"inside", "outside", "none"}))
            ->always_capture_default(false);
        app.add_option("--fidelity", options.fidelity,
                       "allowed distance between boundary and surface, in units of the surface's box "
                       "diagonal; the allowed volume "
                       "difference is this x diagonal x area; 0: the mesh reproduces the surface exactly")
            ->type_name("D")
            ->check(CLI::NonNegativeNumber);
        app.add_flag("--strict-topology", options.strict_topology,
                     "topology, cavities and non-manifold edges and vertices fail instead of warn (so does "
                     "--fidelity 0)");
        app.add_option("--voxels", options.voxels,
                       "voxels along the longest side for the independent volume account; 0: without")
            ->type_name("N")
            ->check(CLI::Range(0, 1024));
        app.add_option("--check", options.check, "only these checks, by id")
            ->type_name("LIST")
            ->delimiter(',');
        app.add_option("--skip", options.skip, "without these checks, by id")
            ->type_name("LIST")
            ->delimiter(',');
        app.add_flag("--list-checks", arguments->list_checks,
                     "id, what it proves, accuracy and severity of every check");
        app.add_flag("--list-surfaces", arguments->list_surfaces,
                     "the generated surfaces with their parameters");
        app.add_option("--defects", arguments->defects,
                       "write the broken tetrahedra with one ring around them, a cell array named by id for "
                       "each check that found any")
            ->type_name("FILE.vtu")
            ->always_capture_default(false);
        app.add_option("--junit", arguments->junit,
                       "write the verdict as JUnit XML, a test case for each check; - is standard output")
            ->type_name("FILE.xml")
            ->always_capture_default(false);
        app.add_flag("--timings", options.timings, "seconds per phase, in text and JSON");
        return [arguments, &common] { return work(*arguments, common); };
      });
}
