// SPDX-License-Identifier: GPL-3.0-or-later
// Recipes as text: "beside(gap=1,cylinder(n=32,h=0.001),comb(teeth=4))+offset(x=1e+06,y=0,z=0)".
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/recipe_rules.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/generators/spec.hpp"
#include "io/bytes/scanner.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

std::string values_text(const std::vector<FuzzParameter>* parameters, const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool named = parameters && i < parameters->size();
    text +=
        fmt::format("{}{}={}", i > 0 ? "," : "", named ? (*parameters)[i].key : "?", number_text(values[i]));
  }
  return text;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Recipe whole() {
    Recipe result = recipe(0);
    if (at_ < text_.size()) refuse("'+' or the end");
    return result;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t leaves_ = 0;

  [[noreturn]] void refuse(const std::string& expected, std::size_t at) const {
    std::string found;
    for (char c : text_.substr(at, 20)) found += c >= ' ' && c <= '~' ? c : '?';
    throw InputError(fmt::format("at character {}: expected {}, found {}", at + 1, expected,
                                 found.empty() ? "the end" : "'" + found + "'"));
  }
  [[noreturn]] void refuse(const std::string& expected) const { refuse(expected, at_); }

  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) refuse(fmt::format("'{}'", c));
  }
  std::string_view word() {
    const auto end =
        std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(),
                         [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
    const std::string_view found = text_.substr(at_, static_cast<std::size_t>(end - text_.begin()) - at_);
    at_ += found.size();
    return found;
  }
  // True if a name and '=' come next, false if a name and anything else.
  bool key_is_next() const {
    Parser ahead = *this;
    return !ahead.word().empty() && ahead.take('=');
  }

  void value(std::string_view name, const std::vector<FuzzParameter>& parameters, std::vector<double>& values,
             std::vector<char>& given) {
    const std::size_t start = at_;
    const std::string_view key = word();
    const auto parameter = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const FuzzParameter& p) { return key == p.key; });
    if (parameter == parameters.end()) {
      std::string known;
      for (const FuzzParameter& p : parameters) known += (known.empty() ? "" : ", ") + std::string(p.key);
      refuse(known.empty() ? fmt::format("no parameter of {}", name)
                           : fmt::format("a parameter of {} ({})", name, known),
             start);
    }
    const std::size_t i = static_cast<std::size_t>(parameter - parameters.begin());
    if (given[i]) refuse(fmt::format("'{}' only once", key), start);
    given[i] = 1;
    expect('=');
    // A '+' ends the number, except the sign of its exponent or its first character.
    std::size_t end = at_;
    while (end < text_.size() && text_[end] != ',' && text_[end] != ')' && text_[end] != '(' &&
           !(text_[end] == '+' && end > at_ && text_[end - 1] != 'e' && text_[end - 1] != 'E'))
      ++end;
    double x = 0;
    if (!parse_real(text_.substr(at_, end - at_), x) || !std::isfinite(x)) refuse("a finite number");
    if (parameter->whole() && x != std::floor(x)) refuse("a whole number");
    if (!(x >= parameter->least && x <= parameter->most))
      refuse(fmt::format("{} to {}", number_text(parameter->least), number_text(parameter->most)));
    values[i] = x + 0.0;  // no negative zero
    at_ = end;
  }

  static std::vector<double> presets(const std::vector<FuzzParameter>& parameters) {
    std::vector<double> values;
    for (const FuzzParameter& p : parameters) values.push_back(p.simplest);
    return values;
  }

  Recipe recipe(int depth) {
    if (depth > deepest_recipe) refuse(fmt::format("at most {} combinations in one another", deepest_recipe));
    const std::size_t start = at_;
    Recipe result;
    result.kind = word();
    const std::vector<FuzzParameter>* parameters = parameters_of(result.kind);
    if (!parameters) refuse("a kind of random surface", start);
    const FuzzCombination* combination = find_combination(result.kind);
    if (!combination && ++leaves_ > most_leaves)
      refuse(fmt::format("at most {} surfaces", most_leaves), start);
    result.values = presets(*parameters);
    std::vector<char> given(parameters->size(), 0);
    if (take('(') && !take(')')) {
      do {
        if (combination && !key_is_next()) {
          result.parts.push_back(recipe(depth + 1));
        } else {
          value(result.kind, *parameters, result.values, given);
        }
      } while (take(','));
      if (!take(')')) refuse("',' or ')'");
    }
    if (combination &&
        (result.parts.size() < combination->least_parts || result.parts.size() > combination->most_parts))
      refuse(fmt::format("{} with {} to {} parts", result.kind, combination->least_parts,
                         combination->most_parts),
             start);
    while (take('+')) result.modifiers.push_back(modifier());
    return result;
  }

  Modifier modifier() {
    const std::size_t start = at_;
    Modifier result;
    result.name = word();
    const FuzzModifier* known = find_modifier(result.name);
    if (!known) refuse("a modifier", start);
    result.values = presets(known->parameters);
    std::vector<char> given(known->parameters.size(), 0);
    if (take('(') && !take(')')) {
      do value(result.name, known->parameters, result.values, given);
      while (take(','));
      if (!take(')')) refuse("',' or ')'");
    }
    return result;
  }
};

}  // namespace

std::string recipe_text(const Recipe& recipe) {
  std::string inside = values_text(parameters_of(recipe.kind), recipe.values);
  for (const Recipe& part : recipe.parts)
    inside += fmt::format("{}{}", inside.empty() ? "" : ",", recipe_text(part));
  std::string text = recipe.kind + "(" + inside + ")";
  for (const Modifier& modifier : recipe.modifiers) {
    const FuzzModifier* known = find_modifier(modifier.name);
    text += fmt::format("+{}({})", modifier.name,
                        values_text(known ? &known->parameters : nullptr, modifier.values));
  }
  return text;
}

Recipe parse_recipe(std::string_view text) {
  return Parser(text).whole();
}

}  // namespace tetproof::corpus
