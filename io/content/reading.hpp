// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file of any format: the one way on which documents and surfaces come from files. Inside io only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::io {

/// What a reader is asked for: everything in the file, or only the part that a TriangleSurface takes, with
/// the places of the elements where the reader knows them. Readers of mesh formats read everything in both
/// cases.
enum class Wanted { document, surface };

/// A document as its reader gives it.
struct ReadDocument {
  Document document;
  /// The byte at which each element starts, if a surface is wanted and the reader knows them; else empty.
  std::vector<std::size_t> places{};
  bool text = true;     ///< a message tells a place as a line; else as a byte
  bool welded = false;  ///< no two points are equal
};

/// The file at `path`; standard input for "-".
InputFile open_input(const std::string& path);

/// Reads a file in the format that the options, its content or its ending say, in this order. A format of the
/// content that is not that of the ending is a warning of the document. InputError for a format that is not
/// known, or not read.
ReadDocument read_file(const InputFile& file, const ReadOptions& options, Wanted wanted);

/// Reads a file of the format with this name in `formats()`.
ReadDocument read_as(const std::string& format, const InputFile& file, Wanted wanted);

}  // namespace tetproof::io
