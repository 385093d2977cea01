// SPDX-License-Identifier: GPL-3.0-or-later
// What a generator of surfaces is, and how "name:key=value,..." becomes its parameters.
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
  four_digits,  ///< exactly four digits, as NACA's names have them; its value is the number they spell
};

/// One parameter of a generator. A value outside [least, most] is refused.
struct Parameter {
  const char* key;
  double preset;
  double least, most;
  const char* meaning;
  Kind kind = Kind::real;
};

struct Generator;

/// The parameters of one surface, in the order of its generator's list.
class Values {
 public:
  Values(const Generator& generator, std::string spec);

  /// The value of `key`, which the generator must have: std::logic_error otherwise.
  double operator[](std::string_view key) const;
  Eigen::Vector3d vector(const char* x, const char* y, const char* z) const {
    return {(*this)[x], (*this)[y], (*this)[z]};
  }
  void set(std::string_view key, double value);

  const std::string& spec() const { return spec_; }
  /// InputError: "SPEC: MESSAGE".
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  const Generator* generator_;
  std::string spec_;
  std::vector<double> values_;
};

/// A family of surfaces.
struct Generator {
  const char* name;
  const char* meaning;
  std::vector<Parameter> parameters;
  const char* volume_text;                 ///< how the smooth body's volume is known
  TriangleSurface (*make)(const Values&);  ///< throws InputError for combinations that give no surface
  std::optional<double> (*volume)(const Values&);  ///< of the smooth body [length^3]
};

/// A number as messages and lists show it: 1e+09 rather than 1000000000, but with all its digits.
std::string number_text(double x);

/// Reads "name:key=value,key=value" or "name" for `generator`, whose name it starts with. InputError with one
/// line naming the key and the known ones, or the value and what was expected.
Values parse_values(const Generator& generator, const std::string& spec);

}  // namespace tetproof::corpus
