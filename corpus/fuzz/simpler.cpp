// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "corpus/fuzz/decimals.hpp"
#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz_surface.hpp"

namespace tetproof::corpus {
namespace {

// How far a value is from the simplest one.
std::int64_t cost(const FuzzParameter& p, double x) {
  if (x == p.simplest) return 0;
  if (p.draw == Draw::integer) return static_cast<std::int64_t>(std::abs(x - p.simplest));
  const Decimal now = shortest_decimal(x), goal = shortest_decimal(p.simplest);
  if (p.draw == Draw::seed) return static_cast<std::int64_t>(now.digits.size()) + now.exponent + 1;
  return 1 + static_cast<std::int64_t>(now.digits.size()) + std::abs(now.exponent - goal.exponent) +
         now.negative;
}

// Values to try instead of x, the simplest first.
std::vector<double> simpler_values(const FuzzParameter& p, double x) {
  std::vector<double> values{p.simplest};
  switch (p.draw) {
    case Draw::integer:
      values.push_back(p.simplest + std::trunc((x - p.simplest) / 2));
      values.push_back(x > p.simplest ? x - 1 : x + 1);
      break;
    case Draw::seed:
      for (double low : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}) values.push_back(low);
      break;
    case Draw::length:
    case Draw::share: {
      const Decimal now = shortest_decimal(x);
      const int goal = shortest_decimal(p.simplest).exponent;
      if (now.negative) values.push_back(-x);
      for (const std::size_t digits : {1, 2, 3, 6}) {
        if (digits >= now.digits.size()) break;
        Decimal shorter = now;
        shorter.digits.resize(digits);
        values.push_back(shorter.value());
      }
      for (const int exponent :
           {now.exponent + (goal - now.exponent) / 2, now.exponent + (goal > now.exponent   ? 1
                                                                      : goal < now.exponent ? -1
                                                                                            : 0)}) {
        Decimal nearer = now;
        nearer.exponent = exponent;
        values.push_back(nearer.value());
      }
      break;
    }
  }
  std::vector<double> good;
  for (const double v : values)
    if (v >= p.least && v <= p.most && cost(p, v) < cost(p, x) &&
        std::find(good.begin(), good.end(), v) == good.end())
      good.push_back(v);
  return good;
}

std::int64_t cost(const std::vector<FuzzParameter>* parameters, const std::vector<double>& values) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; parameters && i < values.size() && i < parameters->size(); ++i)
    sum += cost((*parameters)[i], values[i]);
  return sum;
}

const std::vector<FuzzParameter>* modifier_parameters(const Modifier& modifier) {
  const FuzzModifier* known = find_modifier(modifier.name);
  return known ? &known->parameters : nullptr;
}

// Calls `put` with each simpler list of values.
template <class Put>
void vary(const std::vector<FuzzParameter>* parameters, const std::vector<double>& values, Put put) {
  for (std::size_t i = 0; parameters && i < values.size() && i < parameters->size(); ++i)
    for (const double v : simpler_values((*parameters)[i], values[i])) {
      std::vector<double> changed = values;
      changed[i] = v;
      put(changed);
    }
}

void modify_less(const Recipe& recipe, std::vector<Recipe>& all) {
  if (recipe.modifiers.size() > 1) {
    all.push_back(recipe);
    all.back().modifiers.clear();
  }
  for (std::size_t i = recipe.modifiers.size(); i-- > 0;) {
    all.push_back(recipe);
    all.back().modifiers.erase(all.back().modifiers.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

std::int64_t recipe_size(const Recipe& recipe) {
  constexpr std::int64_t whole = 1'000'000;  // a surface or modifier more outweighs all numbers
  std::int64_t size = whole + cost(parameters_of(recipe.kind), recipe.values);
  for (const Recipe& part : recipe.parts) size += recipe_size(part);
  for (const Modifier& modifier : recipe.modifiers)
    size += whole + cost(modifier_parameters(modifier), modifier.values);
  return size;
}

std::vector<Recipe> simpler(const Recipe& recipe) {
  std::vector<Recipe> all;
  for (const Recipe& part : recipe.parts) {
    all.push_back(part);
    all.back().modifiers.insert(all.back().modifiers.end(), recipe.modifiers.begin(), recipe.modifiers.end());
  }
  modify_less(recipe, all);
  const FuzzCombination* combination = find_combination(recipe.kind);
  if (combination && recipe.parts.size() > combination->least_parts)
    for (std::size_t i = recipe.parts.size(); i-- > 0;) {
      all.push_back(recipe);
      all.back().parts.erase(all.back().parts.begin() + static_cast<std::ptrdiff_t>(i));
    }
  for (std::size_t i = 0; i < recipe.parts.size(); ++i)
    for (Recipe& part : simpler(recipe.parts[i])) {
      all.push_back(recipe);
      all.back().parts[i] = std::move(part);
    }
  vary(parameters_of(recipe.kind), recipe.values, [&](const std::vector<double>& values) {
    all.push_back(recipe);
    all.back().values = values;
  });
  for (std::size_t i = recipe.modifiers.size(); i-- > 0;)
    vary(modifier_parameters(recipe.modifiers[i]), recipe.modifiers[i].values,
         [&](const std::vector<double>& values) {
           all.push_back(recipe);
           all.back().modifiers[i].values = values;
         });
  // The sizes of a modifier's or a value's changes are smaller by construction; a part with the whole's
  // modifiers is too, because the whole is at least one surface more.
  return all;
}

}  // namespace tetproof::corpus
