// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a generator of surfaces, and the parser of "name:key=value,..." for its parameters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// How the text of a parameter is read.
enum class Kind {
  real,         ///< any finite decimal number
  integer,      ///< a whole number
  four_digits,  ///< exactly four digits, as in the names of NACA sections; their value as a number
};

/// One parameter of a generator, written in one line: {"r", 1, 1e-9, 1e9, "radius"}. A value outside [least,
/// most] is refused.
struct Parameter {
  const char* key;
  double preset;
  double least, most;
  const char* meaning;
  Kind kind = Kind::real;
};

struct Generator;

/// The values of the parameters of one surface.
class Values {
 public:
  Values(const Generator& generator, std::string spec);

  /// The value of `key`. Throws std::logic_error if the generator has no such parameter.
  double operator[](std::string_view key) const;
  Eigen::Vector3d vector(const char* x, const char* y, const char* z) const {
    return {(*this)[x], (*this)[y], (*this)[z]};
  }
  void set(std::string_view key, double value);

  const std::string& spec() const { return spec_; }
  /// Throws InputError with the text "SPEC: MESSAGE".
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  const Generator* generator_;
  std::string spec_;
  std::vector<double> values_;
};

/// A family of surfaces. Written with designated initialisers.
struct Generator {
  const char* name;
  const char* meaning;
  std::vector<Parameter> parameters;
  const char* volume_text;                 ///< the formula or the method behind `volume`, for users
  TriangleSurface (*make)(const Values&);  ///< throws InputError for values that give no valid surface
  std::optional<double> (*volume)(const Values&);  ///< of the smooth body [length^3]
};

/// A number as messages and lists show it: short, as 1e+09 for 1000000000, but with all its digits.
std::string number_text(double x);

/// Reads "name:key=value,key=value" or "name", where `name` is that of `generator`. Throws InputError with
/// one line: for an unknown key it names the key and the known ones, for a bad value the value and what was
/// expected.
Values parse_values(const Generator& generator, const std::string& spec);

}  // namespace tetproof::corpus
