// SPDX-License-Identifier: GPL-3.0-or-later
// Adds items to a list of losses. Readers add to `Document::dropped`; the search for what a target cannot
// hold adds to its own list.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Adds `count` of `item`. An item stands in the list once: its counts add up, its first example stays.
/// A count of 0 adds nothing. `elements`: the item is elements, which the mesh then lacks.
void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements = false);

}  // namespace tetproof::io
