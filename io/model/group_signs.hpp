// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of Gmsh's physical groups. A negative number means the group of the positive one, with its
// elements turned: `Physical Surface(5) = {-1, 2}`. Other formats know numbers only, and -5 would be another
// group.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// Whether the document comes from Gmsh and has a group with a sign.
bool has_signed_groups(const Document& document);

/// The document with the same blocks, whose elements are in groups without signs. They are not turned.
/// `of_entities`: so are the groups of entities.
Document with_unsigned_groups(const Document& document, bool of_entities);

}  // namespace tetproof::io
