// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's .msh files. Facts: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"

namespace tetproof::io {

/// Reads versions 1 to 4.1, text and binary of both byte orders. A reference to a node or element that does
/// not exist is kept as such. Sections that are not understood are kept as they stand. If consecutive
/// elements of .msh 1 or 2 differ only in their tag and physical group, the first is kept, in all those
/// groups; a warning says so. $NodeData, $ElementData and $ElementNodeData become values of a view, or of
/// none if they have no real tag (the time). $ElementData by which meshio means groups become groups.
/// Negative partitions of 2.2 and 3, beside positive ones, become ghost elements. InputError, naming the line
/// or byte, for everything else; for fewer blocks than 4.0 and 4.1 announce, too.
///
/// Read with a warning: files without $Nodes or $Elements; totals of 4.0 and 4.1 that disagree with the
/// blocks; names of physical groups without a dimension, as 2.0 has them.
///
/// Listed as dropped: lines or bytes behind those that a section announces, bytes between sections and
/// behind the last one, texts behind the names of sections and beside the names of physical groups, tags of
/// elements that have no meaning (2.2: behind the partitions), the parents of sub-elements in version 3, and
/// a supplement that is outdated.
Document read_msh(const InputFile& file);

/// Binary numbers are in this machine's byte order, which the file names. What has no place where Gmsh looks
/// for it goes into a section $TetproofSupplement (io/supplement/supplement.hpp).
std::unique_ptr<FilePlan> plan_msh22(const Document& document, bool binary);
std::unique_ptr<FilePlan> plan_msh40(const Document& document, bool binary);  ///< always text
std::unique_ptr<FilePlan> plan_msh41(const Document& document, bool binary);

}  // namespace tetproof::io
