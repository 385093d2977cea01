// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-verify MESH [SURFACE]: judges a tetrahedral mesh, and whether it fills a surface.
#include <fmt/format.h>

#include <CGAL/version.h>
#include <openvdb/version.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "corpus/surfaces.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "io/program/report_losses.hpp"
#include "verify/defects.hpp"
#include "verify/report_page.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;

constexpr const char* examples =
    R"(  tetproof-verify grid.msh                        is it a valid triangulation?
  tetproof-verify grid.1.ele bunny.off            and does it fill the surface?
  tetproof-verify air.msh car.stl --region outside
  tetproof-verify tetgen.1.node part.stl --fidelity 0 --json -
  tetproof-verify grid.msh --junit grid.xml       for a CI system
  my-mesher part.stl | tetproof-verify - part.stl --from vtk
)";

struct Arguments {
  std::string mesh, surface, region, defects, junit, html;
  ReadOptions mesh_read, surface_read;
  verify::Options options;
  bool list_checks = false, list_surfaces = false;
};

struct Loaded {
  TetMesh mesh;
  Numbering numbering;
  TetRegions regions;
  verify::Unjudged unjudged;
};

// Each phase's share of the whole time, measured on a grid of ct_skull.off with 780,000 tetrahedra.
std::vector<std::pair<std::string, double>> phase_shares(bool with_surface) {
  if (!with_surface)
    return {{"reading", 0.1}, {"points", 0.03}, {"tetrahedra", 0.12}, {"volume", 0.07}, {"boundary", 0.65}};
  return {{"reading", 0.01},
          {"reading the surface", 0.01},
          {"judging the surface", 0.09},
          {"points", 0.01},
          {"tetrahedra", 0.05},
          {"volume", 0.02},
          {"boundary", 0.19},
          {"voxels", 0.04},
          {"distances", 0.52},
          {"missing and excess regions", 0.06}};
}

// The document, which may be many times as large, is gone before the judge starts.
Loaded load(const Arguments& arguments, const program::Common& common) {
  const Document document = read_document(arguments.mesh, arguments.mesh_read);
  program::report_reading(common, document.warnings, document.dropped);
  Loaded loaded{tet_mesh(document), numbering(document), tet_regions(document), verify::unjudged(document)};
  if (loaded.mesh.tets.empty()) {
    std::string others;
    for (const auto* entries : {&loaded.unjudged.elements, &loaded.unjudged.unread})
      for (const verify::NotJudged& entry : *entries)
        others += (others.empty() ? ", but " : ", ") + io::counted(entry.count, entry.what);
    throw InputError(arguments.mesh + ": holds no tetrahedra" + others);
  }
  return loaded;
}

// The surface is kept for the page.
verify::Report judge(const TetMesh& mesh, Arguments& arguments, const program::Common& common,
                     program::Progress& progress, TriangleSurface& kept) {
  arguments.options.progress = progress.listener();
  if (arguments.surface.empty()) return verify::verify(mesh, arguments.options);
  progress.enter("reading the surface");
  SurfaceFile file = corpus::open_surface_file(arguments.surface, arguments.surface_read);
  program::report_reading(common, file.warnings, file.dropped);
  verify::add_unread_surface(arguments.options.unjudged, file.dropped);
  progress.enter("judging the surface");
  try {
    kept = std::move(file.surface);
    const verify::JudgedSurface surface(kept, std::move(file.numbering));
    return verify::verify(mesh, surface, arguments.options);
  } catch (const InputError& error) {
    throw InputError(arguments.surface + ": " + error.what());
  }
}

// Declares the run's files, and refuses outputs that could not be written after the work.
program::FilesInUse files_of(const Arguments& arguments, const program::Common& common) {
  program::FilesInUse files(common);
  files.reads_mesh("MESH", arguments.mesh, arguments.mesh_read);
  const bool reads_surface = !arguments.surface.empty() && !corpus::is_generated(arguments.surface);
  if (reads_surface) files.reads_mesh("SURFACE", arguments.surface, arguments.surface_read);
  if (!reads_surface && !arguments.surface_read.format.empty())
    throw InputError("--surface-from needs a SURFACE that is a file");
  if (!arguments.defects.empty()) program::check_holds_tetrahedra(arguments.defects);
  files.writes_mesh("--defects", arguments.defects, {});
  files.writes("--junit", arguments.junit);
  files.writes("--html", arguments.html);
  return files;
}

int work(const Arguments& given, const program::Common& common) {
  if (given.list_checks || given.list_surfaces) {
    program::write_text("-", given.list_checks ? verify::list_checks() : corpus::list_surfaces());
    return program::sound;
  }
  if (given.mesh.empty()) throw InputError("MESH is required (see tetproof-verify --help)");
  Arguments arguments = given;
  for (const auto* ids : {&arguments.options.check, &arguments.options.skip, &arguments.options.allow})
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

  // Measuring costs half as much as the proof. The measurements are printed as JSON and in the page only.
  arguments.options.quality = !common.json.empty() || !arguments.html.empty();

  program::FilesInUse files = files_of(arguments, common);
  program::Progress progress(common, phase_shares(!arguments.surface.empty()));
  progress.enter("reading");
  arguments.mesh_read.progress = arguments.surface_read.progress = progress.part_listener();
  const auto start = std::chrono::steady_clock::now();
  Loaded loaded = load(arguments, common);
  arguments.options.regions = std::move(loaded.regions.of_tet);
  arguments.options.region_tags = std::move(loaded.regions.tags);
  arguments.options.unjudged = std::move(loaded.unjudged);
  const double reading = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  TriangleSurface surface;
  verify::Report report = judge(loaded.mesh, arguments, common, progress, surface);
  if (arguments.options.timings) report.seconds.insert(report.seconds.begin(), {"reading", reading});

  progress.enter("writing");
  if (!arguments.defects.empty()) {
    const Document defects = verify::defects_document(loaded.mesh, loaded.numbering, report);
    program::MeshOutput(common, files, "--defects", arguments.defects, defects).write();
  }
  if (!common.json.empty()) program::write_text(common.json, verify::report_json(report, loaded.numbering));
  if (!arguments.junit.empty())
    program::write_text(arguments.junit, verify::report_junit(report, arguments.mesh, loaded.numbering));
  if (!arguments.html.empty()) {
    progress.enter("writing the page");
    program::write_text(
        arguments.html,
        verify::report_page(report, {.mesh = loaded.mesh,
                                     .numbering = loaded.numbering,
                                     .mesh_name = arguments.mesh,
                                     .surface = arguments.surface.empty() ? nullptr : &surface,
                                     .surface_name = arguments.surface,
                                     .regions = arguments.options.regions,
                                     .region_tags = arguments.options.region_tags}));
  }
  progress.end();
  if (!files.standard_output_is_taken())
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
      {"CGAL " CGAL_VERSION_STR, "OpenVDB " OPENVDB_LIBRARY_VERSION_STRING},
      {{"--check", verify::check_ids()},
       {"--skip", verify::check_ids()},
       {"--allow", {"crack", "non-conforming-interface"}}}};
  return program::run(
      argc, argv, description, [](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto arguments = std::make_shared<Arguments>();
        verify::Options& options = arguments->options;
        app.add_option("MESH", arguments->mesh,
                       "the mesh; - is standard input. Endings: " + program::grid_endings_read())
            ->always_capture_default(false);
        app.add_option("SURFACE", arguments->surface,
                       fmt::format("a surface file, or a generated surface as in sphere:r=1,n=5000; - is "
                                   "standard input. Endings: {}",
                                   fmt::join(known_endings(), " ")))
            ->always_capture_default(false);
        app.add_option(
               "--from", arguments->mesh_read.format,
               "read MESH as this format, whatever its ending and content say: " + program::format_names())
            ->type_name("FORMAT");
        app.add_option("--surface-from", arguments->surface_read.format, "the same for SURFACE")
            ->type_name("FORMAT");
        app.add_option("--region", arguments->region,
                       "the part of space that the mesh should fill; inside when a SURFACE is given")
            ->type_name("inside|outside|none")
            ->check(CLI::IsMember({"inside", "outside", "none"}))
            ->always_capture_default(false);
        app.add_option("--fidelity", options.fidelity,
                       "allowed distance between boundary and surface, in units of the surface's box "
                       "diagonal; the allowed volume difference is this x diagonal x area, and at most a "
                       "quarter of the surface's volume; 0: the mesh reproduces the surface exactly")
            ->type_name("D")
            ->check(CLI::NonNegativeNumber);
        app.add_flag("--strict-topology", options.strict_topology,
                     "findings of topology, cavities and non-manifold edges and vertices are failures, not "
                     "warnings; so they are with --fidelity 0");
        app.add_option(
               "--voxels", options.voxels,
               "voxels along the longest side for the second, independent measurement of the volume; 0: none")
            ->type_name("N")
            ->check(CLI::Range(0, 1024));
        // One word holds the list: the next one is a MESH.
        app.add_option("--check", options.check, "only these checks, by id, as in flat,inverted")
            ->type_name("LIST")
            ->delimiter(',')
            ->allow_extra_args(false);
        app.add_option("--skip", options.skip, "all checks except these, by id")
            ->type_name("LIST")
            ->delimiter(',')
            ->allow_extra_args(false);
        app.add_option("--allow", options.allow,
                       "checks whose findings are meant: crack, non-conforming-interface, for models of "
                       "fracture and contact. What they and their consequences find is a warning, and the "
                       "certificate holds except for it")
            ->type_name("LIST")
            ->delimiter(',')
            ->allow_extra_args(false);
        app.add_flag("--only-tets", options.only_tets,
                     "judge the tetrahedra alone: elements of other shapes are named as left out, and do not "
                     "make the verdict incomplete");
        app.add_flag("--list-checks", arguments->list_checks,
                     "print the id of every check, what it proves, its accuracy and its severity");
        app.add_flag("--list-surfaces", arguments->list_surfaces,
                     "print the generated surfaces with their parameters");
        app.add_option(
               "--defects", arguments->defects,
               "write the broken tetrahedra with one ring around them, and a cell array for each check "
               "that found any, named by its id. Endings: " +
                   program::grid_endings_written())
            ->type_name("FILE.vtu")
            ->always_capture_default(false);
        app.add_option("--junit", arguments->junit,
                       "write the verdict as JUnit XML, a test case for each check; - is standard output")
            ->type_name("FILE.xml")
            ->always_capture_default(false);
        app.add_option("--html", arguments->html,
                       "write a page for any browser, without a network: findings, checks, measures, and the "
                       "mesh with its defects in three dimensions; - is standard output")
            ->type_name("FILE.html")
            ->always_capture_default(false);
        app.add_flag("--timings", options.timings, "seconds per phase, in text and JSON");
        return [arguments, &common] { return work(*arguments, common); };
      });
}
