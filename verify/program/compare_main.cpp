// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-compare OTHER REFERENCE: where two traces part, or what two grids do not share.
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/program/program.hpp"
#include "verify/compare_grids.hpp"
#include "verify/compare_traces.hpp"

namespace {

using namespace tetproof;

constexpr const char* examples =
    R"(  tetproof-compare mine.jsonl reference.jsonl          where do the two traces part, in the paper's words?
  tetproof-compare mine.msh reference.msh              are the grids equal up to numbering?
  tetproof-compare mine.1.ele grid.msh --tolerance 1e-6 --json -
)";

struct Arguments {
  std::string other, reference;
  double tolerance = 1e-9;
};

// By the ending; a file with another ending may still begin as a trace does. What a pipe holds is not known
// before it is read.
std::optional<bool> is_trace(const std::string& path) {
  if (path.ends_with(".jsonl")) return true;
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status))
    return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  char first = ' ';
  file >> first;  // past blanks
  return first == '{';
}

verify::NamedGrid load(const std::string& path) {
  const Document document = read_document(path);
  verify::NamedGrid grid{path, tet_mesh(document), numbering(document)};
  if (grid.mesh.tets.empty()) throw InputError(path + ": holds no tetrahedra");
  return grid;
}

int work(const Arguments& arguments, const program::Common& common) {
  if (!(arguments.tolerance >= 0))
    throw InputError("--tolerance: expected a number from 0 to 0.1, found nan");
  const std::optional<bool> other = is_trace(arguments.other), reference = is_trace(arguments.reference);
  const bool traces = reference.value_or(other.value_or(true));
  if (other.value_or(traces) != traces)
    throw InputError((traces ? arguments.reference : arguments.other) + " is a trace, and " +
                     (traces ? arguments.other : arguments.reference) +
                     " is not: two traces or two grids are compared");
  const auto report = [&](const auto& result) {
    if (!common.json.empty()) program::write_text(common.json, verify::comparison_json(result));
    if (common.json != "-") program::write_text("-", verify::comparison_text(result));
  };
  if (traces) {
    program::Progress progress(common, {{"comparing", 1}});
    progress.enter("comparing");
    const verify::TraceComparison result =
        verify::compare_traces(arguments.other, arguments.reference, arguments.tolerance);
    progress.end();
    report(result);
    return result.verdict == verify::TraceComparison::Verdict::diverges ? program::wrong : program::sound;
  }
  program::Progress progress(common, {{"reading", 0.7}, {"comparing", 0.3}});
  progress.enter("reading");
  const verify::NamedGrid reference_grid = load(arguments.reference), other_grid = load(arguments.other);
  progress.enter("comparing");
  const verify::GridComparison result =
      verify::compare_grids(other_grid, reference_grid, arguments.tolerance);
  progress.end();
  report(result);
  return result.equal() ? program::sound : program::wrong;
}

}  // namespace

int main(int argc, char** argv) {
  const program::Description description{
      "Compares two traces of the paper's method (as tetproof-mesh --trace writes them) and names the first "
      "decision where "
      "they differ, or two grids up to numbering. Exit code 0: equal, or parted where two choices tie or "
      "rounding decides, 1: "
      "different, 2: bad "
      "input, 3: own failure.",
      examples,
      {}};
  return program::run(
      argc, argv, description, [](CLI::App& app, program::Common& common) -> std::function<int()> {
        auto arguments = std::make_shared<Arguments>();
        app.add_option("OTHER", arguments->other, "the trace (.jsonl) or grid (.msh, .node/.ele) in question")
            ->required()
            ->always_capture_default(false);
        app.add_option("REFERENCE", arguments->reference, "the one to compare it with")
            ->required()
            ->always_capture_default(false);
        app.add_option("--tolerance", arguments->tolerance,
                       "points closer than this, in diagonals of the reference's box, are the same; of "
                       "traces also the relative "
                       "difference of numbers that are the same; 0: equal to the last bit")
            ->type_name("T")
            ->check(CLI::Range(0.0, 0.1));
        return [arguments, &common] { return work(*arguments, common); };
      });
}
