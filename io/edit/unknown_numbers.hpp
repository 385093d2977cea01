// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps numbers that name nothing from naming something after an edit.
#pragma once

#include <cstddef>
#include <string>

#include "io/document.hpp"

namespace tetproof::io {

/// Gives each of `Document::unknown` another number, behind all, if a node (for one that names nodes) or an
/// element has it by now. Returns how many.
std::size_t free_unknown_numbers(Document& document);

/// Likewise. "; 2 numbers that name nothing moved behind all others", or nothing.
std::string freed_unknown_numbers(Document& document);

}  // namespace tetproof::io
