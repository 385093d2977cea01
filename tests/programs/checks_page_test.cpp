// SPDX-License-Identifier: GPL-3.0-or-later
// verify/checks/checks.md has a section for each check, in the order of the checks, and its examples are what
// tetproof-verify prints.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

std::vector<std::string> page() {
  std::ifstream file(TETPROOF_SOURCE_DIR "/verify/checks/checks.md");
  return lines_of({std::istreambuf_iterator<char>(file), {}});
}

TEST(ChecksPage, HasASectionForEachCheck) {
  std::vector<std::string> sections, ids;
  for (const std::string& line : page())
    if (line.starts_with("## ")) sections.push_back(line.substr(3));
  const Outcome list = run_program({program("tetproof-verify"), "--list-checks"});
  ASSERT_EQ(list.exit_code, 0) << list;
  for (const std::string& line : lines_of(list.out))
    if (!line.empty() && line[0] != ' ') ids.push_back(line);
  EXPECT_EQ(sections, ids);
}

TEST(ChecksPage, ItsSectionsSayHowSevereAndHowExact) {
  std::string section;
  std::size_t said = 0, examples = 0, all_examples = 0;  // how severe and what it cannot see; of the section
  const auto complete = [&] { return section.empty() || (said == 2 && examples > 0); };
  for (const std::string& line : page()) {
    if (line.starts_with("## ")) {
      EXPECT_TRUE(complete()) << section;
      section = line.substr(3), said = examples = 0;
    }
    said += line.starts_with("Fails.") || line.starts_with("Warns");
    said += line.starts_with("It cannot see: ");
    examples += line.starts_with("    $ tetproof-verify ");
    all_examples += line.starts_with("    $ tetproof-verify ");
  }
  EXPECT_TRUE(complete()) << section;
  EXPECT_GT(all_examples, 20u);
}

TEST(ChecksPage, ItsExamplesAreWhatIsPrinted) {
  const std::vector<std::string> all = page();
  std::string section;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].starts_with("## ")) section = all[i].substr(3);
    if (!all[i].starts_with("    $ ")) continue;
    std::istringstream words(all[i].substr(6));
    std::vector<std::string> command;
    for (std::string word; words >> word;) command.push_back(word);
    ASSERT_EQ(command[0], "tetproof-verify");
    command[0] = program(command[0]);
    const Outcome run = run_program(command, {.directory = TETPROOF_SOURCE_DIR});
    std::string expected;
    for (++i; i < all.size() && !all[i].empty(); ++i) expected += all[i].substr(4) + "\n";
    EXPECT_THAT(expected, testing::AnyOf(testing::StartsWith("FAIL " + section + ": "),
                                         testing::StartsWith("warning " + section + ": ")));
    EXPECT_THAT(run.out, testing::HasSubstr(expected));
  }
}

}  // namespace
}  // namespace tetproof::test
