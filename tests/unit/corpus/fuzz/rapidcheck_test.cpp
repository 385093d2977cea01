// SPDX-License-Identifier: GPL-3.0-or-later
// Random surfaces for RapidCheck: what fails shrinks to the simplest.
#include "corpus/rapidcheck.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

bool has_cylinder_of_many_corners(const Recipe& recipe) {
  return (recipe.kind == "cylinder" && recipe.values[0] > 10) ||
         std::any_of(recipe.parts.begin(), recipe.parts.end(), has_cylinder_of_many_corners);
}

TEST(RapidCheck, AFailureShrinksToTheSmallestThatFails) {
  const rc::Gen<FuzzSurface> surfaces = rc::gen::arbitrary<FuzzSurface>();
  int failures = 0, combined = 0, modified = 0;
  for (std::uint64_t seed = 0; failures < 5 || combined == 0 || modified == 0; ++seed) {
    ASSERT_LT(seed, 5000u);
    const rc::Shrinkable<FuzzSurface> drawn = surfaces(rc::Random(seed), 100);
    const Recipe recipe = drawn.value().recipe;
    if (!has_cylinder_of_many_corners(recipe)) continue;
    ++failures;
    combined += !recipe.parts.empty();
    modified += !recipe.modifiers.empty();
    const auto [smallest, path] = rc::shrinkable::findLocalMin(
        drawn, [](const FuzzSurface& surface) { return has_cylinder_of_many_corners(surface.recipe); });
    EXPECT_EQ(recipe_text(smallest.recipe), "cylinder(n=11,h=1,m=1,hub=0)") << recipe_text(recipe);
    EXPECT_EQ(smallest.surface.triangles.size(), 40u);
  }
}

TEST(RapidCheck, EveryStepOfTheShrinkingIsAValidSurface) {
  const rc::Shrinkable<FuzzSurface> drawn = fuzz_surfaces({.kinds = {"nested-spheres"}})(rc::Random(5), 100);
  auto steps = drawn.shrinks();
  int count = 0;
  while (const auto step = steps.next()) {
    ++count;
    EXPECT_EQ(verify::judge_surface(step->value().surface).fault, "");
  }
  EXPECT_GT(count, 3);
}

TEST(RapidCheck, ShowsTheNameThatProgramsTake) {
  std::ostringstream out;
  rc::show(build(parse_recipe("torus+floats")), out);
  EXPECT_EQ(out.str(), "fuzz:torus(n=3,m=3,r=0.5)+floats() (18 triangles)");
}

}  // namespace
}  // namespace tetproof::corpus
