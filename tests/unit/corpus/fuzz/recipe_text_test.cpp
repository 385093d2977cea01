// SPDX-License-Identifier: GPL-3.0-or-later
// Recipes as text and back, what is refused, and the surfaces that have such names.
#include <gtest/gtest.h>

#include "corpus/fuzz_surface.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RecipeText, GivesTheSameRecipeBack) {
  for (std::uint64_t index = 0; index < 1000; ++index) {
    Recipe recipe = random_recipe(4, index, {.extreme_sizes = true});
    ASSERT_EQ(parse_recipe(recipe_text(recipe)), recipe) << recipe_text(recipe);
  }
  const Recipe recipe{
      "cylinder", {7, 0.1 + 0.2, 1, 0}, {}, {{"offset", {1e6, -1.0 / 3, 5e-324}}, {"floats", {}}}};
  EXPECT_EQ(parse_recipe(recipe_text(recipe)), recipe);
  EXPECT_EQ(
      recipe_text(recipe),
      "cylinder(n=7,h=0.30000000000000004,m=1,hub=0)+offset(x=1e+06,y=-0.3333333333333333,z=4.94066e-324)+"
      "floats()");
}

TEST(RecipeText, WhatIsNotNamedIsSimplest) {
  EXPECT_EQ(parse_recipe("cylinder"), parse_recipe("cylinder(n=3,h=1,m=1,hub=0)"));
  EXPECT_EQ(parse_recipe("cylinder(m=2,n=5)+floats()"), parse_recipe("cylinder(n=5,m=2)+floats"));
  EXPECT_EQ(parse_recipe("beside(torus,gap=2,comb)"), parse_recipe("beside(gap=2,torus(),comb())"));
  EXPECT_EQ(parse_recipe("torus(r=+0.5)"), parse_recipe("torus"));
}

TEST(RecipeText, IsRefusedWithThePlace) {
  const struct {
    const char *text, *error;
  } cases[] = {
      {"", "at character 1: expected a kind of random surface, found the end"},
      {"cylindr(n=3)", "at character 1: expected a kind of random surface, found 'cylindr(n=3)'"},
      {"cylinder(n=3", "at character 13: expected ',' or ')', found the end"},
      {"cylinder(n=3))", "at character 14: expected '+' or the end, found ')'"},
      {"cylinder(k=3)", "at character 10: expected a parameter of cylinder (n, h, m, hub), found 'k=3)'"},
      {"cylinder(n)", "at character 11: expected '=', found ')'"},
      {"cylinder(n=3,n=3)", "at character 14: expected 'n' only once, found 'n=3)'"},
      {"cylinder(n=)", "at character 12: expected a finite number, found ')'"},
      {"cylinder(n=nan)", "at character 12: expected a finite number, found 'nan)'"},
      {"cylinder(h=1e999)", "at character 12: expected a finite number, found '1e999)'"},
      {"cylinder(n=3.5)", "at character 12: expected a whole number, found '3.5)'"},
      {"cylinder(n=2)", "at character 12: expected 3 to 5000, found '2)'"},
      {"cylinder(torus)", "at character 10: expected a parameter of cylinder (n, h, m, hub), found 'torus)'"},
      {"beside()", "at character 1: expected beside with 1 to 64 parts, found 'beside()'"},
      {"nested(torus,comb)", "at character 1: expected nested with 1 to 1 parts, found 'nested(torus,comb)'"},
      {"torus+turn(x=1)", "at character 7: expected a modifier, found 'turn(x=1)'"},
      {"torus+floats(x=1)", "at character 14: expected no parameter of floats, found 'x=1)'"},
      {"torus +floats", "at character 6: expected '+' or the end, found ' +floats'"},
      {"torus\n", "at character 6: expected '+' or the end, found '?'"},
  };
  for (const auto& [text, error] : cases) EXPECT_EQ(error_of([&] { parse_recipe(text); }), error) << text;
}

TEST(RecipeText, DeepAndLongOnesAreRefusedAtOnce) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "nested(";
  EXPECT_EQ(error_of([&] { parse_recipe(deep); }).substr(0, 65),
            "at character 64: expected at most 8 combinations in one another, ");
  std::string wide = "beside(beside(torus";
  for (int i = 0; i < 300; ++i) wide += ",torus";
  EXPECT_NE(error_of([&] { parse_recipe(wide + "))"); }).find("at most 256 surfaces"), std::string::npos);
}

TEST(Recipe, ThatKeepsNoRulesIsRefused) {
  const auto error = [](const Recipe& recipe) { return error_of([&] { build(recipe); }); };
  EXPECT_EQ(error({"ball"}), "ball: no such kind of random surface");
  EXPECT_EQ(error({"torus", {3, 3}}), "torus: expected 3 values, found 2");
  EXPECT_EQ(error({"torus", {3, 3, std::nan("")}}).substr(0, 43),
            "torus: r: expected 0.001 to 0.9999, found n");
  EXPECT_EQ(error({"torus", {3, 3.5, 0.5}}), "torus: m: expected a whole number, found 3.5");
  EXPECT_EQ(error({"torus", {3, 3, 0.5}, {}, {{"twirl", {}}}}), "twirl: no such modifier");
  EXPECT_EQ(error({"torus", {3, 3, 0.5}, {{"comb", {1, 1, 1}}}}), "torus: expected 0 to 0 parts, found 1");
  EXPECT_EQ(error({"beside", {1}}), "beside: expected 1 to 64 parts, found 0");
  EXPECT_EQ(error({"nested-spheres", {5, 1, 0.5}}), "nested-spheres: gap: expected less than 1 / (n - 1)");
}

TEST(FuzzSpec, NamesTheSameSurfaces) {
  const FuzzSurface random = fuzz_surface(7, 12);
  for (const std::string& spec : {std::string("fuzz:seed=7,case=12"), std::string("fuzz:case=12,seed=7"),
                                  "fuzz:" + recipe_text(random.recipe)}) {
    EXPECT_TRUE(is_generated(spec));
    const TriangleSurface surface = make_surface(spec);
    EXPECT_EQ(surface.vertices, random.surface.vertices);
    EXPECT_EQ(surface.triangles, random.surface.triangles);
    EXPECT_EQ(exact_volume(spec), random.volume);
  }
  EXPECT_EQ(make_surface("fuzz").vertices, fuzz_surface(1, 0).surface.vertices);
  EXPECT_EQ(make_surface("fuzz:torus+scale(x=2)").triangles.size(), 18u);
  EXPECT_NO_THROW(make_surface("fuzz:seed=18446744073709551615,case=18446744073709551615"));
  EXPECT_FALSE(is_generated("fuzz.off"));
  EXPECT_NE(list_surfaces().find("fuzz: "), std::string::npos);
}

TEST(FuzzSpec, ErrorsAreOneLineThatSaysWhatToDo) {
  const struct {
    const char *spec, *error;
  } cases[] = {
      {"fuzz:seed=1,k=2", "fuzz:seed=1,k=2: expected seed=NUMBER or case=NUMBER, found 'k=2'"},
      {"fuzz:seed", "fuzz:seed: at character 1: expected a kind of random surface, found 'seed'"},
      {"fuzz:seed=-1", "fuzz:seed=-1: seed: expected a whole number below 18446744073709551616, found '-1'"},
      {"fuzz:seed=1,seed=1", "fuzz:seed=1,seed=1: the key 'seed' is given twice"},
      {"fuzz:torus(n=1)", "fuzz:torus(n=1): at character 9: expected 3 to 1000, found '1)'"},
  };
  for (const auto& [spec, error] : cases) EXPECT_EQ(error_of([&] { make_surface(spec); }), error);
}

}  // namespace
}  // namespace tetproof::corpus
