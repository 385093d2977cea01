// SPDX-License-Identifier: GPL-3.0-or-later
// The OBJ format of surfaces.
#pragma once

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::io {

/// Reads Wavefront's OBJ: `v` (what follows x y z must be numbers and is skipped), `f` with i, i/t, i//n or
/// i/t/n, positive or negative, also naming points that come later; a backslash before the line's end
/// continues it. The other statements that OBJ knows are skipped, but for free-form surfaces (`surf`), which
/// are refused like unknown statements. Throws InputError.
TriangleSurface read_obj(const InputFile& file);

/// OBJ as text, exact.
void write_obj(AtomicFile& file, const TriangleSurface& surface);

}  // namespace tetproof::io
