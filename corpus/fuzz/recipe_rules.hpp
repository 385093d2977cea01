// SPDX-License-Identifier: GPL-3.0-or-later
// The rules that a recipe must keep. Internal.
#pragma once

#include "corpus/fuzz_surface.hpp"

namespace tetproof::corpus {

/// Combinations inside combinations, at most; and leaves in a recipe.
inline constexpr int deepest_recipe = 8;
inline constexpr std::size_t most_leaves = 256;

/// InputError, one line, if a kind or modifier is unknown or has another number of values, if a value is out
/// of its range or no whole number where it must be one, or if there are too few or too many parts.
void check_recipe(const Recipe& recipe);

}  // namespace tetproof::corpus
