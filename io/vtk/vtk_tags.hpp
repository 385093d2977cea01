// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cell data that are tags of elements: entities and physical groups.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The cell data that are tags, by their names. Empty: there are none.
struct VtkTagNames {
  std::string entities;
  std::vector<std::string> groups;  ///< those with the first, the second, ... group of each element
};

/// Looks through the cell data of all pieces of a file. Of each kind of tag, the first word in
/// io/model/tag_words.hpp counts that names integers, one for each cell, and not only zeros: these say
/// nothing, and stay an array. A piece in which the array is something else makes it data in all pieces.
VtkTagNames vtk_tag_names(std::span<const std::vector<Column>> pieces);
/// Whether `vtk_tag_names` looks at cell data of this name.
bool may_be_vtk_tag_name(std::string_view name);

/// Whether cell data are looked at as tags, if their name is a word for these.
bool may_be_tags(const Column& column);

/// Takes the integers out of the first column of this name that can be tags. False: there is none.
bool take_tags(std::vector<Column>& columns, const std::string& name, std::vector<std::int64_t>& to);

/// The name of the array with the k-th group of each element, from 2. The first has one of the words in
/// io/model/tag_words.hpp.
std::string vtk_group_array(std::size_t k);

}  // namespace tetproof::io
