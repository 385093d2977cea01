// SPDX-License-Identifier: GPL-3.0-or-later
// Splits a document by its physical groups.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "io/bytes/tokens.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/kept_blocks.hpp"
#include "io/error.hpp"

namespace tetproof::io {
namespace {

// Words for files: letters, digits and a few signs, so that no name leads elsewhere.
std::string file_word(const std::string& name) {
  std::string word;
  for (const char c : name)
    word += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '+'
                ? c
                : '_';
  return word.substr(0, 100);
}

// The name of a group, or, if another part has it too, one that no part has. Capitals make no difference,
// since they make none to some file systems.
std::string different_word(const std::string& name, int dim, std::int64_t number,
                           std::map<std::string, int>& uses) {
  if (uses[lower_case(name)] == 1) return name;
  constexpr const char* dimensions[] = {"points", "lines", "faces", "solids"};
  std::string word = fmt::format("{}_{}_{}", name, dimensions[dim], number);
  while (uses[lower_case(word)] > 0) word += '_';
  uses[lower_case(word)] = 1;
  return word;
}

// Leaves out names of groups and entities that are those of other parts.
void leave_out_others(Document& part) {
  std::set<std::pair<int, std::int64_t>> groups, entities;
  for (const ElementBlock& block : part.blocks) {
    entities.insert({block.dim, block.entity});
    for (const std::int64_t group : part.tag_sets[static_cast<std::size_t>(block.groups)])
      groups.insert({block.dim, std::abs(group)});
  }
  for (const NodeBlock& block : part.node_blocks) entities.insert({block.dim, block.entity});
  std::erase_if(part.group_names, [&](const GroupName& name) {
    return !groups.contains({name.dim, name.group});
  });
  std::erase_if(part.entities, [&](const Entity& entity) {
    return !entities.contains({entity.dim, entity.tag});
  });
  for (Entity& entity : part.entities)
    std::erase_if(entity.boundary, [&](std::int64_t tag) {
      return !entities.contains({entity.dim - 1, std::abs(tag)});
    });
}

// The elements of the blocks that `keep` accepts, and their points.
template <class Keep>
GroupPart part_of(const Document& document, std::string word, const Keep& keep) {
  GroupPart part{std::move(word), document, {}};
  part.lost = keep_blocks(part.document, keep);
  for (Loss& loss : prune(part.document).lost) part.lost.push_back(std::move(loss));
  leave_out_others(part.document);
  return part;
}

}  // namespace

std::vector<GroupPart> split_by_group(const Document& document) {
  std::map<std::pair<int, std::int64_t>, std::string> groups;  // by dimension from 3 down, and number
  bool ungrouped = false;
  for (const ElementBlock& block : document.blocks) {
    if (block.count == 0) continue;
    const auto& tags = document.tag_sets[static_cast<std::size_t>(block.groups)];
    ungrouped = ungrouped || tags.empty();
    for (const std::int64_t group : tags) groups[{-block.dim, std::abs(group)}];
  }
  if (groups.empty()) throw InputError(fmt::format("{}: no element is in a group", document.path));
  std::map<std::string, int> uses;
  if (ungrouped) uses["ungrouped"] = 1;
  for (auto& [group, word] : groups) {
    for (const GroupName& name : document.group_names)
      if (name.dim == -group.first && name.group == group.second) word = file_word(name.name);
    if (word.empty()) word = std::to_string(group.second);
    ++uses[lower_case(word)];
  }
  std::vector<GroupPart> parts;
  for (const auto& [key, name] : groups) {
    const int dim = -key.first;
    const std::int64_t number = key.second;
    const std::string word = different_word(name, dim, number, uses);
    parts.push_back(part_of(document, word, [&](const ElementBlock& block) {
      const auto& tags = document.tag_sets[static_cast<std::size_t>(block.groups)];
      return block.dim == dim &&
             std::any_of(tags.begin(), tags.end(), [&](std::int64_t tag) { return std::abs(tag) == number; });
    }));
  }
  if (ungrouped)
    parts.push_back(part_of(document, "ungrouped", [&](const ElementBlock& block) {
      return document.tag_sets[static_cast<std::size_t>(block.groups)].empty();
    }));
  return parts;
}

}  // namespace tetproof::io
