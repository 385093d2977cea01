// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the block of an element, and tells which blocks can be one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The block that has an element; there must be one.
inline const ElementBlock& block_of(const std::vector<ElementBlock>& blocks, std::size_t element) {
  return *std::prev(
      std::upper_bound(blocks.begin(), blocks.end(), element,
                       [](std::size_t e, const ElementBlock& block) { return e < block.first; }));
}

/// Whether the elements of two blocks differ in nothing that blocks say: if they follow each other, they can
/// be one block.
inline bool are_alike(const ElementBlock& a, const ElementBlock& b) {
  return a.type == b.type && a.dim == b.dim && a.entity == b.entity && a.groups == b.groups &&
         a.partitions == b.partitions && a.nodes_each == b.nodes_each && a.of_boundary == b.of_boundary &&
         a.faces == b.faces;
}

}  // namespace tetproof::io
