// SPDX-License-Identifier: GPL-3.0-or-later
// Names of PLY's properties: which properties together are one array of values, and which names make values
// come back.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Neighbouring properties that are one array of values: `components` of them, starting with `first`.
struct PlyGroup {
  std::string name;
  std::size_t first = 0, components = 1;
};
/// Groups properties of these names that are single numbers. Only properties of one kind, real or integer,
/// form a group.
std::vector<PlyGroup> group_properties(const std::vector<std::string>& names, const std::vector<bool>& real);

/// Values and the names of their properties.
struct PlyNamed {
  const Values* values;
  std::vector<std::string> names;
};

/// Finds names for the properties of the values in `wanted`, such that all of these values come back from the
/// file. `parts`: for each element of the file, those of `wanted` that have properties there, in their order.
/// No name is used twice, and none of `taken`: values in two elements of the file with the same properties
/// would be read as one. Where the plain name would not do, its first letter is escaped; values that have no
/// name even then are left out.
std::vector<PlyNamed> named_values(const std::vector<const Values*>& wanted,
                                   const std::vector<std::vector<const Values*>>& parts,
                                   const std::set<std::string>& taken);

}  // namespace tetproof::io
