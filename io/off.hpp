// SPDX-License-Identifier: GPL-3.0-or-later
// The OFF format of surfaces.
#pragma once

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Reads Geomview's OFF: [ST][C][N]OFF, or no keyword at all; counts on the keyword's line or later, the
/// number of edges there or not; comments; a line for each point and for each face; what follows a point's
/// coordinates or a polygon's corners must be numbers and is skipped (colours, normals). 4OFF, nOFF and
/// binary OFF are refused. Throws InputError.
TriangleSurface read_off(const InputFile& file);

/// OFF as text, exact.
void write_off(AtomicFile& file, const TriangleSurface& surface);

}  // namespace tetproof::io
