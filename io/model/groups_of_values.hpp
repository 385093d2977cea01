// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers behind elements that are tags: they become physical groups.
#pragma once

#include <optional>
#include <string>

#include "io/document.hpp"

namespace tetproof::io {

/// Makes physical groups of the whole numbers of elements that are called `name`: of each that is positive
/// the group of that number in the element's dimension, of 0 no group. Negative integers, which no group can
/// have, stay as values of their elements. Values stay as they are if they are no tags (several numbers for
/// an element, fractions, negative reals, numbers beyond 32 bits, not one that is positive), or if their
/// elements have groups.
void make_groups_of_values(Document&, const std::string& name);

/// Whether `make_groups_of_values` would take such values, if their elements have no groups.
bool are_tags(const Values&);

/// For formats in which groups may be below 0, as Medit's references: the document with TetGen's negative
/// attributes and markers as groups of elements that have no other. Nothing: there are none.
std::optional<Document> with_groups_below_zero(const Document&);

}  // namespace tetproof::io
