// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/program/compare_inputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "io/error.hpp"

namespace tetproof::verify {
namespace {

// The cells of a grid that a comparison of tetrahedra leaves out.
Loss other_cells(const Document& document) {
  Loss others{.item = "cells that are no tetrahedra", .count = 0, .example = "", .elements = true};
  for (const ElementBlock& block : document.blocks) {
    if (!has_other_cells(block)) continue;
    if (others.count == 0) others.example = fmt::format("element {}", document.element_tag(block.first));
    others.count += static_cast<std::int64_t>(block.count);
  }
  return others;
}

}  // namespace

std::optional<bool> is_trace(const std::string& path) {
  if (path == "-") return std::nullopt;
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

NamedGrid named_grid(const std::string& path, const Document& document) {
  NamedGrid grid{path, tet_mesh(document), numbering(document), document.dropped};
  if (grid.mesh.tets.empty()) throw InputError(path + ": holds no tetrahedra");
  if (const Loss others = other_cells(document); others.count > 0) grid.not_compared.push_back(others);
  return grid;
}

}  // namespace tetproof::verify
