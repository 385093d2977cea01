// SPDX-License-Identifier: GPL-3.0-or-later
// The part of documents_compare.hpp that compares parts of a document as texts, in any order.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "difference_list.hpp"
#include "document_texts.hpp"

namespace tetproof::test {

/// Adds texts of `was` without an equal in `is` as lost, and texts of `is` without an equal in `was` as
/// gained. A remnant of a lost text (remnants.hpp) is not gained.
/// `renumbered_unknown`: numbers of nodes that do not exist and whose change is already reported.
void compare_texts(std::vector<Text> was, std::vector<Text> is, DifferenceList& differences,
                   std::set<std::int64_t>& renumbered_unknown);

}  // namespace tetproof::test
