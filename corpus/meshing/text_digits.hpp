// SPDX-License-Identifier: GPL-3.0-or-later
// The digits with which a text file writes its coordinates.
#pragma once

#include <string>
#include <string_view>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// The largest number of significant decimal digits among the numbers of `text` that have a point or an
/// exponent. Zeros before the first other digit do not count, those behind the last do.
int most_digits(std::string_view text);

/// The digits to which the coordinates in a mesh file are rounded: the most that it shows, but at least 6,
/// which is what C and C++ print if nothing else is asked for. 0: nothing was rounded, because the file is
/// binary, because it shows 17 digits, or because every point of the mesh is a vertex of the surface. For
/// TetGen's `.ele` the `.node` beside it is read.
int coordinate_digits(const std::string& mesh_file, const TetMesh& mesh, const TriangleSurface& surface);

}  // namespace tetproof::corpus
