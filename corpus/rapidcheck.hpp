// SPDX-License-Identifier: GPL-3.0-or-later
// Random surfaces for RapidCheck: a property that takes a `FuzzSurface` or a `Recipe` fails with the simplest
// recipe that was found to fail. For users who have RapidCheck; nothing else of tetproof needs it.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include "corpus/fuzz_surface.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {

/// Recipes that `build` accepts. A failing one shrinks by `simpler`.
inline rc::Gen<Recipe> fuzz_recipes(const FuzzOptions& options = {}) {
  return [options](const rc::Random& random, int) {
    rc::Random numbers = random;
    const auto simpler_ones = [](const Recipe& recipe) {
      return rc::seq::filter(rc::seq::fromContainer(simpler(recipe)), [](const Recipe& candidate) {
        try {
          build(candidate);
          return true;
        } catch (const InputError&) {  // it builds no valid surface
          return false;
        }
      });
    };
    return rc::shrinkable::shrinkRecur(fuzz_surface(numbers.next(), 0, options).recipe, simpler_ones);
  };
}

/// The surfaces of these recipes.
inline rc::Gen<FuzzSurface> fuzz_surfaces(const FuzzOptions& options = {}) {
  return rc::gen::map(fuzz_recipes(options), [](const Recipe& recipe) { return build(recipe); });
}

/// What RapidCheck prints of a failure: fuzz:RECIPE, which every program of tetproof takes.
inline void showValue(const Recipe& recipe, std::ostream& out) {
  out << "fuzz:" << recipe_text(recipe);
}
inline void showValue(const FuzzSurface& surface, std::ostream& out) {
  showValue(surface.recipe, out);
  out << " (" << surface.surface.triangles.size() << " triangles)";
}

}  // namespace tetproof::corpus

namespace rc {

template <>
struct Arbitrary<tetproof::corpus::Recipe> {
  static Gen<tetproof::corpus::Recipe> arbitrary() { return tetproof::corpus::fuzz_recipes(); }
};

template <>
struct Arbitrary<tetproof::corpus::FuzzSurface> {
  static Gen<tetproof::corpus::FuzzSurface> arbitrary() { return tetproof::corpus::fuzz_surfaces(); }
};

}  // namespace rc
