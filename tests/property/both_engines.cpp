// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/property/both_engines.hpp"

#include <algorithm>

#include "tests/support/test_files.hpp"

namespace tetproof::test {
namespace {

using reference::Engine;
using reference::Generation;
using reference::Options;

bool is_of_step_vi(const std::string& line) {
  return line.starts_with("{\"record\":\"insertion\"") || line.starts_with("{\"record\":\"flip\"") ||
         line.starts_with("{\"record\":\"end\"");
}

// The first part of the reports that differs, although the traces are equal.
std::string difference(const Generation& a, const Generation& b) {
  if (a.grid.mesh.points != b.grid.mesh.points) return "the points of the first grid";
  if (a.grid.mesh.tets != b.grid.mesh.tets) return "the tetrahedra of the first grid";
  if (a.grid.on_surface != b.grid.on_surface) return "the surface points of the first grid";
  if (a.grid.rows != b.grid.rows) return "the rows of Table 2";
  if (a.grid.collapsed != b.grid.collapsed) return "the collapsed tetrahedra";
  if (a.table3 != b.table3) return "the rows of Table 3";
  if (a.dropped_intersections != b.dropped_intersections) return "the intersections that Table 3 ignored";
  if (a.moved_to_surface != b.moved_to_surface || a.mended != b.mended) return "the moved lattice vertices";
  if (a.mapped != b.mapped || a.not_mapped != b.not_mapped) return "the mapped points";
  if (a.not_positive != b.not_positive) return "the tetrahedra that are not positive";
  if (a.adaptation.has_value() != b.adaptation.has_value()) return "whether the grid was adapted";
  if (!a.adaptation) return "";
  if (a.mesh().points != b.mesh().points) return "the points of the last grid";
  if (a.mesh().tets != b.mesh().tets) return "the tetrahedra of the last grid";
  if (a.adaptation->on_surface != b.adaptation->on_surface) return "the surface points of the last grid";
  if (a.adaptation->rows != b.adaptation->rows) return "the rows of Table 4";
  if (a.adaptation->left != b.adaptation->left) return "the new points that were left in place";
  return "";
}

std::string line_or_end(const EngineRun& run, std::size_t line) {
  return line < run.lines.size() ? run.lines[line] : "nothing";
}

}  // namespace

EngineRun run_engine(const TriangleSurface& surface, Options options, Engine engine) {
  EngineRun run;
  options.engine = engine;
  options.listener.record = [&run](const trace::Record& record) {
    run.lines.push_back(trace::to_line(record));
  };
  try {
    run.made = reference::generate(surface, options);
  } catch (const InputError& error) {
    run.refusal = error.what();
  }
  return run;
}

BothEngines run_both(const TriangleSurface& surface, const Options& options) {
  BothEngines both{.fast = run_engine(surface, options, Engine::fast),
                   .page = run_engine(surface, options, Engine::paper)};
  const EngineRun &fast = both.fast, &page = both.page;
  if (fast.refusal != page.refusal) {
    both.fault = "the fast engine says '" + fast.refusal + "', the page '" + page.refusal + "'";
    return both;
  }
  const auto [at_fast, at_page] =
      std::mismatch(fast.lines.begin(), fast.lines.end(), page.lines.begin(), page.lines.end());
  both.equal_lines = static_cast<std::size_t>(at_fast - fast.lines.begin());
  if (at_fast == fast.lines.end() && at_page == page.lines.end()) {
    const std::string other = difference(fast.made, page.made);
    both.equal = other.empty();
    if (!both.equal) both.fault = "the traces are equal, but not " + other;
    return both;
  }
  const std::string parts =
      "\nfast: " + line_or_end(fast, both.equal_lines) + "\npage: " + line_or_end(page, both.equal_lines);
  if (!is_of_step_vi(line_or_end(fast, both.equal_lines)) ||
      !is_of_step_vi(line_or_end(page, both.equal_lines))) {
    both.fault = "the first grids differ" + parts;
    return both;
  }
  const TestFiles files;
  std::string text =
      trace::to_line(reference::settings_of(options, static_cast<bool>(surface.evaluate))) + '\n';
  for (const std::string& line : page.lines) text += line + '\n';
  Options replay = options;
  replay.follow = files.write("page.jsonl", text);
  const reference::Follow follow = reference::generate(surface, replay).follow.value();
  both.ties = follow.ties;
  if (!follow.admissible)
    both.fault = "step (vi) differs, and line " + std::to_string(follow.line) +
                 " of the page is not admissible: " + follow.what + parts;
  else if (follow.ties == 0)
    both.fault = "step (vi) differs, and its replay finds no tie" + parts;
  return both;
}

}  // namespace tetproof::test
