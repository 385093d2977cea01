// SPDX-License-Identifier: GPL-3.0-or-later
// The STL format of surfaces.
#pragma once

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Reads STL. Binary if the number of facets after the 80 bytes of header is what the file's size says,
/// whatever the header's first letters are, or if it is 0 and the size is 84 + 50 n (writers that never go
/// back to fill it in); otherwise text: any number of solids, keywords in any case, names and `endsolid` may
/// be missing, normals may be anything. Coordinates of the text form are read as doubles. Throws InputError.
TriangleSurface read_stl(const InputFile& file);

/// Binary STL: coordinates are rounded to float32, in which one too large becomes infinite; normals follow
/// from them.
void write_stl_binary(AtomicFile& file, const TriangleSurface& surface);
/// STL as text, exact.
void write_stl_text(AtomicFile& file, const TriangleSurface& surface);

}  // namespace tetproof::io
