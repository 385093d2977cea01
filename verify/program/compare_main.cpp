// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-compare OTHER REFERENCE: compares two traces, decision by decision, or two grids.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/mesh_formats.hpp"
#include "io/program/program.hpp"
#include "io/program/report_losses.hpp"
#include "verify/compare_grids.hpp"
#include "verify/compare_page.hpp"
#include "verify/compare_traces.hpp"
#include "verify/program/check_trace.hpp"
#include "verify/program/compare_inputs.hpp"

namespace {

using namespace tetproof;

constexpr const char* examples =
    R"(  tetproof-compare mine.jsonl reference.jsonl          where do the two traces part, in the paper's words?
  tetproof-compare mine.msh reference.msh              are the grids equal up to numbering?
  tetproof-compare mine.1.ele grid.msh --tolerance 1e-6 --json -
  my-mesher part.stl | tetproof-compare - grid.msh     a grid from standard input
)";

struct Arguments {
  std::string other, reference;
  std::string surface, html;
  double tolerance = 1e-9;
};

verify::NamedGrid load(const std::string& path, const program::Common& common, program::Progress& progress) {
  progress.enter("reading " + path);
  const Document document = read_document(path, {.progress = progress.part_listener()});
  program::report_reading(common, document.warnings, document.dropped);
  return verify::named_grid(path, document);
}

// The reader of traces opens files only.
std::string of_trace(const std::string& path) {
  return path == "-" ? "/dev/stdin" : path;
}

int work(const Arguments& arguments, const program::Common& common) {
  if (!(arguments.tolerance >= 0))
    throw InputError("--tolerance: expected a number from 0 to 0.1, found nan");
  program::FilesInUse files(common);
  files.reads_mesh("OTHER", arguments.other);
  files.reads_mesh("REFERENCE", arguments.reference);
  files.writes("--html", arguments.html);
  const std::optional<bool> other = verify::is_trace(arguments.other),
                            reference = verify::is_trace(arguments.reference);
  const bool traces = reference.value_or(other.value_or(true));
  if (other.value_or(traces) != traces)
    throw InputError((traces ? arguments.reference : arguments.other) + " is a trace, and " +
                     (traces ? arguments.other : arguments.reference) +
                     " is not: two traces or two grids are compared");
  const auto report = [&](const auto& result) {
    if (!common.json.empty()) program::write_text(common.json, verify::comparison_json(result));
    if (!files.standard_output_is_taken()) program::write_text("-", verify::comparison_text(result));
  };
  if (traces) {
    program::Progress progress(common);
    progress.enter("comparing");
    reference::Listener listener;
    if (program::shows_progress(common))
      listener.inserted = [&](std::int64_t made, std::int64_t wanted) {
        progress.at(static_cast<std::uint64_t>(made), static_cast<std::uint64_t>(wanted));
      };
    const verify::TraceComparison result =
        verify::compare_traces(of_trace(arguments.other), of_trace(arguments.reference), arguments.tolerance,
                               [&](const std::string& path) -> verify::CheckedTrace {
                                 if (path == "/dev/stdin")
                                   return {.cannot = "standard input can be read only once"};
                                 if (!std::filesystem::is_regular_file(path))
                                   return {.cannot = "a pipe can be read only once"};
                                 progress.enter("replaying " + path);
                                 return verify::check_trace(path, arguments.surface, listener);
                               });
    progress.end();
    report(result);
    if (!arguments.html.empty()) {
      const std::optional<TriangleSurface> surface =
          verify::surface_of_trace(arguments.reference, arguments.surface);
      if (!surface)
        program::say(common, "the page shows no surface: none was given, and the trace's is not found");
      program::write_text(arguments.html, verify::comparison_page(result, surface ? &*surface : nullptr));
    }
    using Verdict = verify::TraceComparison::Verdict;
    if (result.verdict == Verdict::diverges) return program::wrong;
    return result.verdict == Verdict::unresolved || !result.not_compared.empty() ? program::incomplete
                                                                                 : program::sound;
  }
  program::Progress progress(
      common,
      {{"reading " + arguments.reference, 0.2}, {"reading " + arguments.other, 0.2}, {"comparing", 0.6}});
  const verify::NamedGrid reference_grid = load(arguments.reference, common, progress),
                          other_grid = load(arguments.other, common, progress);
  progress.enter("comparing");
  const verify::GridComparison result =
      verify::compare_grids(other_grid, reference_grid, arguments.tolerance);
  progress.end();
  report(result);
  if (!arguments.html.empty()) program::write_text(arguments.html, verify::comparison_page(result));
  if (!result.equal()) return program::wrong;
  return result.complete() ? program::sound : program::incomplete;
}

}  // namespace

int main(int argc, char** argv) {
  const program::Description description{
      "Compares two traces of the paper's method, as tetproof-mesh --trace writes them, and names the first "
      "decision where they differ; or compares two grids up to numbering. Where two traces part, each is "
      "checked "
      "decision by decision on its surface. Exit code 0: equal, or equal but for proven ties, 1: different, "
      "2: bad "
      "input, 3: own failure, 4: no difference found, but not all could be compared, or two traces part and "
      "it is "
      "not known which of them is wrong.",
      examples,
      {}};
  return program::run(
      argc, argv, description, [](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto arguments = std::make_shared<Arguments>();
        app.add_option("OTHER", arguments->other,
                       "the trace (.jsonl) or the grid in question; - is standard input. Endings of grids: " +
                           program::grid_endings_read())
            ->required()
            ->always_capture_default(false);
        app.add_option("REFERENCE", arguments->reference,
                       "the trace or grid to compare it with; one of the two can be -")
            ->required()
            ->always_capture_default(false);
        app.add_option(
               "--surface", arguments->surface,
               "the surface of the two traces, to check them where they part; if not given, the one that "
               "each of them names")
            ->type_name("FILE")
            ->always_capture_default(false);
        app.add_option(
               "--html", arguments->html,
               "write a page for any browser: where they part, with both choices in three dimensions; - is "
               "standard output")
            ->type_name("FILE.html")
            ->always_capture_default(false);
        app.add_option(
               "--tolerance", arguments->tolerance,
               "points that are closer than this are the same, in diagonals of the reference's box; in "
               "traces, numbers whose relative difference is less are the same, too; 0: equal to the "
               "last bit")
            ->type_name("T")
            ->check(CLI::Range(0.0, 0.1));
        return [arguments, &common] { return work(*arguments, common); };
      });
}
