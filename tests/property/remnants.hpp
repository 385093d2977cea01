// SPDX-License-Identifier: GPL-3.0-or-later
// A lost part may leave a remnant: a shortened title, values without their labels, values for all nodes
// instead of some, single columns of a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document_texts.hpp"

namespace tetproof::test {

/// Whether `is` says only what `was` said: the same numbers for the same nodes or elements and only NaN or 0
/// for the others; a column of the table; the start of the title.
bool is_remnant(const Text& was, const Text& is);

/// If these are values of the same name (up to a number behind it) with all the same numbers: the nodes or
/// elements that had no value and have NaN or 0 now.
std::optional<std::vector<std::string>> gaps(const Text& was, const Text& is);

/// Whether these are values of nodes under the words that TetGen and Medit have for the same number.
bool are_words_for_one_tag(const Text& was, const Text& is);

/// Whether several parts that came back may be remnants of this one.
bool comes_in_pieces(const Text& was);

}  // namespace tetproof::test
