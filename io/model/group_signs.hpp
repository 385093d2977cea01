// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of Gmsh's physical groups. A negative number means the group of the positive one, with its
// elements turned: `Physical Surface(5) = {-1, 2}`. Other formats know numbers only, and -5 would be another
// group.
#pragma once

#include <cstdint>

#include "io/document.hpp"

namespace tetproof::io {

/// Whether the document comes from Gmsh and has a group with a sign.
bool has_signed_groups(const Document& document);

/// The number without the sign that it has if the document comes from Gmsh.
std::int64_t unsigned_group(const Document& document, std::int64_t group);

/// The document with the same blocks, whose elements and entities are in groups without signs. They are not
/// turned.
Document with_unsigned_groups(const Document& document);

}  // namespace tetproof::io
