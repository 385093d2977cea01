// SPDX-License-Identifier: GPL-3.0-or-later
// What the format of a document's file says of its numbers and values. A join of several formats keeps it.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// Whether the file says its nodes' (elements') numbers, so that an edit keeps them. Else the reader counted.
bool has_node_numbers(const Document& document);
bool has_element_numbers(const Document& document);

/// Sets `Values::length_power` of what the format knows as lengths: TetGen's sizes (of a metric tensor each
/// entry is 1 / length^2) and bounds of volumes.
void mark_lengths(Document& document);

}  // namespace tetproof::io
