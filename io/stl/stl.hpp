// SPDX-License-Identifier: GPL-3.0-or-later
// The STL format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// Reads STL. The file is binary if the number of facets behind the header of 80 bytes is the one that the
/// file's size allows, whatever the first letters of the header are; or if that number is 0 and the size is
/// 84 + 50 n (some writers never go back to fill it in). Less than a facet behind the last one is dropped.
/// Every other file is text: any number of solids, keywords in any case, `end` in one word with its keyword
/// or apart from it; names and `endsolid` may be missing. Coordinates of the text form are read as doubles.
///
/// Equal corners become one node (io/model/weld.hpp). Text: each solid is a physical group, see
/// io/stl/stl_solids.hpp. Binary: the header, without blanks and zeros around it, is the title; attributes
/// are values of elements "attribute" if any of them is not 0, and are not read if only a surface is wanted.
/// Normals are not kept: those that point against the order of the corners are dropped, the others follow
/// from it. Throws InputError.
ReadDocument read_stl(const InputFile& file, Wanted wanted);

/// STL: triangles of any order by their corners, and planar and convex polygons as fans of triangles
/// (io/surface/polygons.hpp), but for those that name nodes which do not exist. Binary: coordinates are
/// rounded to float32, in which one too large becomes infinite; title and "attribute" as they are read. Text,
/// exact: a solid for each run of elements with the same groups, which tells the first of them.
std::unique_ptr<FilePlan> plan_stl(const Document& document, bool binary);

}  // namespace tetproof::io
