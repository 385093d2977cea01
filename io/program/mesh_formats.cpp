// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/mesh_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/document.hpp"
#include "io/error.hpp"
#include "io/gmsh/gmsh_import.hpp"
#include "io/tet_mesh.hpp"
#include "io/writing.hpp"

namespace tetproof::program {
namespace {

Document smallest_grid() {
  return document_of(TetMesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tets = {{0, 1, 2, 3}}});
}

bool names_tetrahedra(const std::vector<Loss>& losses) {
  return std::any_of(losses.begin(), losses.end(),
                     [](const Loss& loss) { return loss.item.starts_with("tetrahedra"); });
}

// Whether any reader of the file gets the tetrahedra. A .poly keeps them in comments, for our reader alone.
// Of TetGen's set a .vol, for example, is not written for a grid.
bool holds_tetrahedra(const std::string& path) {
  const Document grid = smallest_grid();
  PlannedFile file(path, grid);
  if (names_tetrahedra(file.losses()) || names_tetrahedra(file.kept_aside().items)) return false;
  const std::vector<std::string> written = file.files();
  return std::find(written.begin(), written.end(), path) != written.end();
}

std::string tetrahedra_endings() {
  std::vector<std::string> endings = known_endings();
  std::erase_if(endings, [](const std::string& ending) { return !holds_tetrahedra("grid" + ending); });
  return fmt::format("{}", fmt::join(endings, " "));
}

}  // namespace

void check_holds_tetrahedra(const std::string& path) {
  if (holds_tetrahedra(path)) return;
  std::string what = format_of(path).what;
  if (what.ends_with(" surface")) what.resize(what.size() - std::string(" surface").size());
  if (format_of(path).name == "tetgen") what = "TetGen " + ending_of(path);
  throw InputError(
      fmt::format("{}: {} holds no tetrahedra; expected one of {}", path, what, tetrahedra_endings()));
}

std::string grid_endings_written() {
  return tetrahedra_endings();
}

std::string grid_endings_read() {
  return fmt::format("{}; through Gmsh: {}", tetrahedra_endings(), fmt::join(io::gmsh_endings(), " "));
}

std::string endings_read() {
  std::vector<std::string> endings = known_endings(), beside;
  for (const Format& format : formats()) {
    endings.insert(endings.end(), format.endings_only_read.begin(), format.endings_only_read.end());
    beside.insert(beside.end(), format.endings_beside.begin(), format.endings_beside.end());
  }
  return fmt::format("{}; beside their mesh {}; through Gmsh: {}", fmt::join(endings, " "),
                     fmt::join(beside, " "), fmt::join(io::gmsh_endings(), " "));
}

std::vector<std::string> format_list() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  return names;
}

std::string format_names() {
  return fmt::format("{}", fmt::join(format_list(), ", "));
}

}  // namespace tetproof::program
