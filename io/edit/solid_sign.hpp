// SPDX-License-Identifier: GPL-3.0-or-later
// Tells which solid elements are inside out.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// Whether the element with these nodes has a negative volume; its block has one of the types of
/// `solid_faces`. By corners; exact for tetrahedra, and for others up to rounding, at any scale. False if a
/// node does not exist or has a coordinate that is not finite.
bool is_inverted(const Document& document, const ElementBlock& block, const Index* nodes);

}  // namespace tetproof::io
