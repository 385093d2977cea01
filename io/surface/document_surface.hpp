// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that a mesh file holds, checked and welded as surface files are.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// The document's triangles, as `surface_of` takes them, with equal vertices welded. Elements of other
/// dimensions are passed over. Throws InputError, naming the element by its number in the file, if there are
/// no triangles, if an element of two dimensions is none (a quadrangle), or if a triangle names a node that
/// does not exist.
TriangleSurface welded_surface(const Document& document);

}  // namespace tetproof::io
