// SPDX-License-Identifier: GPL-3.0-or-later
// Which files TetGen takes to be one set, by their names.
#pragma once

#include <string>

namespace tetproof::io {

/// A path without its ending, and the ending in lower case: ".ele", ".poly", ".v.cell".
struct TetgenPath {
  std::string path, stem, ending;

  bool is_plc() const { return ending == ".poly" || ending == ".smesh"; }
  /// The member of the set with another ending, or this one as it was named.
  std::string member(const std::string& other) const { return other == ending ? path : stem + other; }
};
/// The set of a file to be written as "tetgen", "poly" or "smesh": an ending that is none of that format's is
/// part of the name.
TetgenPath tetgen_path_to_write(const std::string& path, const std::string& format);
/// `.node`, `.edge` and `.face` behind a `.v` are of a Voronoi diagram if there is a `.v.cell` too.
TetgenPath tetgen_path(const std::string& path);

/// Whether there is a file.
bool file_exists(const std::string& path);

}  // namespace tetproof::io
