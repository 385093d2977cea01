// SPDX-License-Identifier: GPL-3.0-or-later
// Shrinking of recipes: always smaller, always a recipe, always ends.
#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/fuzz/recipe_rules.hpp"
#include "corpus/fuzz_surface.hpp"

namespace tetproof::corpus {
namespace {

TEST(Simpler, EachIsSmallerAndKeepsTheRules) {
  std::size_t count = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    const Recipe recipe = random_recipe(9, index, {.extreme_sizes = true});
    for (const Recipe& candidate : simpler(recipe)) {
      ++count;
      ASSERT_LT(recipe_size(candidate), recipe_size(recipe))
          << recipe_text(recipe) << " -> " << recipe_text(candidate);
      ASSERT_NO_THROW(check_recipe(candidate)) << recipe_text(candidate);
      ASSERT_EQ(parse_recipe(recipe_text(candidate)), candidate);
    }
  }
  EXPECT_GT(count, 2000u);
}

// Whichever candidate is taken, the way ends at one surface of the simplest values.
TEST(Simpler, EndsAtTheSimplestSurface) {
  for (std::uint64_t index = 0; index < 100; ++index)
    for (const int way : {0, 1, 2}) {
      Recipe recipe = random_recipe(10, index);
      int steps = 0;
      for (std::vector<Recipe> next = simpler(recipe); !next.empty(); next = simpler(recipe)) {
        recipe = way == 0 ? next.front() : way == 1 ? next.back() : next[next.size() / 2];
        ASSERT_LT(++steps, 20000);
      }
      EXPECT_TRUE(recipe.parts.empty());
      EXPECT_TRUE(recipe.modifiers.empty());
      EXPECT_EQ(recipe, parse_recipe(recipe.kind));
    }
}

TEST(Simpler, TriesTheMostDrasticFirst) {
  const auto texts = [](const char* recipe) {
    std::vector<std::string> all;
    for (const Recipe& candidate : simpler(parse_recipe(recipe))) all.push_back(recipe_text(candidate));
    return all;
  };
  const std::vector<std::string> all = texts("beside(torus,comb(teeth=5))+offset(x=1000)+floats");
  ASSERT_GE(all.size(), 7u);
  EXPECT_EQ(all[0], "torus(n=3,m=3,r=0.5)+offset(x=1000,y=0,z=0)+floats()");
  EXPECT_EQ(all[1], "comb(teeth=5,gap=1,h=1)+offset(x=1000,y=0,z=0)+floats()");
  EXPECT_EQ(all[2], "beside(gap=1,torus(n=3,m=3,r=0.5),comb(teeth=5,gap=1,h=1))");
  EXPECT_EQ(all[3], "beside(gap=1,torus(n=3,m=3,r=0.5),comb(teeth=5,gap=1,h=1))+offset(x=1000,y=0,z=0)");
  EXPECT_EQ(all[4], "beside(gap=1,torus(n=3,m=3,r=0.5),comb(teeth=5,gap=1,h=1))+floats()");
  EXPECT_EQ(all[5], "beside(gap=1,torus(n=3,m=3,r=0.5))+offset(x=1000,y=0,z=0)+floats()");

  const std::vector<std::string> numbers = texts("hourglass(n=11,e=0.000123)");
  EXPECT_EQ(numbers[0], "hourglass(n=3,e=0.000123,h=1)");
  EXPECT_EQ(numbers[1], "hourglass(n=7,e=0.000123,h=1)");
  EXPECT_EQ(numbers[2], "hourglass(n=10,e=0.000123,h=1)");
  EXPECT_EQ(numbers[3], "hourglass(n=11,e=0.5,h=1)");
  EXPECT_EQ(numbers[4], "hourglass(n=11,e=0.0001,h=1)");
  EXPECT_EQ(numbers[5], "hourglass(n=11,e=0.00012,h=1)");
  EXPECT_EQ(numbers[6], "hourglass(n=11,e=0.00123,h=1)");
}

}  // namespace
}  // namespace tetproof::corpus
