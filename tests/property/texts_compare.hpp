// SPDX-License-Identifier: GPL-3.0-or-later
// The part of documents_compare.hpp that is about parts of a document as texts, in any order.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "difference_list.hpp"
#include "document_texts.hpp"

namespace tetproof::test {

/// Adds what of `was` has no equal in `is` as lost, and what of `is` has none as gained. A text in `is` that
/// only says less than a lost one (remnants.hpp) is not gained.
/// `renumbered_unknown`: numbers of nodes that do not exist, as far as their change is already reported.
void compare_texts(std::vector<Text> was, std::vector<Text> is, DifferenceList& differences,
                   std::set<std::int64_t>& renumbered_unknown);

}  // namespace tetproof::test
