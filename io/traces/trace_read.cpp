// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a trace, line by line.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/error.hpp"
#include "io/traces/trace_keys.hpp"

namespace tetproof::trace {
namespace {

using nlohmann::json;

constexpr std::size_t longest_line = 8 << 20;  // bytes; the indicators of four million vertices in a row
constexpr int deepest = 16;                    // of nested brackets: tets need three

// What a message shows of a value: printable and short, however large or deep it is.
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

constexpr const char* counted[] = {"no", "one", "two", "three", "four", "five", "six"};

class Fields {
 public:
  Fields(const json& record, std::string place, const char* name)
      : record_(record), place_(std::move(place)), name_(name) {}

  void with_defaults() { defaults_ = true; }  // keys after this may be left out
  template <class T>
  void operator()(const char* key, T& value) {
    const json* found = find(key, defaults_);
    if (found && !get(*found, value)) fail(key, what(value), shown(*found));
  }
  void operator()(const char* key, std::optional<double>& value) {
    if (const json* found = find(key, true); found && !found->is_null())
      if (!get(*found, value.emplace())) fail(key, what(*value), shown(*found));
  }
  void choice(const char* key, bool& value, const char* yes, const char* no) {
    std::string word;
    (*this)(key, word);
    if (word != yes && word != no) fail(key, fmt::format("\"{}\" or \"{}\"", yes, no), shown(json(word)));
    value = word == yes;
  }
  void pair(const char* key, double& first, double& second) {
    std::array<double, 2> both{};
    (*this)(key, both);
    first = both[0], second = both[1];
  }
  [[noreturn]] void fail(const char* key, const std::string& expected, const std::string& found) const {
    throw InputError(fmt::format("{}: expected {} as \"{}\" of the {} record, found {}", place_, expected,
                                 key, name_, found));
  }

 private:
  const json* find(const char* key, bool optional) const {
    const auto found = record_.find(key);
    if (found != record_.end()) return &*found;
    if (!optional)
      throw InputError(
          fmt::format("{}: expected a key \"{}\" in the {} record, found none", place_, key, name_));
    return nullptr;
  }

  template <class T>
  static bool integer(const json& from, T& value) {
    if (from.is_number_unsigned() &&
        from.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<T>::max()))
      return false;
    if (!from.is_number_integer()) return false;
    const std::int64_t wide = from.get<std::int64_t>();
    value = static_cast<T>(wide);
    return wide >= 0 && value == wide;
  }
  static bool get(const json& from, int& value) { return integer(from, value); }
  static bool get(const json& from, std::int64_t& value) { return integer(from, value); }
  static bool get(const json& from, bool& value) { return from.is_boolean() && (value = from, true); }
  static bool get(const json& from, double& value) {
    return from.is_number() && std::isfinite(value = from.get<double>());
  }
  static bool get(const json& from, std::string& value) {
    return from.is_string() && (value = from.get_ref<const std::string&>(), true);
  }
  static bool get(const json& from, Point& value) {
    return from.is_array() && from.size() == 3 && get(from[0], value[0]) && get(from[1], value[1]) &&
           get(from[2], value[2]);
  }
  template <class T, std::size_t n>
  static bool get(const json& from, std::array<T, n>& values) {
    if (!from.is_array() || from.size() != n) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (!get(from[i], values[i])) return false;
    return true;
  }
  static bool get(const json& from, std::vector<int>& values) {
    if (!from.is_array() || from.size() > 4) return false;
    values.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      if (!get(from[i], values[i])) return false;
    return true;
  }

  static std::string what(int) { return "an integer from 0 on"; }
  static std::string what(std::int64_t) { return "an integer from 0 on"; }
  static std::string what(bool) { return "true or false"; }
  static std::string what(double) { return "a number"; }
  static std::string what(const std::string&) { return "a string"; }
  static std::string what(const Point&) { return "a point [x, y, z]"; }
  static std::string what(const std::vector<int>&) { return "two to four positions"; }
  template <class T, std::size_t n>
  static std::string what(const std::array<T, n>&) {
    constexpr bool vertices = std::is_same_v<T, LatticeVertex>;
    return fmt::format("{} {}", counted[n],
                       std::is_same_v<T, Point>         ? "points [x, y, z]"
                       : vertices                       ? "lattice vertices [i, j, k]"
                       : std::is_same_v<T, std::string> ? "strings"
                       : std::is_same_v<T, double>      ? "numbers"
                                                        : "integers from 0 on");
  }

  const json& record_;
  std::string place_;
  const char* name_;
  bool defaults_ = false;
};

// What the types alone do not say.
template <class R>
void check(const R& r, const Fields& fields) {
  if constexpr (std::is_same_v<R, Indicators>) {
    for (const auto& [key, text] : {std::pair{"initial", &r.initial}, std::pair{"after", &r.after}})
      if (text->empty() || text->find_first_not_of("-0+") != std::string::npos)
        fields.fail(key, "a string of -, 0 and +", shown(json(*text)));
    if (r.initial.size() != r.after.size())
      fields.fail("after", fmt::format("{} indicators as in \"initial\"", r.initial.size()),
                  std::to_string(r.after.size()));
  } else if constexpr (std::is_same_v<R, Lattice>) {
    if (std::count(r.cells.begin(), r.cells.end(), 0))
      fields.fail("cells", "three integers from 1 on", shown(json(r.cells)));
  } else if constexpr (std::is_same_v<R, Insertion>) {
    constexpr std::string_view rows[] = {"0", "1", "2a", "2b", "3a", "3b", "4a", "4b", "4c", "4d", "4e"};
    if (std::find(std::begin(rows), std::end(rows), r.row) == std::end(rows))
      fields.fail("row", fmt::format("a row of Table 4 ({})", fmt::join(rows, ", ")), shown(json(r.row)));
    std::vector<int> positions = r.replaced;
    std::sort(positions.begin(), positions.end());
    if (positions.size() < 2 || positions.back() > 3 ||
        std::adjacent_find(positions.begin(), positions.end()) != positions.end())
      fields.fail("replaced", "two to four different positions from 0 to 3", shown(json(r.replaced)));
    if (r.n == 0) fields.fail("n", "an integer from 1 on", "0");
  }
}

template <std::size_t i = 0>
std::optional<Record> read(const json& from, const std::string& name, const std::string& place) {
  if constexpr (i == names.size()) {
    return std::nullopt;
  } else {
    if (name != names[i]) return read<i + 1>(from, name, place);
    std::variant_alternative_t<i, Record> record;
    Fields fields(from, place, names[i]);
    describe(record, fields);
    check(record, fields);
    return record;
  }
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

}  // namespace

Reader::Reader(const std::string& path) : path_(path) {
  const auto fail = [&](const char* what, int reason) {
    throw InputError(fmt::format("{}: {}: {}", path, what, std::strerror(reason)));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("cannot read", EISDIR);
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) fail("cannot open", errno ? errno : EIO);
}

bool Reader::read_line() {
  text_.clear();
  char part[1 << 14];
  for (;;) {
    file_.getline(part, sizeof part);  // of a longer line it takes what fits, and fails
    const bool whole = !file_.fail();
    text_.append(part, file_.gcount() - (whole && !file_.eof() ? 1 : 0));
    if (file_.bad()) throw InputError(fmt::format("{}: cannot read: {}", path_, std::strerror(errno)));
    if (whole || file_.eof()) break;
    if (text_.size() > longest_line)
      throw InputError(fmt::format("{}:{}: expected a line of at most {} bytes, found a longer one", path_,
                                   line_ + 1, longest_line));
    file_.clear();
  }
  if (file_.eof() && text_.empty()) return false;
  ++line_;
  return true;
}

std::optional<Record> Reader::next() {
  while (read_line()) {
    if (text_.find_first_not_of(" \t\r\v\f") == std::string::npos) continue;
    const std::string place = fmt::format("{}:{}", path_, line_);
    const json value = parse(text_, place);
    const auto name = value.find("record");
    if (name == value.end() || !name->is_string())
      throw InputError(
          fmt::format("{}: expected a key \"record\" that names the kind of this record, found {}", place,
                      name == value.end() ? "none" : shown(*name)));
    if (std::optional<Record> record = read(value, name->get_ref<const std::string&>(), place)) return record;
  }
  return std::nullopt;
}

}  // namespace tetproof::trace
