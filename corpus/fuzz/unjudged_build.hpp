// SPDX-License-Identifier: GPL-3.0-or-later
// What a recipe builds, before it is judged. Internal.
#pragma once

#include "corpus/fuzz/shape.hpp"
#include "corpus/fuzz_surface.hpp"

namespace tetproof::corpus {

/// The surface of a recipe that `check_recipe` accepts. Nothing is proved yet. InputError as `build`.
Shape unjudged_build(const Recipe& recipe);

/// The number of triangles of the recipe's surface. InputError as `build`.
std::size_t count_triangles(const Recipe& recipe);

}  // namespace tetproof::corpus
