// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's .msh files. Facts: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"

namespace tetproof::io {

/// Versions 1 to 4.1, text and binary of both byte orders. A reference to a node or element that does not
/// exist is kept as such; sections that are not understood are kept as they stand. Of several elements in one
/// section of .msh 1 or 2 that differ only in their physical group, the first is kept, in all those groups.
/// $NodeData, $ElementData and $ElementNodeData become values of a view; without a real tag (the time), they
/// are values of none. InputError naming the line or byte for all else.
Document read_msh(const InputFile& file);

/// Binary numbers are in this machine's byte order, which the file names. What has no place where Gmsh looks
/// for it goes into a section $TetproofSupplement (io/supplement/supplement.hpp).
std::unique_ptr<FilePlan> plan_msh22(const Document& document, bool binary);
std::unique_ptr<FilePlan> plan_msh40(const Document& document, bool binary);  ///< always text
std::unique_ptr<FilePlan> plan_msh41(const Document& document, bool binary);

}  // namespace tetproof::io
