// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_tags.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/model/tag_words.hpp"

namespace tetproof::io {
namespace {

constexpr std::string_view group_prefix = "group ";

bool are_plain_integers(const Column& column) {
  return column.components == 1 && column.reals.empty() && column.texts.empty();
}

// Whether the arrays of this name are tags: integers in all pieces that have them, and not zeros in one.
bool are_tags_in(std::span<const std::vector<Column>> pieces, std::string_view name) {
  bool any = false;
  for (const std::vector<Column>& piece : pieces) {
    bool here = false, integers = false;
    for (const Column& column : piece) {
      if (column.name != name) continue;
      here = true;
      integers |= are_plain_integers(column);
      any |= may_be_tags(column);
    }
    if (here && !integers) return false;
  }
  return any;
}

}  // namespace

VtkTagNames vtk_tag_names(std::span<const std::vector<Column>> pieces) {
  VtkTagNames names;
  for (const TagWord& word : tag_words) {
    const bool is_known = word.tag == Tag::entity ? !names.entities.empty() : !names.groups.empty();
    if (is_known || !are_tags_in(pieces, word.word)) continue;
    if (word.tag == Tag::entity)
      names.entities = word.word;
    else
      names.groups.emplace_back(word.word);
  }
  if (!names.groups.empty())
    for (std::size_t k = 2; are_tags_in(pieces, vtk_group_array(k)); ++k)
      names.groups.push_back(vtk_group_array(k));
  return names;
}

bool may_be_vtk_tag_name(std::string_view name) {
  return name.starts_with(group_prefix) ||
         std::any_of(tag_words.begin(), tag_words.end(), [&](const TagWord& w) { return w.word == name; });
}

bool may_be_tags(const Column& column) {
  return are_plain_integers(column) &&
         std::any_of(column.integers.begin(), column.integers.end(), [](std::int64_t i) { return i != 0; });
}

bool take_tags(std::vector<Column>& columns, const std::string& name, std::vector<std::int64_t>& to) {
  const auto find = [&](bool (*wanted)(const Column&)) {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const Column& column) { return column.name == name && wanted(column); });
  };
  auto found = find(may_be_tags);
  if (found == columns.end()) found = find(are_plain_integers);  // another piece has the tags
  if (found == columns.end()) return false;
  to = std::move(found->integers);
  columns.erase(found);
  return true;
}

std::string vtk_group_array(std::size_t k) {
  return fmt::format("{}{}", group_prefix, k);
}

}  // namespace tetproof::io
