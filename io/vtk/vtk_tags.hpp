// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cell data that are tags of elements: entities and physical groups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The role of an array in VTK's attributes: "Scalars", "Vectors", ...
struct VtkRole {
  std::string array, role;
};

/// The cell data that are tags, by their names. Empty: there are none.
struct VtkTagNames {
  std::string entities;
  std::vector<std::string> groups;  ///< those with the first, the second, ... group of each element
};

/// Looks through the cell data of all pieces of a file. Of each kind of tag, the first word in
/// io/model/tag_words.hpp counts whose numbers may be tags. A piece in which they are something else makes
/// them data in all pieces.
VtkTagNames vtk_tag_names(std::span<const std::vector<Column>> pieces);
/// Whether `vtk_tag_names` looks at cell data of this name.
bool may_be_vtk_tag_name(std::string_view name);

/// Whether numbers of this name may be tags: integers, or reals that are whole, as MMG writes them. A group
/// of another tool than Gmsh and Medit is a number of 32 bits; negative ones are none, and stay numbers of
/// their elements. Zeros alone say nothing.
bool may_be_tags(std::string_view name, std::span<const std::int64_t> integers,
                 std::span<const double> reals);
/// Whether negative numbers under this name are groups, and any number is: Gmsh and Medit have them.
bool has_any_group(std::string_view name);
/// Whether a group can stand under any name.
bool is_common_group(std::int64_t group);

/// Takes the numbers of the first column of this name that can be tags. False: there is none.
bool take_tags(std::vector<Column>& columns, const std::string& name, std::vector<std::int64_t>& to);

/// Gives references of nodes, if there are such point data, the name that documents have for them, and
/// integers for whole reals, as which MMG writes them. `roles`: of the point data.
void name_node_references(std::vector<Column>& point_data, std::vector<VtkRole>& roles, bool all_of_file);

/// The name of the array with the k-th group of each element, from 2. The first has one of the words in
/// io/model/tag_words.hpp.
std::string vtk_group_array(std::size_t k);

}  // namespace tetproof::io
