// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of random surfaces: valid by construction, and what they claim of themselves is so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/unjudged_build.hpp"
#include "corpus/fuzz_surface.hpp"
#include "io/error.hpp"
#include "verify/surface.hpp"

namespace tetproof::corpus {
namespace {

FuzzSurface built(const std::string& recipe) {
  return build(parse_recipe(recipe));
}

// The judge's report equals every claim, which all kinds make.
void expect_claims_hold(const Shape& shape, double volume) {
  const verify::SurfaceReport report = verify::judge_surface(shape.surface);
  ASSERT_EQ(report.fault, "");
  ASSERT_TRUE(shape.components && shape.cavities && shape.genus);
  EXPECT_EQ(*shape.components, static_cast<std::int64_t>(report.components.size()));
  EXPECT_EQ(*shape.cavities, report.cavities());
  EXPECT_EQ(*shape.genus, report.genus);
  EXPECT_EQ(volume, report.volume);  // both are exact, rounded once
  for (const verify::SurfaceComponent& component : report.components)
    EXPECT_EQ(component.outward, component.depth % 2 == 0);
}

TEST(FuzzKinds, EachIsValidWithoutModifiersAndIsWhatItClaims) {
  for (const FuzzKind& kind : fuzz_kinds()) {
    FuzzOptions options{.kinds = {kind.name}, .modifiers = {"none"}};
    int leaves = 0;
    for (std::uint64_t index = 0; leaves < 50; ++index) {
      const Recipe recipe = random_recipe(2026, index, options);
      if (!recipe.parts.empty()) continue;
      ++leaves;
      SCOPED_TRACE(recipe_text(recipe));
      const Shape shape = unjudged_build(recipe);
      expect_claims_hold(shape, enclosed_volume(shape.surface));
    }
  }
}

TEST(FuzzKinds, CombinationsAreValidAndWhatTheyClaim) {
  for (const char* part :
       {"cylinder", "nested-boxes(n=3,gap=0.1)", "nested-boxes(n=4,gap=0.1)", "torus", "holes(n=2,m=1)"})
    for (const char* combination : {"beside({0},{0},gap=0.5)", "nested({0},gap=0.5)", "nested({0},wall=0.5)",
                                    "nested(nested({0}))", "beside(nested({0}),nested({0},wall=1))"}) {
      const std::string text = fmt::format(fmt::runtime(combination), part);
      SCOPED_TRACE(text);
      const FuzzSurface surface = built(text);
      expect_claims_hold({surface.surface, surface.components, surface.cavities, surface.genus},
                         surface.volume.value());
    }
}

TEST(FuzzKinds, TheSimplestValuesAndTheEndsOfEachRange) {
  int refused = 0, accepted = 0;
  for (const FuzzKind& kind : fuzz_kinds()) {
    EXPECT_NO_THROW(built(kind.name)) << kind.name;
    const Recipe simplest = parse_recipe(kind.name);
    for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
      const FuzzParameter& p = kind.parameters[i];
      EXPECT_LE(p.least, p.low) << kind.name << ' ' << p.key;
      EXPECT_LE(p.low, p.high) << kind.name << ' ' << p.key;
      EXPECT_LE(p.high, p.most) << kind.name << ' ' << p.key;
      EXPECT_LE(p.least, p.simplest) << kind.name << ' ' << p.key;
      EXPECT_LE(p.simplest, p.most) << kind.name << ' ' << p.key;
      for (const double value : {p.least, p.low, p.high, p.most}) {
        Recipe recipe = simplest;
        recipe.values[i] = value;
        SCOPED_TRACE(recipe_text(recipe));
        try {
          build(recipe);
          ++accepted;
        } catch (const InputError& error) {  // "gap: expected less than ...": values that do not go together
          EXPECT_NE(std::string(error.what()).find(": expected "), std::string::npos) << error.what();
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(accepted, 300);
  EXPECT_LT(refused, 10);
}

TEST(FuzzKinds, TrianglesAndVolumesCountedByHand) {
  const struct {
    const char* recipe;
    std::size_t triangles;
    double volume;
  } cases[] = {
      {"cylinder(n=4,h=0.5)", 12, 1},                        // a square of area 2
      {"cylinder(n=4,h=0.5,m=3,hub=1)", 3 * 8 + 8, 1},       // three storeys, two fans of four
      {"bipyramid(n=4,h=3)", 8, 4},                          // 2 * 2 * 3 / 3
      {"pit(n=4,h=3,gap=0.5)", 2 + 8 + 4, 6 - 1},            // less a pyramid of height 1.5
      {"uv-sphere(n=4,m=2)", 8, 4.0 / 3},                    // an octahedron
      {"big-sphere(f=1)", 8, 4.0 / 3},                       //
      {"nested-spheres(n=2,gap=0.5)", 16, 4.0 / 3 * 7 / 8},  //
      {"two-spheres(f=1)", 16, 8.0 / 3},                     //
      {"nested-boxes(n=2,gap=0.25)", 24, 1 - 0.125},         //
      {"coplanar(seed=5,n=3)", 12 + 6 * 6, 1},               // each point adds two triangles
      {"thin-plate(seed=5,n=4,h=0.125)", 12 + 16, 0.125},    //
      {"menger(level=1)", 144, 20},                          // 48 + 24 squares, 20 cells
      {"menger(level=2)", 2112, 400},                        //
      {"holes(n=2,m=1,wall=0.5,h=1)", 2 * (2 * 13 + 2 * (5 + 3) + 8), 3.5 * 2 - 2},
      {"comb(teeth=3,gap=0.5,h=2)", 2 * (2 * 8 + 5 + 5 + 2 + 6), 4 + 3 * 2},
      {"chazelle(n=1,e=0.5,w=0.25)", 36, 4 * 4 - 2 * (2 * 0.25 * 1.5)},
      {"chazelle(n=5)", 24 * 5 + 12, -1},
  };
  for (const auto& [recipe, triangles, volume] : cases) {
    const FuzzSurface surface = built(recipe);
    EXPECT_EQ(surface.surface.triangles.size(), triangles) << recipe;
    if (volume >= 0) {
      EXPECT_NEAR(surface.volume.value(), volume, 1e-14 * volume) << recipe;
    }
  }
}

TEST(FuzzKinds, TopologyCountedByHand) {
  const struct {
    const char* recipe;
    std::int64_t components, cavities, genus;
  } cases[] = {
      {"menger(level=1)", 1, 0, 5},
      {"menger(level=2)", 1, 0, 81},
      {"holes(n=3,m=2)", 1, 0, 6},
      {"spiral(n=4)", 1, 0, 0},
      {"knot(q=2)", 1, 0, 1},
      {"torus", 1, 0, 1},
      {"nested-boxes(n=5,gap=0.1)", 5, 2, 0},
      {"nested(nested-boxes(n=5,gap=0.1))", 6, 3, 0},
      {"nested(torus,wall=1)", 3, 1, 1},
      {"beside(torus,nested(torus),many(n=7))", 10, 1, 2},
  };
  for (const auto& [recipe, components, cavities, genus] : cases) {
    const FuzzSurface surface = built(recipe);
    EXPECT_EQ(surface.components, components) << recipe;
    EXPECT_EQ(surface.cavities, cavities) << recipe;
    EXPECT_EQ(surface.genus, genus) << recipe;
  }
}

TEST(FuzzKinds, HaveTheirHardPlaces) {
  // The bottoms of the notches are 2 e apart where they cross.
  const FuzzSurface chazelle = built("chazelle(n=3,e=1e-05,w=0.1)");
  bool above = false, below = false;
  for (const Eigen::Vector3d& v : chazelle.surface.vertices) {
    above |= v == Eigen::Vector3d(-1, 2, -2 + 1e-05);
    below |= v == Eigen::Vector3d(2, -1, -2 - 1e-05);
  }
  EXPECT_TRUE(above && below);
  // Exactly coplanar and exactly cospherical points.
  const FuzzSurface cube = built("coplanar(seed=1,n=9)");
  for (const Eigen::Vector3d& v : cube.surface.vertices)
    EXPECT_TRUE((v.array() == 0 || v.array() == 1).any()) << v.transpose();
  const FuzzSurface sphere = built("cospherical(seed=3,n=40,exact=1)");
  EXPECT_EQ(sphere.surface.vertices.size(), 40u);
  for (const Eigen::Vector3d& v : sphere.surface.vertices)
    EXPECT_EQ(v.squaredNorm(), sphere.surface.vertices[0].squaredNorm());
}

TEST(FuzzKinds, AreListedWithAllThatTheyTake) {
  const std::string list = list_fuzz_kinds();
  EXPECT_GE(fuzz_kinds().size(), 27u);
  for (const FuzzKind& kind : fuzz_kinds()) {
    EXPECT_NE(list.find(fmt::format("{}: {}\n    hard for: {}\n", kind.name, kind.meaning, kind.hard_for)),
              std::string::npos)
        << kind.name;
    EXPECT_EQ(find_kind(kind.name), &kind);  // no name twice
    EXPECT_EQ(find_combination(kind.name), nullptr);
  }
}

}  // namespace
}  // namespace tetproof::corpus
