// SPDX-License-Identifier: GPL-3.0-or-later
// The STL format of surfaces.
#pragma once

#include <memory>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/file_plan.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

/// Reads STL. Binary if the number of facets after the 80 bytes of header is what the file's size says,
/// whatever the header's first letters are, or if it is 0 and the size is 84 + 50 n (writers that never go
/// back to fill it in); otherwise text: any number of solids, keywords in any case, names and `endsolid` may
/// be missing, normals may be anything. Coordinates of the text form are read as doubles.
///
/// Equal corners become one node (io/model/weld.hpp). Text: each solid is a physical group, see
/// io/stl/stl_solids.hpp. Binary: the header without blanks and zeros around it is the title; attributes, if
/// any is not 0, are values of elements "attribute". Normals are not kept, but a warning says how many stand
/// against the order of the corners. Throws InputError.
SurfaceDocument read_stl(const InputFile& file, Wanted wanted);

/// STL: triangles of any order by their corners, and planar and convex polygons as fans of triangles
/// (io/surface/polygons.hpp), but for those that name nodes which do not exist. Binary: coordinates are
/// rounded to float32, in which one too large becomes infinite; title and "attribute" as they are read. Text,
/// exact: a solid for each run of elements with the same groups, which tells the first of them.
std::unique_ptr<FilePlan> plan_stl(const Document& document, bool binary);

}  // namespace tetproof::io
