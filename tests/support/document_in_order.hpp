// SPDX-License-Identifier: GPL-3.0-or-later
// What io/document.hpp promises of every document, whatever was read.
#pragma once

#include "io/document.hpp"

namespace tetproof::test {

/// std::logic_error, saying what, where arrays do not fit together or a position points outside of its array.
void check_in_order(const Document& document);

}  // namespace tetproof::test
