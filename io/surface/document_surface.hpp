// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a document: its faces, welded and cut into triangles, whatever the format was.
#pragma once

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// `surface_of(read.document)`, see io/document.hpp. The points are moved out of the document. An error names
/// the element's line or byte in `file` where `read.places` tells it. `numbering` gets the file's numbers,
/// `warnings` what is not planar.
TriangleSurface surface_of_read(ReadDocument&& read, const InputFile& file, SurfaceNumbering& numbering,
                                std::vector<std::string>& warnings);

}  // namespace tetproof::io
