// SPDX-License-Identifier: GPL-3.0-or-later
// Random closed surfaces that are hard for meshers, each with the recipe that it was built from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// A change of a whole surface that keeps it closed and embedded: "offset", "rotate", "round", ...
struct Modifier {
  std::string name;
  std::vector<double> values{};  ///< in the order of its parameters
  bool operator==(const Modifier&) const = default;
};

/// A construction tree. A leaf builds a surface from numbers; an inner node combines surfaces.
struct Recipe {
  std::string kind;                   ///< "chazelle", "cylinder", ...; "beside", "nested": combinations
  std::vector<double> values{};       ///< in the order of the kind's parameters
  std::vector<Recipe> parts{};        ///< of a combination, in order
  std::vector<Modifier> modifiers{};  ///< applied one after the other
  bool operator==(const Recipe&) const = default;
};

/// A surface that is closed, 2-manifold, consistently oriented (shells of cavities point into the cavity) and
/// free of self-intersections: proved exactly, or by construction.
struct FuzzSurface {
  TriangleSurface surface;
  Recipe recipe;
  /// What the construction knows; absent where it does not.
  std::optional<std::int64_t> components{}, cavities{}, genus{};
  std::optional<double> volume{};  ///< [length^3] of the triangulated solid, the exact value rounded once
};

struct FuzzOptions {
  std::vector<std::string> kinds{};      ///< only these kinds of leaves; empty: all
  std::vector<std::string> modifiers{};  ///< only these; empty: all but extreme sizes; "none": none
  int most_triangles = 2000;             ///< of a surface; recipes are chosen so that most have 20 to 200
  bool extreme_sizes = false;            ///< also sizes of 1e-60 and 1e60, which hardly any mesher supports
};

/// The recipe of case `index` of `seed`. It depends on these and the options alone: it is the same on every
/// machine and compiler.
Recipe random_recipe(std::uint64_t seed, std::uint64_t index, const FuzzOptions& options = {});

/// The surface of a recipe: the same bytes on every machine and compiler. InputError, one line, if the recipe
/// names an unknown kind or modifier, has values out of range, or if what it builds is no valid surface (the
/// line then says which promise breaks).
FuzzSurface build(const Recipe& recipe);

/// Case `index` of `seed`: `random_recipe` and `build`. Modifiers that break the surface (rounding may let
/// thin walls touch) are left out one by one, the last first; the recipe of the result is without them. Where
/// the surface is not valid even so (a combination may move tiny parts to where doubles are too sparse for
/// them), another recipe is drawn.
FuzzSurface fuzz_surface(std::uint64_t seed, std::uint64_t index, const FuzzOptions& options = {});

/// How far a recipe is from the simplest ones. One surface or modifier more counts a million. Each number
/// counts by its distance from the simplest value of its parameter.
std::int64_t recipe_size(const Recipe& recipe);

/// Simpler recipes to try when a surface is shrunk, the most drastic first: a part instead of the whole, one
/// modifier less, smaller numbers, rounder lengths. Each has a smaller `recipe_size` than `recipe`, so that
/// going on from one to the next ends.
std::vector<Recipe> simpler(const Recipe& recipe);

/// A recipe as one line without spaces, "beside(cylinder(n=32,h=0.001),comb(teeth=4))+offset(x=1e6,y=0,z=0)",
/// with every digit that is needed, and back. InputError with the position, what was expected and found.
/// Parameters that the text does not name have their simplest values; a kind or modifier without any may do
/// without the parentheses.
std::string recipe_text(const Recipe& recipe);
Recipe parse_recipe(std::string_view text);

/// The kinds and modifiers with their parameters, ranges and what they are hard for: a text for users.
std::string list_fuzz_kinds();

}  // namespace tetproof::corpus
