// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/generators/spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "io/bytes/scanner.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

// The text as messages show it: printable ASCII, and at most 80 characters.
std::string shown(std::string_view text) {
  std::string out;
  for (char c : text.substr(0, 80)) out += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > 80 ? out + "..." : out;
}

std::string known_keys(const Generator& generator) {
  std::string keys;
  for (const Parameter& p : generator.parameters) keys += (keys.empty() ? "" : ", ") + std::string(p.key);
  return keys;
}

double parse_value(const Values& values, const Parameter& parameter, std::string_view text) {
  const auto refuse = [&](std::string_view expected) {
    values.refuse(fmt::format("{}: expected {}, found '{}'", parameter.key, expected, shown(text)));
  };
  double value = 0;
  if (parameter.kind == Kind::four_digits) {
    const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (text.size() != 4 || !digits) refuse("four digits");
    for (char c : text) value = 10 * value + (c - '0');
    return value;
  }
  if (!parse_real(text, value) || !std::isfinite(value)) refuse("a finite number");
  if (parameter.kind == Kind::integer && value != std::floor(value)) refuse("a whole number");
  if (value < parameter.least || value > parameter.most)
    refuse(number_text(parameter.least) + " to " + number_text(parameter.most));
  return value;
}

}  // namespace

Values::Values(const Generator& generator, std::string spec)
    : generator_(&generator), spec_(std::move(spec)) {
  for (const Parameter& p : generator.parameters) values_.push_back(p.preset);
}

double Values::operator[](std::string_view key) const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (key == generator_->parameters[i].key) return values_[i];
  throw std::logic_error(fmt::format("the generator {} has no parameter {}", generator_->name, key));
}

void Values::set(std::string_view key, double value) {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (key == generator_->parameters[i].key) values_[i] = value;
}

void Values::refuse(const std::string& message) const {
  throw InputError(fmt::format("{}: {}", shown(spec_), message));
}

std::string number_text(double x) {
  const std::string shortest = fmt::format("{:g}", x);
  double same;
  return parse_real(shortest, same) && same == x ? shortest : fmt::format("{}", x);
}

Values parse_values(const Generator& generator, const std::string& spec) {
  Values values(generator, spec);
  const std::size_t colon = spec.find(':');
  if (colon == std::string::npos) return values;
  std::string_view rest = std::string_view(spec).substr(colon + 1);
  std::vector<std::string_view> seen;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string_view item = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos)
      values.refuse(
          fmt::format("expected key=value, found '{}' (known keys: {})", shown(item), known_keys(generator)));
    const std::string_view key = item.substr(0, equals);
    const auto parameter = std::find_if(generator.parameters.begin(), generator.parameters.end(),
                                        [&](const Parameter& p) { return key == p.key; });
    if (parameter == generator.parameters.end())
      values.refuse(fmt::format("unknown key '{}' (known keys: {})", shown(key), known_keys(generator)));
    if (std::find(seen.begin(), seen.end(), key) != seen.end())
      values.refuse(fmt::format("the key '{}' is given twice", shown(key)));
    seen.push_back(key);
    values.set(key, parse_value(values, *parameter, item.substr(equals + 1)));
  }
  return values;
}

}  // namespace tetproof::corpus
