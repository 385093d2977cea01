// SPDX-License-Identifier: GPL-3.0-or-later
// Ghost elements in .msh 2.2. A file lists the partitions of an element; a negative one sees the element as a
// ghost. In a document, an element has the partitions that own it, and ghosts are `Document::ghost_elements`.
#pragma once

#include <cstdint>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Makes ghost elements of the negative partitions of blocks that also have a positive one. Neighbouring
/// blocks that then differ in nothing become one.
void take_ghosts_from_partitions(Document& document);

/// The blocks of a document, cut so that all elements of a block are ghosts of the same partitions.
struct GhostBlocks {
  std::vector<ElementBlock> blocks;
  /// The document's tag sets; behind them partitions with their ghosts, to which the blocks refer.
  std::vector<std::vector<std::int64_t>> tag_sets;
  /// Whether `take_ghosts_from_partitions` makes the document's ghost elements of these blocks again.
  bool complete = true;
};
GhostBlocks blocks_with_ghosts(const Document& document);

}  // namespace tetproof::io
