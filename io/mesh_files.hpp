// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes mesh files of every format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"
#include "io/progress.hpp"

namespace tetproof {

/// A format in which documents are read and written.
struct Format {
  std::string name;  ///< as `--to` takes it
  std::string what;  ///< its name for messages
  /// In lower case with the dot. If several formats have an ending, a file with it is written in the first
  /// one.
  std::vector<std::string> endings;
  /// Endings of files that bring a file of this format which stands beside them. They are only read.
  std::vector<std::string> endings_beside{};
  std::vector<std::string> endings_only_read{};  ///< of files that are never written
  bool reads = false;
  bool ascii = true, binary = true;  ///< the forms in which it can be written
  bool usually_binary = false;       ///< the form in which it is written if none is asked for
  std::string binary_ending;         ///< the one of `endings` that all binary files have, and no others
};

/// All formats: msh41, msh40, msh22, tetgen, poly, smesh, vtu, vtk, medit, stl, off, obj, ply.
const std::vector<Format>& formats();
/// The ending of a path, in lower case and with its dot; empty if there is none.
std::string ending_of(const std::string& path);
/// The endings of all formats, each once. All are read and written; `endings_beside` and
/// `io::gmsh_endings()` are only read.
std::vector<std::string> known_endings();
/// The format in which a file with `path`'s ending is written. InputError, with the known endings, for an
/// unknown one.
const Format& format_of(const std::string& path);
/// The format called `name`. InputError, with the known names, for an unknown one.
const Format& format_named(const std::string& name);

struct WriteOptions {
  std::string format;          ///< a name of `formats()`; empty: the path's ending decides
  std::optional<bool> binary;  ///< not set: text for .msh, binary for .vtu, .vtk, .meshb, .stl and .ply
};

/// The format and form in which a file is written.
struct Encoding {
  std::string format;
  bool binary = false;
};
/// What `options` and the path's ending ask for. InputError if the ending is unknown, or if the format cannot
/// be written in this form.
Encoding encoding_of(const std::string& path, const WriteOptions& options);

/// How a file is read.
struct ReadOptions {
  /// A name of `formats()`, as `--from` takes it: it overrules content and ending. Empty: these two decide.
  std::string format;
  /// Gets "reading" with the bytes done, of files whose readers copy piece by piece: all large ones.
  ProgressListener progress{};
};

/// Reads .msh 1 to 3, 4.0 and 4.1 (text, and binary of both byte orders), TetGen's files (.node and .ele each
/// bring the other), .vtu, .vtk, .mesh, .meshb (a .sol or .solb likewise), surfaces; through Gmsh, what only
/// it reads: `io::gmsh_endings()` in io/gmsh/gmsh_import.hpp. "-" is standard input, which brings no file
/// beside it.
///
/// If the content is clearly that of another format than the ending's, the content decides, and the document
/// has a warning. If there is no ending, or an unknown one, the content decides as well.
///
/// A file is read as it is written if its format permits it: with indices that name no node, NaN,
/// repetitions. Items that the reader does not take are in `Document::dropped`. InputError, with the file's
/// line or byte offset, for what the format does not permit; with the format's name for a foreign format.
Document read_document(const std::string& path, const ReadOptions& options = {});
/// Reads the bytes of a file likewise. No ending tells their format, and no file stands beside them. `name`:
/// for messages.
Document read_document_in_memory(std::string_view bytes, const ReadOptions& options = {},
                                 const std::string& name = "memory");

/// Writes the document whole or not at all. What the format cannot hold is left out: `losses` in
/// io/losses.hpp lists it; and `kept_aside` what stands in a corner of the file for `read_document` alone.
/// InputError when the place cannot be written, or when the format cannot be written in the encoding asked
/// for.
void write_document(const std::string& path, const Document& document, const WriteOptions& options = {});

/// What is worth knowing before `write_document`, besides what is lost: that another program misreads what
/// will be written, that files of an older mesh will stay beside it, or that the other form, text instead of
/// binary, keeps what is lost. Empty: nothing.
std::string write_warning(const std::string& path, const Document& document,
                          const WriteOptions& options = {});

}  // namespace tetproof
