// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the recipe of a surface simpler while something about the surface stays true.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "corpus/fuzz_surface.hpp"
#include "corpus/shrink/shrink_surface.hpp"

namespace tetproof::corpus {

/// Where simpler recipes come from, and how their surfaces are built; both are called by several threads at
/// once. `build` throws InputError where a recipe builds no valid surface.
struct RecipeSteps {
  std::function<std::vector<Recipe>(const Recipe&)> simpler = corpus::simpler;
  std::function<FuzzSurface(const Recipe&)> build = corpus::build;
};

struct RecipeShrinkResult {
  FuzzSurface surface;         ///< with its recipe
  std::int64_t steps = 0;      ///< recipes that were accepted, one after the other
  std::int64_t calls = 0;      ///< of the test, with those that ran in vain beside another and the last one
  std::int64_t not_built = 0;  ///< recipes that were left out as they build no valid surface
  std::int64_t larger = 0;     ///< recipes that were left out as their surface has more triangles
  double seconds = 0;
  bool finished = true;   ///< false: the time was over before no simpler recipe was left
  bool confirmed = true;  ///< the result failed once more at the end; false: the test is not deterministic
};

/// Shrinks by greedy descent: the first recipe of `simpler`, in its order, whose surface still fails is
/// taken, and from there on again, until none fails. The result does not depend on the number of threads
/// unless the time runs out. Ends if each recipe of `simpler` is smaller than the one before. What `fails`
/// throws is passed on.
RecipeShrinkResult shrink_recipe(const FuzzSurface& start, const StillFails& fails,
                                 const ShrinkOptions& options = {}, const RecipeSteps& steps = {});

}  // namespace tetproof::corpus
