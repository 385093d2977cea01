// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves out blocks of elements.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "io/edit/new_elements.hpp"

namespace tetproof::io {

/// Keeps the elements of the blocks that `keep` accepts. Returns what is lost.
template <class Keep>
std::vector<Loss> keep_blocks(Document& document, const Keep& keep) {
  NewElements elements(document);
  std::vector<std::int32_t> local;
  for (const ElementBlock& block : document.blocks) {
    if (!keep(block)) continue;
    local.resize(static_cast<std::size_t>(block.nodes_each));
    std::iota(local.begin(), local.end(), 0);
    const Index* nodes = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, nodes += block.nodes_each)
      elements.add(block, block.first + e, nodes, local);
  }
  return std::move(elements).replace(document);
}

}  // namespace tetproof::io
