// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program on a surface, classes its end and reads its mesh.
#include "corpus/meshing/tool_mesher.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/end_class.hpp"
#include "corpus/meshing/output_lines.hpp"
#include "corpus/meshing/process.hpp"
#include "corpus/meshing/surface_input.hpp"
#include "corpus/meshing/text_digits.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/tetgen/tetgen.hpp"

namespace tetproof::corpus {

namespace {

using Eigen::Vector3d;

double diagonal(const TriangleSurface& surface) {
  if (surface.vertices.empty()) return 0;
  Vector3d low = surface.vertices[0], high = low;
  for (const Vector3d& v : surface.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).norm();
}

/// The solid's volume, up to rounding: it only sets a size.
double volume(const TriangleSurface& surface) {
  double six = 0;
  for (const auto& t : surface.triangles) {
    const auto corner = [&](std::size_t k) -> Vector3d {
      return surface.vertices[static_cast<std::size_t>(t[k])] - surface.vertices[0];
    };
    six += corner(0).cross(corner(1)).dot(corner(2));
  }
  return std::abs(six) / 6;
}

/// A mesh of an earlier run must not be taken for this one's.
void remove_old(const std::string& mesh) {
  std::error_code ignored;
  std::filesystem::remove(mesh, ignored);
  const std::string ending = ending_of(mesh);
  if (ending != ".ele" && ending != ".node") return;
  const std::string stem = mesh.substr(0, mesh.size() - ending.size());
  for (const char* other : {".node", ".ele", ".face", ".edge", ".neigh", ".smesh"})
    std::filesystem::remove(stem + other, ignored);
}

class ToolMesher : public Mesher {
 public:
  explicit ToolMesher(Tool tool) : tool_(std::move(tool)) {}

  MesherRun run(const TriangleSurface& surface, const std::string& given_folder,
                const Limits& limits) const override {
    const std::string folder = std::filesystem::absolute(given_folder).string();
    MesherRun run;
    run.mesh_file = folder + "/" + tool_.mesh_file;
    run.program = tool_.program;
    remove_old(run.mesh_file);
    SurfaceInput input;
    try {
      input = write_surface_input(folder + "/surface", tool_.surface_ending, surface);
    } catch (const NoPointInCavity& reason) {  // nothing is said of the mesher, and the campaign goes on
      run.failure = Outcome::not_judged;
      run.signature = "its format cannot hold the surface";
      run.message = reason.what();
      return run;
    }
    run.given = input.given;
    const Placeholders values = placeholders(surface, input.files[0], run.mesh_file);
    std::vector<std::string> command = replaced(tool_.words, values);
    if (!tool_.program.empty()) command[0] = tool_.program;

    ProcessOptions options;
    options.folder = folder;
    options.limits = limits;
    options.environment = tool_.environment;
    ProcessEnd end = run_process(command, options);
    if (!end.started) throw InputError(end.output.substr(0, end.output.find('\n')));
    run.cpu_s = end.cpu_s;
    run.wall_s = end.wall_s;
    run.peak_mb = end.peak_mb;

    if (end.exit_code != 0 && end.exit_code == tool_.partly_judged_exit) end.exit_code = 0;
    EndClass found = classify_end(end);
    const bool gave_up = found.failure == Outcome::refused || found.failure == Outcome::refused_valid;
    if (gave_up && end.exit_code == tool_.own_verdict_exit) says_no(end, found);
    if (gave_up && end.exit_code == tool_.own_failure_exit) found.failure = Outcome::crashed;
    if (found.wants_backtrace) add_backtrace(command, options, found);
    run.failure = found.failure;
    run.signature = std::move(found.signature);
    run.message = std::move(found.message);
    run.warnings = std::move(found.warnings);
    run.output = std::move(end.output);
    if (!run.failure) read_mesh(surface, run);
    return run;
  }

  std::string name() const override { return tool_.name; }
  std::string command() const override { return command_line(tool_.words); }
  std::string version() const override { return tool_.version; }
  std::string surface_ending() const override { return tool_.surface_ending; }
  bool may_change_boundary() const override { return tool_.may_change_boundary; }
  double fidelity() const override { return tool_.fidelity; }
  int repeats() const override { return tool_.repeats; }
  bool coarse() const override { return tool_.coarse; }

 private:
  // It judged its own mesh, and says that it is none: it gave up, and its words are not about the surface.
  static void says_no(const ProcessEnd& end, EndClass& found) {
    found.failure = Outcome::refused;
    found.signature = found.message = "its own verdict";
    for (const std::string& line : output_lines(end.output))
      if (says(line, "defective: ") || says(line, "empty")) {
        found.signature += ": " + without_numbers(line.substr(0, line.find(';')));
        found.message = line;
        return;
      }
  }

  void read_mesh(const TriangleSurface& surface, MesherRun& run) const {
    const auto fail = [&run](Outcome outcome, std::string signature, std::string message) {
      run.failure = outcome;
      run.signature = std::move(signature);
      run.message = std::move(message);
    };
    std::error_code error;
    if (!std::filesystem::is_regular_file(run.mesh_file, error)) {
      std::string line;  // what it said instead, if anything
      for (const std::string& l : output_lines(run.output))
        if (says(l, "error") || says(l, "fail")) line = l;
      return fail(Outcome::no_output, line.empty() ? "no file" : "no file: " + without_numbers(line),
                  line.empty() ? "exit code 0, and there is no " + tool_.mesh_file : line);
    }
    try {
      const auto document = std::make_shared<const Document>(read_document(run.mesh_file));
      run.mesh = tet_mesh(*document);
      run.numbering = numbering(*document);
      run.document = document;
    } catch (const InputError& reason) {
      return fail(Outcome::unreadable, without_numbers(reason.what()), reason.what());
    } catch (const std::bad_alloc&) {
      return fail(Outcome::unreadable, "out of memory while reading",
                  "the file asks for more memory than there is");
    }
    // Other readers take what the first line announces, and see another mesh than its writer.
    for (const Loss& loss : run.document->dropped)
      if (loss.item == io::lines_behind_those_announced)
        return fail(Outcome::unreadable, loss.item,
                    fmt::format("{}: {}", tool_.mesh_file, io::counted(loss.count, loss.item)));
    if (run.mesh.tets.empty())
      return fail(Outcome::no_tetrahedra, "no tetrahedra",
                  fmt::format("exit code 0, and {} has {} points and no tetrahedra", tool_.mesh_file,
                              run.mesh.points.size()));
    run.digits = tool_.digits >= 0
                     ? tool_.digits
                     : coordinate_digits(run.mesh_file, run.mesh, run.given ? *run.given : surface);
  }

  Tool tool_;
};

}  // namespace

Placeholders placeholders(const TriangleSurface& surface, const std::string& surface_file,
                          const std::string& mesh_file) {
  const double box = diagonal(surface);
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  return {{"{surface}", surface_file},
          {"{mesh}", mesh_file},
          {"{box}", number(box)},
          {"{size}", number(box / 12)},
          {"{distance}", number(box * 4e-4)},
          {"{volume}", number(volume(surface) / 200)}};
}

std::unique_ptr<Mesher> tool_mesher(Tool tool) {
  return std::make_unique<ToolMesher>(std::move(tool));
}

}  // namespace tetproof::corpus
