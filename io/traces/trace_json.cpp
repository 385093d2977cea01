// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/traces/trace_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "io/error.hpp"

namespace tetproof::trace {
namespace {

using nlohmann::json;

constexpr int deepest = 16;  // levels of nested brackets; tetrahedra need three

// A value as a message shows it: printable and short, however large or deep the value is.
std::string shown(const json& value, int depth = 0) {
  if (value.is_array() || value.is_object()) {
    if (depth == 2) return value.is_array() ? "[...]" : "{...}";
    std::string text = value.is_array() ? "[" : "{";
    for (auto item = value.begin(); item != value.end() && text.size() < 60; ++item) {
      if (value.is_object()) text += shown(json(item.key())) + ":";
      text += shown(*item, depth + 1) + (std::next(item) == value.end() ? "" : ",");
    }
    return text.size() < 60 ? text + (value.is_array() ? "]" : "}") : text.substr(0, 60) + "...";
  }
  std::string text;
  for (const char c : value.dump(-1, ' ', true).substr(0, 60)) text += c >= ' ' && c <= '~' ? c : '?';
  return text.size() < 60 ? text : text + "...";
}

json parse(const std::string& line, const std::string& place) {
  const auto not_too_deep = [&](int depth, json::parse_event_t, const json&) {
    if (depth > deepest)
      throw InputError(fmt::format("{}: expected at most {} nested brackets, found more", place, deepest));
    return true;
  };
  json value;
  try {
    value = json::parse(line, not_too_deep);
  } catch (const json::parse_error& error) {
    const std::size_t at = std::min(line.size(), error.byte > 0 ? error.byte - 1 : 0);
    std::string rest;
    for (const char c : line.substr(at, 30)) rest += c >= ' ' && c <= '~' ? c : '?';
    throw InputError(fmt::format("{}: expected a record as JSON in one line, found {} at column {}", place,
                                 rest.empty() ? "the end of the line" : fmt::format("'{}'", rest), at + 1));
  } catch (const json::out_of_range&) {
    throw InputError(fmt::format("{}: expected numbers that a double can hold, found a larger one", place));
  }
  if (!value.is_object())
    throw InputError(fmt::format("{}: expected a record as a JSON object, found {}", place, shown(value)));
  return value;
}

template <class T>
bool integer(const json& from, T& value) {
  if (from.is_number_unsigned() &&
      from.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<T>::max()))
    return false;
  if (!from.is_number_integer()) return false;
  const std::int64_t wide = from.get<std::int64_t>();
  value = static_cast<T>(wide);
  return wide >= 0 && value == wide;
}
bool get(const json& from, int& value) {
  return integer(from, value);
}
bool get(const json& from, std::int64_t& value) {
  return integer(from, value);
}
bool get(const json& from, bool& value) {
  return from.is_boolean() && (value = from, true);
}
bool get(const json& from, double& value) {
  return from.is_number() && std::isfinite(value = from.get<double>());
}
bool get(const json& from, std::string& value) {
  return from.is_string() && (value = from.get_ref<const std::string&>(), true);
}
bool get(const json& from, Point& value) {
  return from.is_array() && from.size() == 3 && get(from[0], value[0]) && get(from[1], value[1]) &&
         get(from[2], value[2]);
}
template <class T, std::size_t n>
bool get(const json& from, std::array<T, n>& values) {
  if (!from.is_array() || from.size() != n) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (!get(from[i], values[i])) return false;
  return true;
}
bool get(const json& from, std::vector<int>& values) {
  if (!from.is_array() || from.size() > 4) return false;
  values.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!get(from[i], values[i])) return false;
  return true;
}

constexpr const char* counted[] = {"no", "one", "two", "three", "four", "five", "six"};

std::string what(int) {
  return "an integer from 0 on";
}
std::string what(std::int64_t) {
  return "an integer from 0 on";
}
std::string what(bool) {
  return "true or false";
}
std::string what(double) {
  return "a number";
}
std::string what(const std::string&) {
  return "a string";
}
std::string what(const Point&) {
  return "a point [x, y, z]";
}
std::string what(const std::vector<int>&) {
  return "two to four positions";
}
template <class T, std::size_t n>
std::string what(const std::array<T, n>&) {
  constexpr bool vertices = std::is_same_v<T, LatticeVertex>;
  return fmt::format("{} {}", counted[n],
                     std::is_same_v<T, Point>         ? "points [x, y, z]"
                     : vertices                       ? "lattice vertices [i, j, k]"
                     : std::is_same_v<T, std::string> ? "strings"
                     : std::is_same_v<T, double>      ? "numbers"
                                                      : "integers from 0 on");
}

}  // namespace

JsonLine::JsonLine(const std::string& text, std::string place)
    : place_(std::move(place)), object_(std::make_unique<const json>(parse(text, place_))) {
  const auto name = object_->find("record");
  if (name == object_->end() || !name->is_string())
    throw InputError(fmt::format("{}: expected a key \"record\" that names the kind of this record, found {}",
                                 place_, name == object_->end() ? "none" : shown(*name)));
}

JsonLine::~JsonLine() = default;

const std::string& JsonLine::kind() const {
  return object_->find("record")->get_ref<const std::string&>();
}

const json* Fields::find(const char* key, bool optional) const {
  const auto found = line_.object().find(key);
  if (found != line_.object().end()) return &*found;
  if (!optional)
    throw InputError(
        fmt::format("{}: expected a key \"{}\" in the {} record, found none", line_.place(), key, name_));
  return nullptr;
}

template <class T>
void Fields::operator()(const char* key, T& value) {
  const json* found = find(key, defaults_);
  if (found && !get(*found, value)) fail(key, what(value));
}

template void Fields::operator()(const char*, bool&);
template void Fields::operator()(const char*, int&);
template void Fields::operator()(const char*, std::int64_t&);
template void Fields::operator()(const char*, double&);
template void Fields::operator()(const char*, std::string&);
template void Fields::operator()(const char*, Point&);
template void Fields::operator()(const char*, std::vector<int>&);
template void Fields::operator()(const char*, std::array<int, 3>&);
template void Fields::operator()(const char*, std::array<LatticeVertex, 2>&);
template void Fields::operator()(const char*, std::array<Point, 2>&);
template void Fields::operator()(const char*, std::array<Point, 3>&);
template void Fields::operator()(const char*, std::array<Point, 4>&);
template void Fields::operator()(const char*, std::array<std::string, 6>&);

void Fields::operator()(const char* key, std::optional<double>& value) {
  if (const json* found = find(key, true); found && !found->is_null())
    if (!get(*found, value.emplace())) fail(key, what(*value));
}

void Fields::choice(const char* key, bool& value, const char* yes, const char* no) {
  std::string word;
  (*this)(key, word);
  if (word != yes && word != no) fail(key, fmt::format("\"{}\" or \"{}\"", yes, no));
  value = word == yes;
}

void Fields::pair(const char* key, double& first, double& second) {
  std::array<double, 2> both{};
  (*this)(key, both);
  first = both[0], second = both[1];
}

void Fields::fail(const char* key, const std::string& expected) const {
  const json* found = find(key, true);
  fail(key, expected, found ? shown(*found) : "none");
}

void Fields::fail(const char* key, const std::string& expected, const std::string& found) const {
  throw InputError(fmt::format("{}: expected {} as \"{}\" of the {} record, found {}", line_.place(),
                               expected, key, name_, found));
}

}  // namespace tetproof::trace
