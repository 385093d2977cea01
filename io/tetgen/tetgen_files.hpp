// SPDX-License-Identifier: GPL-3.0-or-later
// Names the files of TetGen's that one path brings, in reading and in writing.
#pragma once

#include <string>
#include <vector>

namespace tetproof::io {

/// The files that `read_tetgen(path)` reads: the one named and, of its set, those that exist.
std::vector<std::string> tetgen_files_read(const std::string& path);

/// The files that are written whatever the document holds. `format`: "tetgen", "poly" or "smesh".
std::vector<std::string> tetgen_files_always_written(const std::string& path, const std::string& format);

}  // namespace tetproof::io
