// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the elements of a document together from the native part and from the supplement.
#pragma once

#include <vector>

#include "io/document.hpp"
#include "io/supplement/supplement_decoder.hpp"

namespace tetproof::io {

/// A block of the document that was written, and what the native part has of it.
struct SupplementBlock {
  ElementBlock block;
  int kind = 0;               ///< the native part has its elements sorted by this
  bool written = false;       ///< the native part has the elements
  bool native = false;        ///< and all their nodes
  std::vector<Index> listed;  ///< the connectivity, if the native part does not have it
};

/// Gives `native` the blocks of the document, in the document's order, with their connectivity. Calls
/// `in.fail` if the native part has other elements than the blocks say.
void join_blocks(const std::vector<SupplementBlock>& all, Document& native, const Decoder& in);

}  // namespace tetproof::io
