// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out from names which files are one set to TetGen.
#pragma once

#include <string>
#include <vector>

namespace tetproof::io {

/// A path without its ending, and the ending in lower case: ".ele", ".poly", ".v.cell".
struct TetgenPath {
  std::string path, stem, ending;

  bool is_plc() const { return ending == ".poly" || ending == ".smesh"; }
  /// The path of the set's file with another ending. The file that was named keeps its spelling.
  std::string member(const std::string& other) const { return other == ending ? path : stem + other; }
  /// The paths of several of its files.
  std::vector<std::string> members(const std::vector<std::string>& endings) const {
    std::vector<std::string> paths;
    for (const std::string& other : endings) paths.push_back(member(other));
    return paths;
  }
};
/// The set of a file that is to be written as "tetgen", "poly" or "smesh". An ending that does not belong to
/// that format is part of the name.
TetgenPath tetgen_path_to_write(const std::string& path, const std::string& format);
/// The set of a file that is to be read. NAME.v.node, .v.edge and .v.face belong to a Voronoi diagram if
/// NAME.v.cell exists.
TetgenPath tetgen_path(const std::string& path);

/// Whether a file of this path exists.
bool file_exists(const std::string& path);

}  // namespace tetproof::io
