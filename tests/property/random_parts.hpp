// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a random document besides nodes and elements.
#pragma once

#include "random_document.hpp"

namespace tetproof::test {

void add_random_parts(const Recipe& recipe, Document& document);

}  // namespace tetproof::test
