// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files of every format, by their endings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof {

/// A format that a document can be read from or written to.
struct Format {
  std::string name;  ///< as `--to` takes it
  std::string what;  ///< one line
  std::vector<std::string>
      endings;  ///< lower case with the dot; of a file named to be written, the first format wins
  bool reads = false;
  bool ascii = true, binary = true;  ///< which of the two it can be written in
  bool usually_binary = false;       ///< which of them it is unless one is asked for
  std::string binary_ending;         ///< of `endings`, the one that binary files have, and no others
};

/// All formats: msh41, msh40, msh22, tetgen, vtu, vtk, medit, stl, off, obj, ply.
const std::vector<Format>& formats();
/// The ending of a path, in lower case and with its dot; empty if there is none.
std::string ending_of(const std::string& path);
/// Their endings, each once. All are read as well as written, and beside them `io::gmsh_endings()` are read.
std::vector<std::string> known_endings();
/// The format that `path`'s ending stands for when it is written. InputError naming the known endings.
const Format& format_of(const std::string& path);
/// The format called `name`. InputError naming the known ones.
const Format& format_named(const std::string& name);

struct WriteOptions {
  std::string format;          ///< a name of `formats()`; empty: by the path's ending
  std::optional<bool> binary;  ///< not set: ASCII for .msh, binary for .vtu, .vtk, .meshb, .stl and .ply
};

/// What `options` and the path's ending come to. InputError when the ending says nothing, or the format
/// cannot be written so.
struct Encoding {
  std::string format;
  bool binary = false;
};
Encoding encoding_of(const std::string& path, const WriteOptions& options);

/// How a file is read.
struct ReadOptions {
  /// A name of `formats()`, as `--from` takes it: it overrules the content and the ending. Empty: these two
  /// decide.
  std::string format;
};

/// Reads .msh 1 to 3, 4.0 and 4.1 (ASCII, and binary of both byte orders), TetGen's .node and .ele (either
/// brings the other), .vtu, .vtk, .mesh, .meshb, surfaces, and through Gmsh what only it reads:
/// `io::gmsh_endings()` in io/gmsh/gmsh_import.hpp. What the format permits is read as it is written: indices
/// that name no node, NaN, repetitions. InputError, with the file's line or byte offset, for what it does not
/// permit.
Document read_document(const std::string& path, const ReadOptions& options = {});

/// Writes the document whole or not at all. What the format cannot hold is left out: `losses` in
/// io/losses.hpp lists it; and `kept_aside` what stands in a corner of the file for `read_document` alone.
/// InputError when the place cannot be written, or when the format cannot be written in the encoding asked
/// for.
void write_document(const std::string& path, const Document& document, const WriteOptions& options = {});

/// What is worth knowing before `write_document`, though nothing is lost: that another program misreads what
/// will be written, or that files of an older mesh will stay beside it. Empty: nothing.
std::string write_warning(const std::string& path, const Document& document,
                          const WriteOptions& options = {});

}  // namespace tetproof
