// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/shrink/shrink_recipe.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

#include "corpus/shrink/ordered_search.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

class Descent {
 public:
  Descent(const StillFails& fails, const RecipeSteps& steps, const ShrinkOptions& options)
      : fails_(fails), steps_(steps), threads_(threads_or_cores(options.threads)), limit_(options.seconds) {}

  bool call(const FuzzSurface& surface) {
    {
      const std::scoped_lock lock(mutex_);
      ++result_.calls;
    }
    return fails_(surface.surface);
  }

  // Takes the first simpler recipe that still fails; false if there is none.
  bool step(FuzzSurface& current) {
    const std::vector<Recipe> recipes = steps_.simpler(current.recipe);
    std::optional<std::pair<std::size_t, FuzzSurface>> best;
    const auto found = first_success(recipes.size(), threads_, limit_, [&](std::size_t i) {
      {
        const std::scoped_lock lock(mutex_);
        if (std::find(passed_.begin(), passed_.end(), recipes[i]) != passed_.end()) return false;
      }
      std::optional<FuzzSurface> candidate = built(recipes[i], current.surface.triangles.size());
      const bool fails = candidate && call(*candidate);
      const std::scoped_lock lock(mutex_);
      if (!fails)
        passed_.push_back(recipes[i]);
      else if (!best || i < best->first)
        best.emplace(i, *std::move(candidate));
      return fails;
    });
    if (found) current = std::move(best->second);
    result_.finished = found || !limit_.over();
    return found.has_value();
  }

  const TimeLimit& limit() const { return limit_; }
  RecipeShrinkResult& result() { return result_; }

 private:
  std::optional<FuzzSurface> built(const Recipe& recipe, std::size_t most_triangles) {
    std::optional<FuzzSurface> surface;
    try {
      surface = steps_.build(recipe);
    } catch (const InputError&) {
    }
    const std::scoped_lock lock(mutex_);
    if (!surface) {
      ++result_.not_built;
    } else if (surface->surface.triangles.size() > most_triangles) {
      ++result_.larger;
      surface.reset();
    }
    return surface;
  }

  const StillFails& fails_;
  const RecipeSteps& steps_;
  int threads_;
  TimeLimit limit_;
  std::mutex mutex_;
  std::vector<Recipe> passed_;  // the recipes that were tried and did not fail
  RecipeShrinkResult result_;
};

}  // namespace

RecipeShrinkResult shrink_recipe(const FuzzSurface& start, const StillFails& fails,
                                 const ShrinkOptions& options, const RecipeSteps& steps) {
  Descent descent(fails, steps, options);
  RecipeShrinkResult& result = descent.result();
  result.surface = start;
  result.confirmed = descent.call(start);
  if (result.confirmed) {
    while (descent.step(result.surface)) ++result.steps;
    if (result.steps > 0) result.confirmed = descent.call(result.surface);
  }
  result.seconds = descent.limit().elapsed();
  return result;
}

}  // namespace tetproof::corpus
