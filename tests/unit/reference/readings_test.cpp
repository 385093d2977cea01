// SPDX-License-Identifier: GPL-3.0-or-later
// The tests and functions that the register of readings names exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;
const fs::path root = TETPROOF_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string sources_below(const fs::path& folder) {
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
      all += text_of(entry.path());
  return all;
}

TEST(Readings, NameTestsAndFunctionsThatExist) {
  const std::string readings = text_of(root / "reference/readings.md");
  const std::string tests = sources_below(root / "tests"), reference = sources_below(root / "reference");
  int named_tests = 0, named_functions = 0;
  const std::regex row(R"(^\|[^|]*\|[^|]*\|([^|]*)\|([^|]*)\|$)", std::regex::multiline), quoted("`([^`]+)`");
  for (std::sregex_iterator line(readings.begin(), readings.end(), row), end; line != end; ++line) {
    const std::string functions = (*line)[1], checks = (*line)[2];
    for (std::sregex_iterator name(functions.begin(), functions.end(), quoted); name != end; ++name) {
      std::string function = (*name)[1];
      function = function.substr(function.rfind(':') + 1);
      EXPECT_TRUE(std::regex_search(reference, std::regex("\\b" + function + "\\b"))) << function;
      ++named_functions;
    }
    for (std::sregex_iterator name(checks.begin(), checks.end(), quoted); name != end; ++name) {
      const std::string test = (*name)[1], suite = test.substr(0, test.find('.')),
                        each = test.substr(test.find('.') + 1);
      EXPECT_TRUE(std::regex_search(
          tests, std::regex("(TEST|TEST_P|TEST_F|RC_GTEST_PROP)\\(" + suite + ",\\s*" + each + "\\b")))
          << test;
      ++named_tests;
    }
  }
  EXPECT_GT(named_tests, 30);
  EXPECT_GT(named_functions, 20);
}

}  // namespace
