// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the kinds of random surfaces and of their modifiers: names, parameters, how each is made.
// Internal. A new kind is an entry in the list of its theme.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "corpus/fuzz/shape.hpp"
#include "corpus/generators/random.hpp"

namespace tetproof::corpus {

/// How a random recipe draws a parameter, and what values it has.
enum class Draw {
  integer,  ///< a whole number, the smaller ones more often
  length,   ///< each power of ten as often as any other; three digits
  share,    ///< uniform; three decimals
  seed,     ///< a whole number, of the surface's own random numbers
};

/// One parameter. Values outside [least, most] are refused; random recipes have values in [low, high].
struct FuzzParameter {
  const char* key;
  Draw draw;
  double least, most;
  double low, high;
  double simplest;  ///< what shrinking aims at, and the value if a recipe does not name the parameter
  const char* meaning;

  bool whole() const { return draw == Draw::integer || draw == Draw::seed; }
};

/// The values of a recipe or modifier by the names of its parameters.
class Numbers {
 public:
  Numbers(const std::vector<FuzzParameter>& parameters, std::span<const double> values)
      : parameters_(&parameters), values_(values) {}
  /// Throws std::logic_error if there is no such parameter.
  double operator[](std::string_view key) const;
  int integer(std::string_view key) const { return static_cast<int>((*this)[key]); }
  Random random() const { return Random(static_cast<std::uint64_t>((*this)["seed"])); }

 private:
  const std::vector<FuzzParameter>* parameters_;
  std::span<const double> values_;
};

/// A family of closed surfaces that are valid by construction; the argument stands beside `make`.
struct FuzzKind {
  const char* name;
  const char* meaning;
  const char* hard_for;
  std::vector<FuzzParameter> parameters;
  Shape (*make)(const Numbers&);  ///< throws InputError, "KEY: MESSAGE", for values that do not go together
};

/// A way to make one surface of several. Each part's place follows from its bounding box.
struct FuzzCombination {
  const char* name;
  const char* meaning;
  std::vector<FuzzParameter> parameters;
  std::size_t least_parts, most_parts;
  Shape (*make)(const Numbers&, const std::vector<Shape>& parts);
};

/// A change of a whole surface. In exact arithmetic it keeps a surface valid; rounding may break thin ones.
struct FuzzModifier {
  const char* name;
  const char* meaning;
  std::vector<FuzzParameter> parameters;
  void (*apply)(TriangleSurface&, const Numbers&);
  int stage;  ///< random recipes apply modifiers in the order of their stages
};

std::vector<FuzzKind> revolved_kinds();   // revolved_kinds.cpp
std::vector<FuzzKind> sphere_kinds();     // sphere_kinds.cpp
std::vector<FuzzKind> cell_kinds();       // cell_kinds.cpp
std::vector<FuzzKind> flat_kinds();       // flat_kinds.cpp
std::vector<FuzzKind> hull_kinds();       // hull_kinds.cpp
std::vector<FuzzKind> twisted_kinds();    // twisted_kinds.cpp
std::vector<FuzzKind> chazelle_kinds();   // chazelle.cpp
std::vector<FuzzKind> assembled_kinds();  // assembled_kinds.cpp

const std::vector<FuzzKind>& fuzz_kinds();
const std::vector<FuzzCombination>& fuzz_combinations();  // combinations.cpp
const std::vector<FuzzModifier>& fuzz_modifiers();        // modifiers.cpp

/// Null if there is none of this name.
const FuzzKind* find_kind(std::string_view name);
const FuzzCombination* find_combination(std::string_view name);
const FuzzModifier* find_modifier(std::string_view name);

/// The parameters of a kind or combination. Null if there is none of this name.
const std::vector<FuzzParameter>* parameters_of(std::string_view kind);

/// A parameter that is the seed of a surface's own random numbers.
inline FuzzParameter seed_parameter() {
  return {"seed", Draw::seed, 0, 9007199254740992, 0, 999999, 0, "of the surface's own random numbers"};
}

}  // namespace tetproof::corpus
