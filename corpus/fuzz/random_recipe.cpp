// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/fuzz/decimals.hpp"
#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/recipe_rules.hpp"
#include "corpus/fuzz/unjudged_build.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/generators/random.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

// The seed of a case's random numbers: every bit of it depends on every bit of the three (the steps of
// SplitMix64).
std::uint64_t mixed(std::uint64_t seed, std::uint64_t index, std::uint64_t attempt) {
  std::uint64_t state = 0;
  for (const std::uint64_t part : {seed, index, attempt}) {
    state = (state ^ part) + 0x9e3779b97f4a7c15;
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9;
    state = (state ^ (state >> 27)) * 0x94d049bb133111eb;
    state ^= state >> 31;
  }
  return state;
}

double draw(const FuzzParameter& p, Random& random) {
  switch (p.draw) {
    case Draw::integer: {
      const double u = random.unit();
      return p.low + std::floor((p.high - p.low + 1) * u * u);
    }
    case Draw::seed:
      return p.low + std::floor((p.high - p.low + 1) * random.unit());
    case Draw::share:
      return to_decimal_places(random.between(p.low, p.high), 3);
    case Draw::length: {
      const int lowest = shortest_decimal(p.low).exponent, highest = shortest_decimal(p.high).exponent;
      const int exponent = lowest + random.below(highest - lowest + 1);
      const int digits = 100 + random.below(900);
      // Powers of ten and half of them are what people write.
      const int shown = random.below(3) == 0 ? 100 : random.below(3) == 0 ? 500 : digits;
      return std::clamp(Decimal{std::to_string(shown), exponent}.value(), p.low, p.high);
    }
  }
  return p.simplest;
}

std::vector<double> draw_all(const std::vector<FuzzParameter>& parameters, Random& random) {
  std::vector<double> values;
  for (const FuzzParameter& p : parameters) values.push_back(draw(p, random) + 0.0);
  return values;
}

bool allowed(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<const FuzzKind*> kinds_of(const FuzzOptions& options) {
  for (const std::string& name : options.kinds)
    if (!find_kind(name)) throw InputError(fmt::format("{}: no such kind of random surface", name));
  std::vector<const FuzzKind*> kinds;
  for (const FuzzKind& kind : fuzz_kinds())
    if (allowed(options.kinds, kind.name)) kinds.push_back(&kind);
  return kinds;
}

std::vector<const FuzzModifier*> modifiers_of(const FuzzOptions& options) {
  for (const std::string& name : options.modifiers)
    if (name != "none" && !find_modifier(name)) throw InputError(fmt::format("{}: no such modifier", name));
  std::vector<const FuzzModifier*> modifiers;
  if (options.modifiers == std::vector<std::string>{"none"}) return modifiers;
  for (const FuzzModifier& modifier : fuzz_modifiers()) {
    const bool named = !options.modifiers.empty() && allowed(options.modifiers, modifier.name);
    const bool extreme = std::string_view(modifier.name) == "size";
    if (named || (options.modifiers.empty() && (!extreme || options.extreme_sizes)))
      modifiers.push_back(&modifier);
  }
  return modifiers;
}

Recipe random_leaf(const std::vector<const FuzzKind*>& kinds, Random& random) {
  const FuzzKind& kind = *kinds[static_cast<std::size_t>(random.below(static_cast<int>(kinds.size())))];
  return {kind.name, draw_all(kind.parameters, random)};
}

// Gives an offset signs, and changes what would change nothing.
void make_effective(Modifier& modifier, Random& random) {
  std::vector<double>& values = modifier.values;
  if (modifier.name == "offset") {
    const double x = values[0];
    for (double& value : values) {
      const int sign = random.below(3) - 1;
      value = sign == 0 ? 0 : sign * value;
    }
    if (values == std::vector<double>(3, 0.0)) values[0] = x;
  }
  if (modifier.name == "rotate" && values[1] == 0 && values[2] == 0 && values[3] == 0) values[3] = 1;
}

// One modifier of each stage at most.
std::vector<Modifier> random_modifiers(const std::vector<const FuzzModifier*>& known, Random& random) {
  std::vector<Modifier> chosen;
  if (known.empty() || random.below(3) == 0) return chosen;
  const int wanted = 1 + random.below(3);
  std::vector<const FuzzModifier*> picked;
  for (int i = 0; i < wanted; ++i) {
    const FuzzModifier* one = known[static_cast<std::size_t>(random.below(static_cast<int>(known.size())))];
    if (std::none_of(picked.begin(), picked.end(), [&](auto* other) { return other->stage == one->stage; }))
      picked.push_back(one);
  }
  std::sort(picked.begin(), picked.end(), [](auto* a, auto* b) { return a->stage < b->stage; });
  for (const FuzzModifier* modifier : picked) {
    Modifier drawn{modifier->name, draw_all(modifier->parameters, random)};
    make_effective(drawn, random);
    chosen.push_back(std::move(drawn));
  }
  return chosen;
}

Recipe attempt_recipe(std::uint64_t seed, std::uint64_t index, std::uint64_t attempt,
                      const FuzzOptions& options) {
  const std::vector<const FuzzKind*> kinds = kinds_of(options);
  const std::vector<const FuzzModifier*> modifiers = modifiers_of(options);
  Random random(mixed(seed, index, attempt));
  Recipe recipe;
  const int choice = random.below(16);
  if (choice < 2) {
    recipe.kind = choice == 0 ? "beside" : "nested";
    const FuzzCombination& combination = *find_combination(recipe.kind);
    recipe.values = draw_all(combination.parameters, random);
    if (choice == 1 && random.below(2) == 0) recipe.values.back() = 0;
    const std::size_t parts = choice == 0 ? 2 + static_cast<std::size_t>(random.below(2)) : 1;
    for (std::size_t i = 0; i < parts; ++i) recipe.parts.push_back(random_leaf(kinds, random));
  } else {
    recipe = random_leaf(kinds, random);
  }
  recipe.modifiers = random_modifiers(modifiers, random);
  return recipe;
}

// How often a case draws again where its surface has too many triangles or is not valid.
constexpr std::uint64_t most_attempts = 64;

// The first attempt, from `attempt` on, whose surface has few enough triangles.
Recipe small_recipe(std::uint64_t seed, std::uint64_t index, std::uint64_t& attempt,
                    const FuzzOptions& options) {
  for (; attempt < most_attempts; ++attempt) {
    Recipe recipe = attempt_recipe(seed, index, attempt, options);
    try {
      if (count_triangles(recipe) <= static_cast<std::size_t>(std::max(0, options.most_triangles)))
        return recipe;
    } catch (const InputError&) {
      // Values that do not go together: the next attempt.
    }
  }
  throw InputError(fmt::format("none of {} random recipes gives a valid surface of at most {} triangles",
                               most_attempts, options.most_triangles));
}

}  // namespace

Recipe random_recipe(std::uint64_t seed, std::uint64_t index, const FuzzOptions& options) {
  std::uint64_t attempt = 0;
  return small_recipe(seed, index, attempt, options);
}

FuzzSurface fuzz_surface(std::uint64_t seed, std::uint64_t index, const FuzzOptions& options) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Recipe recipe = small_recipe(seed, index, attempt, options);
    for (;;) {
      try {
        return build(recipe);
      } catch (const InputError&) {
        if (recipe.modifiers.empty()) break;
        recipe.modifiers.pop_back();
      }
    }
  }
}

}  // namespace tetproof::corpus
