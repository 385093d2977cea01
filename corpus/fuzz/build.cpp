// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/recipe_rules.hpp"
#include "corpus/fuzz/unjudged_build.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/generators/generators.hpp"
#include "corpus/generators/spec.hpp"
#include "io/error.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

void check_values(std::string_view name, const std::vector<FuzzParameter>& parameters,
                  const std::vector<double>& values) {
  if (values.size() != parameters.size())
    throw InputError(fmt::format("{}: expected {} values, found {}", name, parameters.size(), values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FuzzParameter& p = parameters[i];
    if (!(values[i] >= p.least && values[i] <= p.most))
      throw InputError(fmt::format("{}: {}: expected {} to {}, found {}", name, p.key, number_text(p.least),
                                   number_text(p.most), number_text(values[i])));
    if (p.whole() && values[i] != std::floor(values[i]))
      throw InputError(
          fmt::format("{}: {}: expected a whole number, found {}", name, p.key, number_text(values[i])));
  }
}

// Returns the number of leaves.
std::size_t check(const Recipe& recipe, int depth) {
  if (depth > deepest_recipe)
    throw InputError(fmt::format("{}: combinations are more than {} deep", recipe.kind, deepest_recipe));
  const std::vector<FuzzParameter>* parameters = parameters_of(recipe.kind);
  if (!parameters) throw InputError(fmt::format("{}: no such kind of random surface", recipe.kind));
  check_values(recipe.kind, *parameters, recipe.values);
  for (const Modifier& modifier : recipe.modifiers) {
    const FuzzModifier* known = find_modifier(modifier.name);
    if (!known) throw InputError(fmt::format("{}: no such modifier", modifier.name));
    check_values(modifier.name, known->parameters, modifier.values);
  }
  std::size_t least = 0, most = 0, leaves = 1;
  if (const FuzzCombination* combination = find_combination(recipe.kind)) {
    least = combination->least_parts, most = combination->most_parts, leaves = 0;
  }
  if (recipe.parts.size() < least || recipe.parts.size() > most)
    throw InputError(
        fmt::format("{}: expected {} to {} parts, found {}", recipe.kind, least, most, recipe.parts.size()));
  for (const Recipe& part : recipe.parts) leaves += check(part, depth + 1);
  if (leaves > most_leaves) throw InputError(fmt::format("more than {} surfaces in a recipe", most_leaves));
  return leaves;
}

void apply(TriangleSurface& surface, const Modifier& modifier) {
  const FuzzModifier& known = *find_modifier(modifier.name);
  try {
    known.apply(surface, Numbers(known.parameters, modifier.values));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", modifier.name, error.what()));
  }
}

Shape shape_of(const Recipe& recipe) {
  Shape shape;
  try {
    const Numbers numbers(*parameters_of(recipe.kind), recipe.values);
    if (const FuzzKind* kind = find_kind(recipe.kind)) {
      shape = kind->make(numbers);
    } else {
      std::vector<Shape> parts;
      std::size_t triangles = 0;
      for (const Recipe& part : recipe.parts) {
        parts.push_back(shape_of(part));
        triangles += parts.back().surface.triangles.size();
        if (static_cast<double>(triangles) > most_triangles)
          throw InputError(fmt::format("more than {} triangles", most_triangles));
      }
      shape = find_combination(recipe.kind)->make(numbers, parts);
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", recipe.kind, error.what()));
  }
  for (const Modifier& modifier : recipe.modifiers) apply(shape.surface, modifier);
  return shape;
}

// What the judge finds against the promises; empty if they hold.
std::string broken_promise(const Shape& shape, const verify::SurfaceReport& report) {
  if (!report.fault.empty()) return report.fault;
  for (const verify::SurfaceComponent& component : report.components)
    if (component.outward != (component.depth % 2 == 0))
      return fmt::format("the part of triangle {} is oriented {}", component.first_triangle,
                         component.outward ? "outward, but bounds a cavity" : "inward");
  const auto differs = [](const char* what, std::optional<std::int64_t> promised, std::int64_t found) {
    return promised && *promised != found
               ? fmt::format("the construction promises {} = {}, the surface has {}", what, *promised, found)
               : std::string();
  };
  for (const std::string& difference :
       {differs("components", shape.components, static_cast<std::int64_t>(report.components.size())),
        differs("cavities", shape.cavities, report.cavities()), differs("genus", shape.genus, report.genus)})
    if (!difference.empty()) return difference;
  return {};
}

}  // namespace

void check_recipe(const Recipe& recipe) {
  check(recipe, 0);
}

Shape unjudged_build(const Recipe& recipe) {
  return shape_of(recipe);
}

std::size_t count_triangles(const Recipe& recipe) {
  check_recipe(recipe);
  return shape_of(recipe).surface.triangles.size();
}

FuzzSurface build(const Recipe& recipe) {
  check_recipe(recipe);
  Shape shape = shape_of(recipe);
  const std::string broken = broken_promise(shape, verify::judge_surface(shape.surface));
  if (!broken.empty()) throw InputError(fmt::format("{}: {}", recipe_text(recipe), broken));
  FuzzSurface built{std::move(shape.surface), recipe, shape.components, shape.cavities, shape.genus, {}};
  // By code of our own, beside the judge's: the two check each other.
  const double volume = enclosed_volume(built.surface);
  if (std::isnormal(volume)) built.volume = volume;  // else no double is near it
  return built;
}

}  // namespace tetproof::corpus
