// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/junit_suite.hpp"

#include <fmt/format.h>

#include "io/bytes/xml_text.hpp"

namespace tetproof::corpus {

using io::xml_escaped;

void JunitSuite::add(const std::string& test, const std::string& inside) {
  ++tests_;
  cases_ += fmt::format("    <testcase classname=\"{}\" name=\"{}\"{}\n", xml_escaped(name_),
                        xml_escaped(test), inside.empty() ? "/>" : ">");
  if (!inside.empty()) cases_ += inside + "    </testcase>\n";
}

void JunitSuite::pass(const std::string& test) {
  add(test, "");
}

void JunitSuite::skip(const std::string& test, const std::string& why) {
  ++skipped_;
  add(test, fmt::format("      <skipped message=\"{}\"/>\n", xml_escaped(why)));
}

void JunitSuite::fail(const std::string& test, const std::string& type, const std::string& message,
                      const std::string& details) {
  ++failures_;
  add(test, fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n", xml_escaped(type),
                        xml_escaped(message), xml_escaped(details, io::XmlLines::keep)));
}

std::string junit_document(const std::vector<JunitSuite>& suites) {
  const auto counts = [](int tests, int failures, int skipped) {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", tests, failures, skipped);
  };
  int tests = 0, failures = 0, skipped = 0;
  std::string text;
  for (const JunitSuite& suite : suites) {
    text += fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", xml_escaped(suite.name_),
                        counts(suite.tests_, suite.failures_, suite.skipped_), suite.cases_);
    tests += suite.tests_;
    failures += suite.failures_;
    skipped += suite.skipped_;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tetproof-fuzz\" {}>\n{}"
      "</testsuites>\n",
      counts(tests, failures, skipped), text);
}

}  // namespace tetproof::corpus
