// SPDX-License-Identifier: GPL-3.0-or-later
// The STL format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads STL. The file is binary if the number of facets behind the 80-byte header agrees with the file's
/// size, whatever the first letters of the header are. It is also binary if that number is 0 and the size is
/// 84 + 50 n, because some programs never go back to write the number. A file with zero bytes is binary too,
/// if its numbers are such as meshes have: a warning says that the number of facets is another one. All
/// facets are read if no byte is left behind them, else those that are announced. Bytes behind these are
/// dropped, and so are facets that are announced but not there. Every other file is text: any number of
/// solids, keywords in any case, `end` joined to its keyword or separate from it. Names and `endsolid` may be
/// missing. Text behind the last solid is dropped, and lines `color`. Coordinates of the text form are read
/// as doubles.
///
/// Equal corners become one node (io/model/weld.hpp). Text: each solid is a physical group, see
/// io/stl/stl_solids.hpp. Binary: the header, without blanks and zeros around it, is the title; attributes
/// are values of elements "attribute" if any of them is not 0, and are not read if only a surface is wanted.
/// Normals are not kept: those that point against the order of the corners are dropped, the others follow
/// from it. Throws InputError.
ReadDocument read_stl(const InputFile& file, Wanted wanted);

/// Plans STL. It holds triangles of any order by their corners, and polygons and facets as the triangles into
/// which io/surface/cutting.hpp cuts them, except those that name nodes which do not exist or cross
/// themselves. Binary: coordinates are rounded to 32-bit floats, and those that are too large become
/// infinite; title as it is read, and "attribute" if no element is cut. Text, with exact numbers: one solid
/// for each run of elements with the same groups; it stores the first group.
std::unique_ptr<FilePlan> plan_stl(const Document& document, bool binary);

}  // namespace tetproof::io
