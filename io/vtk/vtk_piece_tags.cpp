// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_piece_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/model/tag_words.hpp"
#include "io/vtk/vtk_tags.hpp"

namespace tetproof::io {

VtkPieceTags::VtkPieceTags(Document& document, VtkPiece& piece)
    : document_(document), names_(piece.tags ? *piece.tags : vtk_tag_names({&piece.cell_data, 1})) {
  const auto take = [&](const std::string& name) {
    std::vector<std::int64_t> tags;
    if (name.empty() || !take_tags(piece.cell_data, name, tags)) return tags;
    if (tags.size() != piece.types.size())
      throw InputError(fmt::format("{}: array \"{}\": expected {}, found {}{}", document.path, name,
                                   counted(piece.types.size(), "values"), tags.size(), piece.which));
    // Entities and groups have no use for a role.
    std::erase_if(piece.cell_roles, [&](const VtkRole& role) { return role.array == name; });
    return tags;
  };
  entities_ = take(names_.entities);
  for (const std::string& name : names_.groups) groups_.push_back(take(name));
  if (names_.groups.empty()) return;
  any_group_ = has_any_group(names_.groups[0]);
  if (names_.groups[0] != own_group_word) document.group_word = names_.groups[0];
}

std::int32_t VtkPieceTags::groups(std::size_t cell, TagSets& sets) {
  if (groups_.empty()) return 0;
  tags_.clear();
  for (std::size_t k = 0; k < groups_.size(); ++k) {
    const std::int64_t tag = groups_[k].empty() ? 0 : groups_[k][cell];
    if (tag > 0 || (tag < 0 && (k > 0 || any_group_))) tags_.push_back(tag);
  }
  return sets(tags_);
}

void VtkPieceTags::add_negative(std::size_t first, const std::vector<std::uint32_t>* origin) const {
  if (any_group_ || groups_.empty() || groups_[0].empty()) return;
  Values rest{.name = names_.groups[0]};
  for (std::size_t e = first; e < document_.elements(); ++e)
    if (const std::int64_t tag = groups_[0][origin ? (*origin)[e - first] : e - first]; tag < 0) {
      rest.at.push_back(static_cast<Index>(e));
      rest.integers.push_back(tag);
    }
  if (rest.at.empty()) return;
  for (Values& values : document_.element_values)
    if (values.name == rest.name && !values.at.empty()) {  // of the pieces before
      std::copy(rest.at.begin(), rest.at.end(), std::back_inserter(values.at));
      std::copy(rest.integers.begin(), rest.integers.end(), std::back_inserter(values.integers));
      return;
    }
  document_.element_values.push_back(std::move(rest));
}

}  // namespace tetproof::io
