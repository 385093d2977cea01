// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's .msh files. Facts: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format
#pragma once

#include <string>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// Versions 1 to 4.1, text and binary of both byte orders. A reference to a node or element that does not
/// exist is kept as such; sections that are not understood are kept as they stand. Of several elements in one
/// section of .msh 1 or 2 that differ only in their physical group, the first is kept, in all those groups.
/// $NodeData, $ElementData and $ElementNodeData become values of a view; without a real tag (the time), they
/// are values of none. InputError naming the line or byte for all else.
Document read_msh(const InputFile& file);

/// Binary numbers are in this machine's byte order, which the file names.
void write_msh22(AtomicFile& file, const Document& document, bool binary);
void write_msh40(AtomicFile& file, const Document& document);
void write_msh41(AtomicFile& file, const Document& document, bool binary);

/// What a .msh file holds where Gmsh looks for it; `format`: "msh22", "msh40" or "msh41". `document` must
/// outlive what is returned.
Holds msh_holds(const Document& document, const std::string& format, bool binary);

/// Whether a section that was kept as it stood means the same in a file of this kind.
bool keeps_section(const Section& section, const std::string& format, bool binary);

}  // namespace tetproof::io
