// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the positions and lengths in a document that was not read word by word from a file (io/document.hpp
// promises that they fit).
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// Names the first part that has a position outside its array or a length that does not fit: "facets". Null:
/// all parts fit.
const char* misplaced(const Document& document);

}  // namespace tetproof::io
