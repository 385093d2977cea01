// SPDX-License-Identifier: GPL-3.0-or-later
// Greedy descent over recipes, with heaps of octahedra in place of the real kinds.
#include "corpus/shrink/shrink_recipe.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

// "ball" with its number of triangles / 8 and its x. A number that 13 divides cannot be built.
FuzzSurface build_ball(const Recipe& recipe) {
  const int n = static_cast<int>(recipe.values.at(0));
  if (n % 13 == 0) throw InputError("ball: 13 is out of range");
  FuzzSurface result;
  result.recipe = recipe;
  result.surface = make_surface("octahedron");
  for (int i = 1; i < n; ++i)
    for (const auto& t : make_surface("octahedron").triangles) result.surface.triangles.push_back(t);
  for (Eigen::Vector3d& p : result.surface.vertices) p.x() += recipe.values.at(1);
  return result;
}

std::vector<Recipe> simpler_ball(const Recipe& recipe) {
  std::vector<Recipe> all;
  const double n = recipe.values[0], x = recipe.values[1];
  if (x != 0) all.push_back({"ball", {n, 0}});
  for (const double fewer : {static_cast<double>(static_cast<int>(n / 2)), n - 1})
    if (fewer >= 1) all.push_back({"ball", {fewer, x}});
  if (x > 1) all.push_back({"ball", {n + 40, x - 1}});  // more triangles: never to be taken
  return all;
}

const RecipeSteps steps{simpler_ball, build_ball};

TEST(ShrinkRecipe, DescendsToTheSmallestThatFails) {
  const FuzzSurface start = build_ball({"ball", {40, 7}});
  for (const int threads : {1, 4}) {
    std::atomic<std::int64_t> calls = 0;
    const StillFails fails = [&](const TriangleSurface& s) {
      ++calls;
      return s.triangles.size() >= 9 * 8 && s.vertices[0].x() + s.vertices[1].x() > 3;
    };
    const RecipeShrinkResult result = shrink_recipe(start, fails, {.threads = threads}, steps);
    EXPECT_EQ(result.surface.recipe, (Recipe{"ball", {9, 7}}));
    EXPECT_EQ(result.surface.surface.triangles.size(), 9u * 8);
    EXPECT_EQ(result.steps, 3);  // 40, 20, 10, 9
    EXPECT_EQ(result.calls, calls);
    EXPECT_GT(result.larger, 0);
    EXPECT_TRUE(result.finished && result.confirmed);
  }
}

TEST(ShrinkRecipe, TakesTheFirstInOrder) {
  const RecipeShrinkResult result = shrink_recipe(
      build_ball({"ball", {8, 7}}), [](const TriangleSurface&) { return true; }, {.threads = 3}, steps);
  EXPECT_EQ(result.surface.recipe, (Recipe{"ball", {1, 0}}));
  EXPECT_EQ(result.steps, 4);  // x = 0 first, then 4, 2, 1
}

TEST(ShrinkRecipe, PassesOverWhatCannotBeBuilt) {
  const RecipeShrinkResult result = shrink_recipe(
      build_ball({"ball", {28, 0}}), [](const TriangleSurface& s) { return s.triangles.size() >= 8 * 13; },
      {.threads = 2}, steps);
  EXPECT_EQ(result.surface.recipe, (Recipe{"ball", {14, 0}}));
  EXPECT_GT(result.not_built, 0);
}

// The real kinds: the result builds what the recipe says, fails, and no simpler recipe does.
TEST(ShrinkRecipe, OfRealKindsEndsWhereNoSimplerOneFails) {
  int shrunk = 0;
  for (std::uint64_t index = 0; index < 12; ++index) {
    const FuzzSurface start = fuzz_surface(5, index);
    const std::size_t bound = start.surface.triangles.size() / 3;
    const StillFails fails = [&](const TriangleSurface& s) { return s.triangles.size() >= bound; };
    const RecipeShrinkResult one = shrink_recipe(start, fails, {.threads = 1});
    const RecipeShrinkResult two = shrink_recipe(start, fails, {.threads = 2});
    EXPECT_TRUE(one.finished && one.confirmed) << recipe_text(start.recipe);
    EXPECT_EQ(recipe_text(one.surface.recipe), recipe_text(two.surface.recipe));
    EXPECT_TRUE(fails(one.surface.surface));
    EXPECT_EQ(build(one.surface.recipe).surface.vertices, one.surface.surface.vertices);
    EXPECT_LE(one.surface.surface.triangles.size(), start.surface.triangles.size());
    shrunk += one.steps > 0;
    for (const Recipe& recipe : simpler(one.surface.recipe)) {
      std::size_t triangles = 0;
      try {
        triangles = build(recipe).surface.triangles.size();
      } catch (const InputError&) {
      }
      EXPECT_FALSE(triangles >= bound && triangles <= one.surface.surface.triangles.size())
          << recipe_text(recipe);
    }
  }
  EXPECT_GT(shrunk, 6);
}

TEST(ShrinkRecipe, SaysThatTheSurfaceDoesNotFail) {
  const RecipeShrinkResult result = shrink_recipe(
      build_ball({"ball", {27, 0}}), [](const TriangleSurface&) { return false; }, {}, steps);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.calls, 1);
  EXPECT_EQ(result.steps, 0);
}

TEST(ShrinkRecipe, KeepsTheTimeLimit) {
  const StillFails slow = [](const TriangleSurface&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    return false;
  };
  std::atomic<bool> first = true;
  const RecipeShrinkResult result = shrink_recipe(
      build_ball({"ball", {50, 9}}),
      [&](const TriangleSurface& s) { return first.exchange(false) || slow(s); },
      {.seconds = 0.02, .threads = 1}, steps);
  EXPECT_FALSE(result.finished);
  EXPECT_LE(result.calls, 2);  // the time may be over before the second
}

}  // namespace
}  // namespace tetproof::corpus
