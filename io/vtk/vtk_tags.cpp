// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/model/tag_words.hpp"

namespace tetproof::io {
namespace {

constexpr std::string_view group_prefix = "group ";
constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

bool is_entity_word(std::string_view name) {
  return std::any_of(tag_words.begin(), tag_words.end(),
                     [&](const TagWord& word) { return word.word == name && word.tag == Tag::entity; });
}

// Whether numbers contradict that they are tags, and whether they say that they are.
struct Fit {
  bool fits = true, any = false;
};

Fit fit(std::string_view name, std::span<const std::int64_t> integers, std::span<const double> reals) {
  const bool entities = is_entity_word(name), all = entities || has_any_group(name);
  Fit fit;
  for (const std::int64_t tag : integers) {
    fit.fits &= all || (tag >= -most && tag <= most);
    fit.any |= all ? tag != 0 : tag > 0;
  }
  for (const double tag : reals) {  // -0 would come back as 0
    fit.fits &= !entities && (all ? std::abs(tag) : tag) <= static_cast<double>(most) &&
                tag == std::trunc(tag) && (tag > 0 || (tag < 0 && all) || (tag == 0 && !std::signbit(tag)));
    fit.any |= all ? tag != 0 : tag > 0;
  }
  return fit;
}

Fit fit(const Column& column) {
  if (column.components != 1 || !column.texts.empty()) return {.fits = false};
  return fit(column.name, column.integers, column.reals);
}

bool are_tags_in(std::span<const std::vector<Column>> pieces, std::string_view name) {
  bool any = false;
  for (const std::vector<Column>& piece : pieces) {
    bool here = false, fits = false;
    for (const Column& column : piece) {
      if (column.name != name) continue;
      const Fit found = fit(column);
      here = true;
      fits |= found.fits;
      any |= found.fits && found.any;
    }
    if (here && !fits) return false;
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

bool may_be_tags(std::string_view name, std::span<const std::int64_t> integers,
                 std::span<const double> reals) {
  const Fit found = fit(name, integers, reals);
  return found.fits && found.any;
}

bool has_any_group(std::string_view name) {
  return name == own_group_word || name == old_group_word || name == medit_group_word ||
         name.starts_with(group_prefix);
}

bool is_common_group(std::int64_t group) {
  return group > 0 && group <= most;
}

bool take_tags(std::vector<Column>& columns, const std::string& name, std::vector<std::int64_t>& to) {
  const auto find = [&](bool with_any) {
    return std::find_if(columns.begin(), columns.end(), [&](const Column& column) {
      const Fit found = column.name == name ? fit(column) : Fit{.fits = false};
      return found.fits && (found.any || !with_any);
    });
  };
  auto found = find(true);
  if (found == columns.end()) found = find(false);  // another piece has the tags
  if (found == columns.end()) return false;
  to = std::move(found->integers);
  for (const double tag : found->reals) to.push_back(static_cast<std::int64_t>(tag));
  columns.erase(found);
  return true;
}

void name_node_references(std::vector<Column>& point_data, std::vector<VtkRole>& roles, bool all_of_file) {
  const auto named = [&](std::string_view name) {
    return std::find_if(point_data.begin(), point_data.end(),
                        [&](const Column& column) { return column.name == name; });
  };
  const auto found = named(node_reference_word);
  if (found == point_data.end() || named(node_references) != point_data.end() || found->components != 1 ||
      !found->texts.empty())
    return;
  found->name = node_references;
  for (VtkRole& role : roles)
    if (role.array == node_reference_word) role.array = node_references;
  constexpr double whole = 0x1p53;
  if (all_of_file && std::all_of(found->reals.begin(), found->reals.end(), [](double reference) {
        return std::abs(reference) <= whole && reference == std::trunc(reference) &&
               !(reference == 0 && std::signbit(reference));
      })) {
    for (const double reference : found->reals)
      found->integers.push_back(static_cast<std::int64_t>(reference));
    found->reals.clear();
  }
}

std::string vtk_group_array(std::size_t k) {
  return fmt::format("{}{}", group_prefix, k);
}

}  // namespace tetproof::io
