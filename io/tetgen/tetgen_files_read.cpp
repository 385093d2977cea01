// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "io/error.hpp"
#include "io/tetgen/tetgen_files.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"
#include "io/tetgen/tetgen_set.hpp"

namespace tetproof::io {
namespace {

// Whether a .poly or .smesh leaves its points to the .node. Only files are looked into: what a pipe holds can
// be read once.
bool has_no_points(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  try {
    const InputFile file(path);
    Document unused;
    Records records(file, unused);
    return read_node_header(records).count == 0;
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

}  // namespace

std::vector<std::string> tetgen_files_read(const std::string& path) {
  const TetgenPath set = tetgen_path(path);
  std::vector<std::string> endings{".edge", ".mtr", ".var"};
  if (!set.is_plc()) {
    endings.insert(endings.end(), {".node", ".ele", ".face", ".neigh", ".t2f", ".t2e", ".f2e", ".vol"});
    if (file_exists(set.stem + ".v.cell") || set.ending.starts_with(".v."))
      endings.insert(endings.end(), {".v.node", ".v.edge", ".v.face", ".v.cell"});
  } else if (has_no_points(path)) {
    endings.push_back(".node");
  }
  std::vector<std::string> files{path};
  for (const std::string& ending : endings)
    if (ending != set.ending && file_exists(set.stem + ending)) files.push_back(set.stem + ending);
  return files;
}

}  // namespace tetproof::io
