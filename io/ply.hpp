// SPDX-License-Identifier: GPL-3.0-or-later
// The PLY format of surfaces.
#pragma once

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Reads PLY: text and both byte orders. Element `vertex` with x, y, z and element `face` with a list
/// `vertex_indices` or `vertex_index`, in any order and of any type; all other elements and properties are
/// skipped. Throws InputError.
TriangleSurface read_ply(const InputFile& file);

/// Binary PLY, little endian, double and int; exact.
void write_ply_binary(AtomicFile& file, const TriangleSurface& surface);
/// PLY as text, exact.
void write_ply_text(AtomicFile& file, const TriangleSurface& surface);

}  // namespace tetproof::io
