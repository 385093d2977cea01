// SPDX-License-Identifier: GPL-3.0-or-later
// What all programs do in the same way: help, versions, one-line errors, exit codes, JSON, threads, whole
// files. For inputs and outputs see common_files_test.cpp.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/programs/common_jobs.hpp"

namespace tetproof::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

INSTANTIATE_TEST_SUITE_P(Programs, CommonBehaviour, ::testing::ValuesIn(jobs), numbered_name);

TEST_P(CommonBehaviour, HelpShowsExamplesFirst) {
  const Outcome help = run_program({program(GetParam().name), "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_THAT(help.out, StartsWith("Examples:\n"));
  const std::string example = help.out.substr(10, help.out.find('\n', 10) - 10);
  EXPECT_THAT(example, HasSubstr(GetParam().name + " "));
  for (const char* option : {"--json", "--threads", "--quiet", "--version", "--help"})
    EXPECT_THAT(help.out, HasSubstr(option));
  EXPECT_THAT(help.out, HasSubstr("the same file as an input"));
}

TEST_P(CommonBehaviour, VersionNamesTheLibraries) {
  const Outcome version = run_program({program(GetParam().name), "--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.err, "");
  EXPECT_TRUE(std::regex_search(version.out, std::regex("^" + GetParam().name + " \\d+\\.\\d+\\.\\d+\n")))
      << version;
  std::vector<std::string> libraries{"fmt", "Eigen", "oneTBB", "CLI11"};
  if (GetParam().name == "tetproof-mesh" || GetParam().name == "tetproof-verify")
    libraries.insert(libraries.end(), {"CGAL", "OpenVDB"});
  for (const std::string& library : libraries)
    EXPECT_TRUE(std::regex_search(version.out, std::regex("\n" + library + " \\d+\\.\\d+"))) << version;
}

TEST_P(CommonBehaviour, SucceedsQuietly) {
  const Outcome outcome = run({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outputs.names(),
            GetParam().writes ? std::vector<std::string>{"out.msh"} : std::vector<std::string>{});
}

TEST_P(CommonBehaviour, WrongUsageIsOneLine) {
  expect_refused(run_program({program(GetParam().name)}));
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--no-such-option"},
                                                                                    {"--threads", "many"},
                                                                                    {"--threads", "-1"},
                                                                                    {"--json"},
                                                                                    {"a", "b", "c", "d"}}) {
    SCOPED_TRACE(more[0]);
    expect_refused(run(more));
    EXPECT_TRUE(outputs.names().empty());
  }
  EXPECT_THAT(run({"--no-such-option"}).err, HasSubstr("--no-such-option"));
}

// An unset variable of a script.
TEST_P(CommonBehaviour, AnEmptyNameOfAnOutputIsRefused) {
  for (const std::string& option : GetParam().outputs) {
    const Outcome outcome = run({option, ""});
    expect_refused(outcome);
    EXPECT_THAT(outcome.err, HasSubstr(option + ": expected a value, found '' (see "));
  }
}

TEST_P(CommonBehaviour, MissingInputIsNamed) {
  for (std::size_t i = 0; i < GetParam().arguments.size(); ++i) {
    std::vector<std::string> words = command(outputs / "out.msh");
    if (GetParam().arguments[i] != "SURFACE" && GetParam().arguments[i] != "MESH") continue;
    const std::string ending = words[i + 1].substr(words[i + 1].rfind('.'));
    for (const std::string& input : {inputs / ("missing" + ending), inputs / ("line\nbreak" + ending)}) {
      words[i + 1] = input;
      const Outcome outcome = run_program(words);
      expect_refused(outcome);
      EXPECT_THAT(outcome.err, HasSubstr(ending));
      EXPECT_TRUE(outputs.names().empty());
    }
  }
}

TEST_P(CommonBehaviour, JsonOnStandardOutputIsAllThatIsThere) {
  const Outcome outcome = run({"--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.is_object());
  EXPECT_FALSE(json.empty());
}

TEST_P(CommonBehaviour, JsonInAFileIsTheSame) {
  const std::string printed = run({"--json", "-"}).out;
  const Outcome outcome = run({"--json", outputs / "out.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outputs.read("out.json"), printed);
}

TEST_P(CommonBehaviour, SameBytesOnAnyNumberOfThreads) {
  const Outcome one = run({"--threads", "1", "--json", "-"});
  ASSERT_EQ(one.exit_code, 0) << one;
  const std::string written = GetParam().writes ? outputs.read("out.msh") : "";
  for (const char* threads : {"2", "3", "0"}) {
    const Outcome more = run({"--threads", threads, "--json", "-"});
    EXPECT_EQ(more.out, one.out) << threads << " threads";
    EXPECT_TRUE(!GetParam().writes || outputs.read("out.msh") == written) << threads << " threads";
  }
}

TEST_P(CommonBehaviour, UnwritableOutputLeavesNothing) {
  outputs.write("file", "");
  std::filesystem::create_directory(outputs / "folder.msh");
  const std::vector<std::string> before = outputs.names();
  for (const std::string& place :
       {outputs / "missing/out.msh", outputs / "file/out.msh", outputs / "folder.msh"}) {
    SCOPED_TRACE(place);
    const Outcome no_json = run({"--json", place});
    expect_refused(no_json);
    EXPECT_THAT(no_json.err, HasSubstr(place));
    EXPECT_EQ(outputs.names(), before);
    if (GetParam().writes) {
      const Outcome no_mesh = run_program(command(place));
      expect_refused(no_mesh);
      EXPECT_THAT(no_mesh.err, HasSubstr(place));
      EXPECT_EQ(outputs.names(), before);
    }
    EXPECT_TRUE(std::filesystem::is_empty(outputs / "folder.msh"));
  }
}

TEST_P(CommonBehaviour, FullDeviceIsAnError) {
  const Outcome outcome = run({"--json", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome;
  EXPECT_EQ(lines(outcome.err), 1u) << outcome;
}

TEST_P(CommonBehaviour, FullStandardOutputIsAnError) {
  std::string line = "exec \"$0\" \"$@\" > /dev/full";
  std::vector<std::string> words = command(outputs / "out.msh", {"--json", "-"});
  words.insert(words.begin(), {"sh", "-c", line});
  expect_refused(run_program(words));
}

class WritingPrograms : public CommonBehaviour {};

INSTANTIATE_TEST_SUITE_P(Programs, WritingPrograms, ::testing::Values(jobs.front(), jobs.back()),
                         [](const auto& job) { return job.param.test_name(); });

TEST_P(WritingPrograms, AnOlderOutputSurvivesAFailure) {
  outputs.write("out.msh", "older");
  expect_refused(run({"--no-such-option"}));
  std::vector<std::string> words = command(outputs / "out.msh");
  std::filesystem::resize_file(inputs / "octahedron.off", 60);
  std::filesystem::resize_file(inputs / "octahedron.ele", 12);
  expect_refused(run_program(words));
  EXPECT_EQ(outputs.read("out.msh"), "older");
  EXPECT_EQ(outputs.names(), std::vector<std::string>{"out.msh"});
}

// A program loads only the libraries that its job needs: never libgmsh, which brings a hundred others, nor
// libopenvdb, which alone takes 30 ms to load.
TEST(LinkedLibraries, OnlyWhatTheJobNeeds) {
  for (const char* name :
       {"tetproof-mesh", "tetproof-verify", "tetproof-compare", "tetproof-fuzz", "tetproof-convert"}) {
    SCOPED_TRACE(name);
    const Outcome ldd = run_program({"ldd", program(name)});
    ASSERT_EQ(ldd.exit_code, 0) << ldd;
    EXPECT_THAT(ldd.out, HasSubstr("libstdc++"));
    for (const char* library : {"libgmsh", "libvtk", "libtet.", "libgtest", "libopenvdb"})
      EXPECT_THAT(ldd.out, ::testing::Not(HasSubstr(library)));
  }
}

}  // namespace
}  // namespace tetproof::test
