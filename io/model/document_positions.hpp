// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a document that was not read word by word from a file keeps the promise of io/document.hpp.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

/// What has a position outside of its array, or a length that does not fit the others: "facets"; null:
/// nothing.
const char* misplaced(const Document& document);

}  // namespace tetproof::io
