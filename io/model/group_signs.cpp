// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/group_signs.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "io/model/tag_sets.hpp"

namespace tetproof::io {
namespace {

// The smallest number has no positive one.
bool is_signed(std::int64_t group) {
  return group < 0 && group != std::numeric_limits<std::int64_t>::min();
}

}  // namespace

bool has_signed_groups(const Document& document) {
  return document.format.starts_with("msh") &&
         std::any_of(document.blocks.begin(), document.blocks.end(), [&](const ElementBlock& block) {
           const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
           return block.count > 0 && std::any_of(groups.begin(), groups.end(), is_signed);
         });
}

Document with_unsigned_groups(const Document& document, bool of_entities) {
  Document result = document;
  TagSets sets(result);
  const auto without_signs = [&](std::int32_t& groups) {
    std::vector<std::int64_t> left;
    for (std::int64_t group : document.tag_sets[static_cast<std::size_t>(groups)]) {
      if (is_signed(group)) group = -group;
      if (std::find(left.begin(), left.end(), group) == left.end()) left.push_back(group);
    }
    groups = sets(left);
  };
  for (ElementBlock& block : result.blocks) without_signs(block.groups);
  if (of_entities)
    for (Entity& entity : result.entities) without_signs(entity.groups);
  return result;
}

}  // namespace tetproof::io
