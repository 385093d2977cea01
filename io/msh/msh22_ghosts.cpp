// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh/msh22_ghosts.hpp"

#include <algorithm>
#include <map>

#include "io/model/block_of.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {
namespace {

bool is_ghost(std::int64_t partition) {
  return partition < 0;
}

// Whether a list of partitions has an owner and ghosts.
bool has_ghosts(const std::vector<std::int64_t>& partitions) {
  return std::any_of(partitions.begin(), partitions.end(), is_ghost) &&
         std::any_of(partitions.begin(), partitions.end(), [](std::int64_t p) { return p > 0; });
}

void join_blocks(std::vector<ElementBlock>& blocks) {
  std::vector<ElementBlock> joined;
  for (const ElementBlock& block : blocks)
    if (!joined.empty() && are_alike(joined.back(), block))
      joined.back().count += block.count;
    else
      joined.push_back(block);
  blocks = std::move(joined);
}

}  // namespace

void take_ghosts_from_partitions(Document& document) {
  if (std::none_of(document.tag_sets.begin(), document.tag_sets.end(), has_ghosts)) return;
  TagSets sets(document);
  bool any = false;
  for (ElementBlock& block : document.blocks) {
    const std::vector<std::int64_t> all = document.tag_sets[static_cast<std::size_t>(block.partitions)];
    if (!has_ghosts(all)) continue;
    any = true;
    std::vector<std::int64_t> owners, ghosts;
    for (const std::int64_t partition : all)
      is_ghost(partition) ? ghosts.push_back(-partition) : owners.push_back(partition);
    block.partitions = sets(owners);
    for (std::size_t e = block.first; e < block.first + block.count; ++e)
      document.ghost_elements.push_back({static_cast<Index>(e), owners[0], ghosts});
  }
  if (any) join_blocks(document.blocks);
}

GhostBlocks blocks_with_ghosts(const Document& document) {
  GhostBlocks cut{document.blocks, document.tag_sets};
  if (document.ghost_elements.empty()) return cut;
  std::vector<const GhostElement*> ghost_of(document.elements());
  for (const GhostElement& ghost : document.ghost_elements) {
    const bool known = ghost.element >= 0 && static_cast<std::size_t>(ghost.element) < ghost_of.size();
    const bool written =
        known && !ghost_of[static_cast<std::size_t>(ghost.element)] && !ghost.ghosts.empty() &&
        std::none_of(ghost.ghosts.begin(), ghost.ghosts.end(), [](std::int64_t p) { return p <= 0; });
    cut.complete = cut.complete && written;
    if (written) ghost_of[static_cast<std::size_t>(ghost.element)] = &ghost;
  }
  cut.blocks.clear();
  std::map<std::vector<std::int64_t>, std::int32_t> sets;
  for (const ElementBlock& block : document.blocks) {
    const auto& owners = document.tag_sets[static_cast<std::size_t>(block.partitions)];
    for (std::size_t e = block.first; e < block.first + block.count; ++e) {
      ElementBlock one = block;
      one.first = e, one.count = 1;
      one.nodes = block.nodes + (e - block.first) * static_cast<std::size_t>(block.nodes_each);
      if (const GhostElement* ghost = ghost_of[e]) {
        if (owners.empty() || owners[0] != ghost->partition || owners[0] <= 0) {
          cut.complete = false;
        } else {
          std::vector<std::int64_t> all = owners;
          for (const std::int64_t partition : ghost->ghosts) all.push_back(-partition);
          const auto [place, is_new] = sets.try_emplace(all, static_cast<std::int32_t>(cut.tag_sets.size()));
          if (is_new) cut.tag_sets.push_back(std::move(all));
          one.partitions = place->second;
        }
      }
      if (e > block.first && are_alike(cut.blocks.back(), one))
        ++cut.blocks.back().count;
      else
        cut.blocks.push_back(one);
    }
    if (block.count == 0) cut.blocks.push_back(block);
  }
  return cut;
}

}  // namespace tetproof::io
