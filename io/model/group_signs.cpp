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
  return std::any_of(document.blocks.begin(), document.blocks.end(), [&](const ElementBlock& block) {
    const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
    return block.count > 0 && std::any_of(groups.begin(), groups.end(), [&](std::int64_t group) {
             return unsigned_group(document, group) != group;
           });
  });
}

std::int64_t unsigned_group(const Document& document, std::int64_t group) {
  return is_signed(group) && document.format.starts_with("msh") ? -group : group;
}

Document with_unsigned_groups(const Document& document) {
  Document result = document;
  TagSets sets(result);
  const auto without_signs = [&](std::int32_t& groups) {
    std::vector<std::int64_t> left;
    for (const std::int64_t signed_group : document.tag_sets[static_cast<std::size_t>(groups)]) {
      const std::int64_t group = unsigned_group(document, signed_group);
      if (std::find(left.begin(), left.end(), group) == left.end()) left.push_back(group);
    }
    groups = sets(left);
  };
  for (ElementBlock& block : result.blocks) without_signs(block.groups);
  for (Entity& entity : result.entities) without_signs(entity.groups);
  return result;
}

}  // namespace tetproof::io
