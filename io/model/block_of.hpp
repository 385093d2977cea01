// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the block of an element.
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

}  // namespace tetproof::io
