// SPDX-License-Identifier: GPL-3.0-or-later
// JUnit XML: suites of test cases that pass, fail or are skipped. Not installed.
#pragma once

#include <string>
#include <vector>

namespace tetproof::corpus {

/// A test suite. Names and texts may be any bytes.
class JunitSuite {
 public:
  explicit JunitSuite(std::string name) : name_(std::move(name)) {}
  void pass(const std::string& test);
  void skip(const std::string& test, const std::string& why);
  void fail(const std::string& test, const std::string& type, const std::string& message,
            const std::string& details);

 private:
  friend std::string junit_document(const std::vector<JunitSuite>& suites);
  void add(const std::string& test, const std::string& inside);

  std::string name_, cases_;
  int tests_ = 0, failures_ = 0, skipped_ = 0;
};

/// The document of all suites, which counts their tests.
std::string junit_document(const std::vector<JunitSuite>& suites);

}  // namespace tetproof::corpus
