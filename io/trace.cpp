// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "io/error.hpp"
#include "io/text_output.hpp"

namespace tetproof::trace {
namespace {

using nlohmann::json;

constexpr std::size_t longest_line = 8 << 20;  // bytes; the indicators of four million vertices in a row
constexpr int deepest = 16;                    // of nested brackets: tets need three

// The keys of a record in the order in which they are written; `field` reads or writes each.
template <class R, class Fields>
void describe(R& r, Fields& field) {
  using T = std::remove_const_t<R>;
  if constexpr (std::is_same_v<T, Settings>) {
    field.with_defaults();
    field("program", r.program), field("surface", r.surface), field("region", r.region);
    field("box_scale", r.box_scale), field("on_surface", r.on_surface), field("diagonals", r.diagonals);
    field("literal", r.literal), field("p", r.p), field("curvature", r.curvature);
    field("parametric", r.parametric), field("improve", r.improve), field("improve_below", r.improve_below);
    field("points", r.points), field("past_dilution", r.past_dilution);
  } else if constexpr (std::is_same_v<T, Lattice>) {
    field("box", r.box), field("cells", r.cells);
  } else if constexpr (std::is_same_v<T, Indicators>) {
    field("j", r.j), field("k", r.k), field("initial", r.initial), field("after", r.after);
  } else if constexpr (std::is_same_v<T, Moved>) {
    field("vertex", r.vertex), field("point", r.point), field.with_defaults(), field("mended", r.mended);
  } else if constexpr (std::is_same_v<T, Cut>) {
    field("edge", r.edge), field("point", r.point);
  } else if constexpr (std::is_same_v<T, Rows>) {
    field("cell", r.cell), field("rows", r.rows);
  } else if constexpr (std::is_same_v<T, Mapped>) {
    field("from", r.from), field("to", r.to);
  } else if constexpr (std::is_same_v<T, FirstGrid>) {
    field("points", r.points), field("tets", r.tets), field("mean_volume", r.mean_volume);
    field("v0", r.v0), field("v1", r.v1), field("d1", r.d1);
    field("kappa_min", r.kappa_min), field("kappa_max", r.kappa_max), field("e_avg", r.e_avg);
  } else if constexpr (std::is_same_v<T, Weight>) {
    field("tet", r.tet), field("d", r.d), field("kappa", r.kappa), field("omega", r.omega);
    field("volume", r.volume), field("desired", r.desired), field("error", r.error);
  } else if constexpr (std::is_same_v<T, Insertion>) {
    field("n", r.n), field("tet", r.tet), field("row", r.row), field("replaced", r.replaced);
    field("point", r.point), field("e_avg", r.e_avg);
  } else if constexpr (std::is_same_v<T, Flip>) {
    field.choice("kind", r.two_to_three, "2-3", "3-2"), field("face", r.face), field("edge", r.edge);
    field.pair("quality", r.quality_before, r.quality_after), field("e_avg", r.e_avg);
  } else {
    static_assert(std::is_same_v<T, End>);
    field("stopped", r.stopped), field("insertions", r.insertions), field("flips", r.flips);
    field("refused", r.refused), field("points", r.points), field("tets", r.tets), field("e_avg", r.e_avg);
  }
}

// In the order of the variant.
constexpr std::array<const char*, std::variant_size_v<Record>> names{
    "settings", "lattice",    "indicators", "moved",     "cut",  "rows",
    "mapped",   "first_grid", "weight",     "insertion", "flip", "end"};

class Writer {
 public:
  explicit Writer(const char* name) : line_(fmt::format("{{\"record\":\"{}\"", name)) {}
  std::string line() && { return std::move(line_) + "}"; }

  void with_defaults() {}
  template <class T>
  void operator()(const char* key, const T& value) {
    name(key);
    put(value);
  }
  void operator()(const char* key, const std::optional<double>& value) {
    if (value) (*this)(key, *value);
  }
  void choice(const char* key, bool value, const char* yes, const char* no) {
    name(key);
    line_ += fmt::format("\"{}\"", value ? yes : no);
  }
  void pair(const char* key, double first, double second) { (*this)(key, std::array{first, second}); }

 private:
  void name(const char* key) { line_ += fmt::format(",\"{}\":", key); }
  void put(bool value) { line_ += value ? "true" : "false"; }
  void put(int value) { line_ += std::to_string(value); }
  void put(std::int64_t value) { line_ += std::to_string(value); }
  void put(double value) {
    if (!std::isfinite(value)) throw std::logic_error("a trace was given a number that is not finite");
    char text[io::longest_real];
    if (value == 0 && std::signbit(value))
      line_ += "-0.0";  // a JSON reader may take -0 for an integer
    else
      line_.append(text, io::put(text, value));
  }
  void put(const std::string& value) {
    line_ += json(value).dump(-1, ' ', false, json::error_handler_t::replace);
  }
  void put(const Point& value) { put(std::array{value[0], value[1], value[2]}); }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& values) {
    list(values);
  }
  void put(const std::vector<int>& values) { list(values); }
  template <class Values>
  void list(const Values& values) {
    line_ += '[';
    for (const auto& value : values) put(value), line_ += ',';
    if (!values.empty()) line_.pop_back();
    line_ += ']';
  }

  std::string line_;
};

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

std::string to_line(const Record& record) {
  Writer writer(name_of(record));
  std::visit([&](const auto& r) { describe(r, writer); }, record);
  return std::move(writer).line();
}

const char* name_of(const Record& record) {
  return names[record.index()];
}

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
