// SPDX-License-Identifier: GPL-3.0-or-later
// README.md shows what the programs print: every "$ command" in it is run, in order, in one folder.
#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

TEST(Readme, CommandsPrintWhatItShows) {
  const ScratchFolder folder;
  std::filesystem::create_directory_symlink(TETPROOF_BINARY_DIR, folder / "build");
  std::filesystem::create_directory_symlink(TETPROOF_SOURCE_DIR "/corpus", folder / "corpus");
  std::filesystem::create_directory(folder / "out");

  std::ifstream readme(TETPROOF_SOURCE_DIR "/README.md");
  std::vector<std::pair<std::string, std::string>> shown;  // command, output
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    inside = line.starts_with("    $ ") || (inside && line.starts_with("    "));
    if (!inside) continue;
    if (line.starts_with("    $ "))
      shown.emplace_back(line.substr(6), "");
    else
      shown.back().second += line.substr(4) + "\n";
  }
  ASSERT_GE(shown.size(), 5u);
  for (const auto& [command, output] : shown) {
    const Outcome outcome = run_program({"sh", "-c", command}, {.directory = folder.path()});
    EXPECT_EQ(outcome.out, output) << command;
    const bool wrong = output.find("DEFECTIVE") != std::string::npos || output.starts_with("they diverge");
    EXPECT_EQ(outcome.exit_code, wrong ? 1 : 0) << command << "\n" << outcome;
  }
}

}  // namespace
}  // namespace tetproof::test
