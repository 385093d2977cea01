// SPDX-License-Identifier: GPL-3.0-or-later
// The names of PLY's properties: which of them are one, and what values are called so that they come back.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Neighbouring properties that are one: from `first` on, `components` of them.
struct PlyGroup {
  std::string name;
  std::size_t first = 0, components = 1;
};
/// Groups single numbers with these names; only those of the same kind, real or integer, go together.
std::vector<PlyGroup> group_properties(const std::vector<std::string>& names, const std::vector<bool>& real);

/// Values and the names of their properties.
struct PlyNamed {
  const Values* values;
  std::vector<std::string> names;
};

/// Names for the properties of `wanted`, no name twice and none of `taken`, such that all of them come back
/// from every element that has properties for some of them: `parts` says which, in the order in which they
/// stand there. Where the plain name would not do its first letter is escaped; what has no name then is left
/// out. Values of two elements with the same properties are read as one, so no two have the same names.
std::vector<PlyNamed> named_values(const std::vector<const Values*>& wanted,
                                   const std::vector<std::vector<const Values*>>& parts,
                                   const std::set<std::string>& taken);

}  // namespace tetproof::io
