// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutation/trace_mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tetproof::mutation {
namespace {

using Json = nlohmann::ordered_json;
using Random = std::mt19937_64;
using Texts = std::vector<std::string>;

std::size_t below(std::size_t n, Random& random) {
  return static_cast<std::size_t>(random() % n);
}
template <class Values>
const auto& one_of(const Values& values, Random& random) {
  return values[below(values.size(), random)];
}

// The step to which a kind of records belongs: 1 for (i) to (iv), 2 for (v), 3 for (vi).
int step_of(const std::string& kind) {
  if (kind == "first_grid" || kind == "weight") return 2;
  return kind == "insertion" || kind == "flip" || kind == "end" ? 3 : 1;
}

// A trace as JSON, a record a line.
class Trace {
 public:
  explicit Trace(const Texts& lines) {
    for (const std::string& line : lines) add(size(), Json::parse(line));
  }
  std::size_t size() const { return records_.size(); }
  Json& operator[](std::size_t i) { return records_[i]; }
  const std::string& kind(std::size_t i) const { return kinds_[i]; }
  void add(std::size_t at, const Json& record) {
    records_.insert(records_.begin() + static_cast<std::ptrdiff_t>(at), record);
    kinds_.insert(kinds_.begin() + static_cast<std::ptrdiff_t>(at), record.at("record").get<std::string>());
  }
  void drop(std::size_t at) {
    records_.erase(records_.begin() + static_cast<std::ptrdiff_t>(at));
    kinds_.erase(kinds_.begin() + static_cast<std::ptrdiff_t>(at));
  }
  void exchange_with_next(std::size_t at) {
    std::swap(records_[at], records_[at + 1]);
    std::swap(kinds_[at], kinds_[at + 1]);
  }
  std::vector<std::size_t> of_kind(const std::string& kind) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < size(); ++i)
      if (kinds_[i] == kind) all.push_back(i);
    return all;
  }
  Texts kinds() const {
    Texts all;
    for (const std::string& kind : kinds_)
      if (std::find(all.begin(), all.end(), kind) == all.end()) all.push_back(kind);
    return all;
  }
  // The first record of a later step than `step`, from `at` on; the last record if there is none.
  std::size_t after(int step, std::size_t at = 0) const {
    while (at + 1 < size() && step_of(kinds_[at]) <= step) ++at;
    return at;
  }
  std::string text() const {
    std::string all;
    for (const Json& record : records_) all += record.dump() + "\n";
    return all;
  }

  // What the record is about, if only one record may be about it.
  std::string name(std::size_t i) const {
    const auto get = [&](const char* key) { return records_[i].contains(key) ? records_[i][key] : Json(); };
    const auto in_order = [](Json all) {
      if (all.is_array()) std::sort(all.begin(), all.end());
      return all.dump();
    };
    const std::string& kind = kinds_[i];
    if (kind == "indicators") return kind + get("j").dump() + get("k").dump();
    if (kind == "moved") return kind + get("vertex").dump();
    if (kind == "cut") return kind + in_order(get("edge"));
    if (kind == "rows") return kind + get("cell").dump();
    if (kind == "mapped") return kind + get("from").dump();
    if (kind == "weight") return kind + in_order(get("tet"));
    return kind + std::to_string(i);
  }
  // The lines of a record and of all others with its name.
  void add_lines(std::size_t i, std::set<std::int64_t>& lines) const {
    const std::string named = name(i);
    for (std::size_t k = 0; k < size(); ++k)
      if (k == i || (kinds_[k] == kinds_[i] && name(k) == named))
        lines.insert(static_cast<std::int64_t>(k) + 1);
  }

 private:
  std::vector<Json> records_;
  Texts kinds_;
};

double changed(double value, Random& random) {
  switch (below(6, random)) {
    case 0:
      return -value;
    case 1:
      return 0;
    case 2:
      return value * 1e6 + 1;
    default: {
      // Relative, from 1e-6 to about 1; of 0, absolute.
      const double size = std::pow(10, -6.0 * static_cast<double>(below(1001, random)) / 1000);
      const double by = (random() % 2 ? size : -size) * (value == 0 ? 1 : value);
      return value + by;
    }
  }
}

// `known`: the values of this key in other records.
void change(Json& value, const std::vector<Json>& known, Random& random) {
  if (value.is_boolean()) {
    value = !value.get<bool>();
  } else if (value.is_number_integer()) {
    value = value.get<std::int64_t>() + (random() % 2 ? 1 : -1);
  } else if (value.is_number()) {
    value = changed(value.get<double>(), random);
  } else if (value.is_array() && !value.empty()) {
    const std::size_t i = below(value.size(), random), k = below(value.size(), random);
    if (const std::size_t how = below(8, random); how == 0)
      value.erase(i);
    else if (how < 3)
      std::swap(value[i], value[k]);
    else
      change(value[i], {}, random);
  } else if (value.is_string()) {
    std::string text = value.get<std::string>();
    if (!text.empty() && text.find_first_not_of("-0+") == text.npos) {  // indicators
      const std::size_t at = below(text.size(), random);
      if (const std::size_t how = below(8, random); how == 0)
        text.erase(at, 1);
      else if (how == 1)
        text.insert(at, 1, '+');
      else
        text[at] = "-0+"[below(3, random)];
      value = text;
      return;
    }
    static const Texts words{"inside",       "outside", "lowest",   "shortest", "none",      "solid-angle",
                             "aspect-ratio", "auto",    "0",        "1",        "2a",        "2b",
                             "3a",           "3b",      "4a",       "4c",       "10a",       "12a",
                             "2-3",          "3-2",     "no-gain",  "points",   "not-asked", "80",
                             "81",           "14",      "dilution", "x",        "",          "e-avg"};
    value = known.empty() || random() % 2 ? Json(one_of(words, random)) : one_of(known, random);
  }
}

std::string shortened(const Json& value) {
  const std::string text = value.dump();
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

Texts keys_of(const Json& record) {
  Texts keys;
  for (const auto& [key, value] : record.items())
    if (key != "record") keys.push_back(key);
  return keys;
}

std::int64_t line(std::size_t position) {
  return static_cast<std::int64_t>(position) + 1;
}

// Whether the order of a record and the next one counts.
bool order_counts(const Trace& trace, std::size_t i) {
  const std::string &a = trace.kind(i), &b = trace.kind(i + 1);
  if (step_of(a) != step_of(b) || step_of(a) == 3) return true;
  return (a == "lattice" || b == "lattice") && a != "settings" && b != "settings";
}

void change_key(Trace& trace, Mutant& made, Random& random) {
  made.kind = one_of(trace.kinds(), random);
  const std::vector<std::size_t> all = trace.of_kind(made.kind);
  const std::size_t i = one_of(all, random);
  const std::string key = one_of(keys_of(trace[i]), random);
  const Json before = trace[i][key];
  std::vector<Json> known;
  for (const std::size_t k : all)
    if (trace[k].contains(key) && trace[k][key].is_string()) known.push_back(trace[k][key]);
  if (made.operation == Operation::key_dropped)
    trace[i].erase(key);
  else
    change(trace[i][key], known, random);
  made.what = fmt::format("line {}, {}: {} {} -> {}", line(i), made.kind, key, shortened(before),
                          trace[i].contains(key) ? shortened(trace[i][key]) : "nothing");
  trace.add_lines(i, made.lines);
}

void exchange_key(Trace& trace, Mutant& made, Random& random) {
  Texts kinds = trace.kinds();
  std::erase_if(kinds, [&](const std::string& kind) { return trace.of_kind(kind).size() < 2; });
  made.kind = one_of(kinds, random);
  const std::vector<std::size_t> all = trace.of_kind(made.kind);
  const std::size_t i = one_of(all, random);
  std::size_t k = i;
  while (k == i) k = one_of(all, random);
  const std::string key = one_of(keys_of(trace[i]), random);
  if (trace[k].contains(key)) std::swap(trace[i][key], trace[k][key]);
  made.what = fmt::format("lines {} and {}, {}: {} exchanged", line(i), line(k), made.kind, key);
  trace.add_lines(i, made.lines);
  trace.add_lines(k, made.lines);
}

// Where a record is missed that stood at position `at`, and of which the trace has nothing now.
void add_missed(const Trace& trace, const std::string& kind, std::size_t at, std::set<std::int64_t>& lines) {
  const std::vector<std::size_t> first_grid = trace.of_kind("first_grid");
  const std::size_t last = trace.size() - 1;
  if (kind == "lattice") {
    lines.insert(line(std::min(at, last)));
  } else if (step_of(kind) == 1) {
    lines.insert(line(trace.after(1)));
  } else if (kind == "first_grid") {
    lines.insert(line(trace.after(2)));
  } else if (kind == "weight") {
    lines.insert(line(first_grid.empty() ? trace.after(2) : first_grid[0]));
    if (trace.of_kind("weight").empty()) lines.insert(line(trace.after(2)));
  } else {
    std::size_t i = std::min(at, last);
    for (; i < last && trace.kind(i) == "flip"; ++i) lines.insert(line(i));
    lines.insert(line(i));
  }
}

void change_record(Trace& trace, Mutant& made, Random& random) {
  std::size_t i = one_of(trace.of_kind(one_of(trace.kinds(), random)), random);
  if (made.operation == Operation::record_exchanged)
    while (i + 1 >= trace.size() || !order_counts(trace, i)) i = below(trace.size(), random);
  made.kind = trace.kind(i);
  made.what = fmt::format("line {}, {}", line(i), made.kind);
  if (made.operation == Operation::record_dropped) {
    const Texts may_be_left_out{"settings", "indicators", "cut", "rows"};
    made.left_out =
        trace.of_kind(made.kind).size() == 1 &&
        std::find(may_be_left_out.begin(), may_be_left_out.end(), made.kind) != may_be_left_out.end();
    trace.drop(i);
    add_missed(trace, made.kind, i, made.lines);
  } else if (made.operation == Operation::record_doubled) {
    trace.add(i, trace[i]);
    made.lines = {line(i), line(i + 1)};
  } else {
    trace.exchange_with_next(i);
    made.lines = {line(i), line(i + 1)};
    for (const std::size_t late : {i, i + 1})
      if (step_of(trace.kind(late)) == 2) add_missed(trace, trace.kind(late), late, made.lines);
  }
}

}  // namespace

const char* name_of(Operation operation) {
  switch (operation) {
    case Operation::key_changed:
      return "key changed";
    case Operation::key_dropped:
      return "key dropped";
    case Operation::key_exchanged:
      return "key exchanged";
    case Operation::record_dropped:
      return "record dropped";
    case Operation::record_doubled:
      return "record doubled";
    case Operation::record_exchanged:
      return "record exchanged";
    case Operation::cut_at_byte:
      return "cut at a byte";
    case Operation::cut_at_line:
      return "cut at a line";
  }
  throw std::logic_error("an operation without a name");
}

Mutant mutate(const Texts& lines, Random& random) {
  // Of twenty mutants, ten change a key.
  constexpr std::array<Operation, 20> often{
      Operation::key_changed,      Operation::key_changed,    Operation::key_changed,
      Operation::key_changed,      Operation::key_changed,    Operation::key_changed,
      Operation::key_changed,      Operation::key_changed,    Operation::key_changed,
      Operation::key_changed,      Operation::key_dropped,    Operation::key_dropped,
      Operation::key_exchanged,    Operation::key_exchanged,  Operation::record_dropped,
      Operation::record_dropped,   Operation::record_doubled, Operation::cut_at_byte,
      Operation::record_exchanged, Operation::cut_at_line};
  Mutant made{.operation = one_of(often, random), .kind = {}, .what = {}, .text = {}, .lines = {}};
  Trace trace(lines);
  switch (made.operation) {
    case Operation::key_changed:
    case Operation::key_dropped:
      change_key(trace, made, random);
      break;
    case Operation::key_exchanged:
      exchange_key(trace, made, random);
      break;
    case Operation::record_dropped:
    case Operation::record_doubled:
    case Operation::record_exchanged:
      change_record(trace, made, random);
      break;
    case Operation::cut_at_byte:
    case Operation::cut_at_line: {
      made.text = trace.text();
      std::size_t length = below(made.text.size(), random);
      if (made.operation == Operation::cut_at_line)
        length = made.text.rfind('\n', length) + 1;  // npos + 1 is 0
      made.text.resize(length);
      const auto whole = std::count(made.text.begin(), made.text.end(), '\n');
      made.lines = {whole + (length && made.text.back() != '\n' ? 1 : 0)};
      made.kind = "file";
      made.what = fmt::format("{} bytes of the file", length);
      return made;
    }
  }
  made.text = trace.text();
  return made;
}

}  // namespace tetproof::mutation
