// SPDX-License-Identifier: GPL-3.0-or-later
// What is lost may leave something less behind: a title cut short, values without their labels or for every
// node where some had them, the columns of a table by themselves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document_texts.hpp"

namespace tetproof::test {

/// Whether `is` says nothing that `was` did not say: the same numbers for the same nodes or elements and none
/// but NaN and 0 for all others; a column that was there; the start of the title.
bool is_remnant(const Text& was, const Text& is);

/// If these are values of the same name, but for a number behind it, and all the same numbers: the nodes or
/// elements that had none, and have NaN or 0 now.
std::optional<std::vector<std::string>> gaps(const Text& was, const Text& is);

/// Whether several things that came back may be the remnants of one.
bool comes_in_pieces(const Text& was);

}  // namespace tetproof::test
