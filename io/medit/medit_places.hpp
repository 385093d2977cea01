// SPDX-License-Identifier: GPL-3.0-or-later
// What of a document goes where in Medit's files: the writer and what it says that it holds go by the same.
#pragma once

#include <string>

#include "io/document.hpp"
#include "io/medit/medit_keywords.hpp"

namespace tetproof::io {

/// Where the elements of a block go: their keyword, and how many of their nodes. Null: nowhere.
struct MeditPlace {
  const MeditKeyword* keyword = nullptr;
  int nodes = 0;
};
MeditPlace medit_place(const ElementBlock& block);

/// Whether numbers that no node or element has still have none when these count up from 1.
bool medit_numbers_stay(const Document& document);

/// The reference of a block's elements: its first group, 0 for none.
std::int64_t medit_reference(const Document& document, const ElementBlock& block);

/// The values that nodes have as references; null: none.
const Values* medit_references(const Document& document);
/// Whether text can say these, which are no integers, and they are read as they are.
bool are_real_medit_references(const Values& values);
inline constexpr double largest_medit_real_reference = 9e15;

/// Whether these values only mark the nodes (or else elements) that they list, as a keyword does.
bool is_medit_mark(const Values& values, bool of_nodes);

/// Whether a section is written: one that the reader takes back as it is.
bool writes_medit_section(const Section& section, bool binary);

}  // namespace tetproof::io
