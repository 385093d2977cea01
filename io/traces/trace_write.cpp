// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the records of a trace.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/bytes/text_output.hpp"
#include "io/traces/trace_keys.hpp"

namespace tetproof::trace {
namespace {

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
      line_ += "-0.0";  // a JSON reader may read -0 as an integer
    else
      line_.append(text, io::put(text, value));
  }
  void put(const std::string& value) {
    line_ += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
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

}  // namespace

std::string to_line(const Record& record) {
  Writer writer(name_of(record));
  std::visit([&](const auto& r) { describe(r, writer); }, record);
  return std::move(writer).line();
}

const char* name_of(const Record& record) {
  return names[record.index()];
}

}  // namespace tetproof::trace
