// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file of any format: the one way on which documents and surfaces come from files. Inside io only.
#pragma once

#include <string>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// The file at `path`; standard input for "-".
InputFile open_input(const std::string& path);

/// Reads a file in the format that the options, its content or its ending say, in this order. A format of the
/// content that is not that of the ending is a warning of the document, or a note in the error. InputError
/// for a format that is not known, or not read.
ReadDocument read_file(const InputFile& file, const ReadOptions& options, Wanted wanted);

}  // namespace tetproof::io
