// SPDX-License-Identifier: GPL-3.0-or-later
// One line of a trace as a JSON object, and its values with their types. Not installed.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/trace.hpp"

namespace tetproof::trace {

/// Parses one line.
class JsonLine {
 public:
  /// `place`: "FILE:LINE". Throws InputError for a line that is not a JSON object with a string "record".
  JsonLine(const std::string& text, std::string place);
  ~JsonLine();

  const std::string& kind() const;  ///< the value of "record"
  const std::string& place() const { return place_; }
  const nlohmann::json& object() const { return *object_; }

 private:
  std::string place_;
  std::unique_ptr<const nlohmann::json> object_;
};

/// Reads the values of a record's keys, each with the type that it must have. Every failure is an InputError
/// that names the key.
class Fields {
 public:
  Fields(const JsonLine& line, const char* name) : line_(line), name_(name) {}

  void with_defaults() { defaults_ = true; }  ///< keys that are read after this may be absent

  /// Any type that a field of a record has.
  template <class T>
  void operator()(const char* key, T& value);
  void operator()(const char* key, std::optional<double>& value);  ///< may be absent or null
  /// One of two words: true for `yes`, false for `no`.
  void choice(const char* key, bool& value, const char* yes, const char* no);
  /// An array of two numbers.
  void pair(const char* key, double& first, double& second);

  /// "FILE:LINE: expected EXPECTED as "KEY" of the NAME record, found ..."; shows the key's value unless
  /// `found` is given.
  [[noreturn]] void fail(const char* key, const std::string& expected) const;
  [[noreturn]] void fail(const char* key, const std::string& expected, const std::string& found) const;

 private:
  const nlohmann::json* find(const char* key, bool optional) const;

  const JsonLine& line_;
  const char* name_;
  bool defaults_ = false;
};

}  // namespace tetproof::trace
