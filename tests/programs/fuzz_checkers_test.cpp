// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-fuzz --judge and --reader as users run them, on checkers and readers whose faults are known.
#include <gmock/gmock.h>

#include <csignal>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.hpp"

namespace tetproof::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Words = std::vector<std::string>;

class FuzzOthers : public ::testing::Test {
 protected:
  static Outcome fuzz(Words options) {
    options.insert(options.begin(), program("tetproof-fuzz"));
    return run_program(options);
  }
  static void expect_refused(const Outcome& outcome, const std::string& why) {
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines(outcome.err), 1u) << outcome;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("tetproof-fuzz: "), HasSubstr(why)));
  }
  static std::string faulty_reader(const std::string& bug) {
    return program("tetproof-faulty-reader") + " " + bug + " {file}";
  }

  ScratchFolder files;
};

TEST_F(FuzzOthers, OurVerifierMissesNothing) {
  const Outcome run = fuzz({"--judge", "tetproof-verify", "--cases", "1", "--json", files / "r.json"});
  EXPECT_EQ(run.exit_code, 0) << run;
  const json row = json::parse(files.read("r.json"))["by_checker"]["tetproof-verify"];
  EXPECT_GT(row["seen"], 80) << row;
  EXPECT_GT(row["accepted"], 5) << row;
  EXPECT_EQ(row["seen"].get<int>() + row["accepted"].get<int>() + row["debatable"].get<int>(), row["meshes"])
      << row;
}

const Words few{"--kinds", "sound,inverted-inside,missing-inside", "--cases", "2"};

TEST_F(FuzzOthers, ACheckerThatCallsAllSound) {
  Words words{"--judge", "true {mesh}",   "--json", files / "r.json",
              "--junit", files / "r.xml", "--out",  files / "out"};
  words.insert(words.end(), few.begin(), few.end());
  const Outcome run = fuzz(words);
  EXPECT_EQ(run.exit_code, 1) << run;
  const json report = json::parse(files.read("r.json"));
  EXPECT_EQ(report["matrix"]["inverted-inside"]["true"]["missed"], 2);
  EXPECT_EQ(report["matrix"]["sound"]["true"]["accepted"], 2);
  EXPECT_EQ(report["matrix"]["missing-inside"]["true"]["debatable"], 2);
  ASSERT_EQ(report["findings"].size(), 1u);
  EXPECT_EQ(report["findings"][0]["cases"].size(), 2u);
  EXPECT_THAT(run.out, HasSubstr("true:missed:inverted-inside"));
  EXPECT_THAT(files.read("r.xml"), AllOf(HasSubstr("tests=\"3\" failures=\"1\""), HasSubstr("2 missed")));
  EXPECT_EQ(files.read("out/report.txt"), run.out);
  // The mesh that is kept is defective.
  const std::string mesh = report["findings"][0]["file"];
  EXPECT_EQ(run_program({program("tetproof-verify"), "--quiet", files / ("out/" + mesh)}).exit_code, 1)
      << mesh;
}

TEST_F(FuzzOthers, ACheckerThatCallsAllDefective) {
  Words words{"--judge", "false {mesh}", "--json", files / "r.json"};
  words.insert(words.end(), few.begin(), few.end());
  EXPECT_EQ(fuzz(words).exit_code, 1);
  const json report = json::parse(files.read("r.json"));
  EXPECT_EQ(report["by_checker"]["false"]["false-alarm"], 2);
  EXPECT_EQ(report["by_checker"]["false"]["seen"], 2);
  EXPECT_EQ(report["by_checker"]["false"]["missed"], 0);
}

TEST_F(FuzzOthers, ACheckerThatCrashesOrIsSlow) {
  Words words{"--judge", "sh -c 'kill -SEGV $$' {mesh}", "--name", "crasher", "--json", files / "r.json"};
  words.insert(words.end(), few.begin(), few.end());
  EXPECT_EQ(fuzz(words).exit_code, 1);
  EXPECT_EQ(json::parse(files.read("r.json"))["by_checker"]["crasher"]["crashed"], 6);
  const Outcome slow = fuzz({"--judge", "sh -c 'while :; do :; done' {mesh}", "--cpu", "0.1", "--cases", "1",
                             "--kinds", "inverted-inside"});
  EXPECT_EQ(slow.exit_code, 4) << slow;
  EXPECT_THAT(slow.out, HasSubstr("1 slow"));
}

TEST_F(FuzzOthers, WordsInPlaceOfTheExitCode) {
  const Words base{"--kinds", "inverted-inside", "--cases", "1", "--judge"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), base.begin(), base.end());
    return fuzz(more);
  };
  EXPECT_EQ(with({"echo inverted {mesh}", "--says", "inverted"}).exit_code, 0);
  EXPECT_EQ(with({"echo fine {mesh}", "--says", "inverted"}).exit_code, 1);
  EXPECT_EQ(with({"echo fine {mesh}", "--says-sound", "fine"}).exit_code, 1);
  EXPECT_EQ(with({"echo hm {mesh}", "--says-sound", "fine"}).exit_code, 0);
  EXPECT_EQ(with({"echo hm {mesh}", "--says", "bad", "--says-sound", "fine"}).exit_code, 4);
}

// Of a .vtu with an index that no point has nothing can be asked.
TEST_F(FuzzOthers, AFormatThatCannotHoldADefectIsNamed) {
  const Outcome run =
      fuzz({"--judge", "true {mesh}", "--kinds", "index-too-high", "--cases", "1", "--formats", "vtu"});
  EXPECT_EQ(run.exit_code, 4) << run;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("1 not-held"), HasSubstr("index-too-high: vtu"), Not(HasSubstr("1 missed"))));
}

TEST_F(FuzzOthers, SurfaceIsThatOfTheSoundMesh) {
  const Outcome run = fuzz({"--judge", program("tetproof-verify") + " --quiet {mesh} {surface}", "--kinds",
                            "sound,missing-at-boundary", "--cases", "2", "--json", files / "r.json"});
  EXPECT_EQ(run.exit_code, 0) << run;
  const json matrix = json::parse(files.read("r.json"))["matrix"];
  EXPECT_EQ(matrix["sound"]["tetproof-verify"]["accepted"], 2) << matrix;
  EXPECT_EQ(matrix["missing-at-boundary"]["tetproof-verify"]["debatable"], 2) << matrix;
}

TEST_F(FuzzOthers, TheSameBytesForAnyNumberOfThreads) {
  Words words{"--judge", "false {mesh}", "--json", "-", "--cases", "1", "--threads", "1"};
  const std::string one = fuzz(words).out;
  words.back() = "3";
  EXPECT_EQ(fuzz(words).out, one);
  Words reader{"--reader", faulty_reader("none"), "--cases", "60", "--formats", "msh22", "--json",
               "-",        "--threads",           "1"};
  const std::string read = fuzz(reader).out;
  reader.back() = "3";
  EXPECT_EQ(fuzz(reader).out, read);
}

struct Bug {
  const char* name;
  const char* outcome;
  const char* damage;
  int signal;  ///< that ends it: its own, or the one of the time that the test gives it
};

class FaultyReader : public FuzzOthers, public ::testing::WithParamInterface<Bug> {};

TEST_P(FaultyReader, IsFoundAndItsFileIsShrunk) {
  const Bug& bug = GetParam();
  const Outcome run = fuzz({"--reader", faulty_reader(bug.name), "--formats", "msh22", "--kinds", bug.damage,
                            "--cases", "60", "--cpu", "0.3", "--memory", "300", "--shrink", "1", "--out",
                            files / "out", "--json", files / "r.json"});
  EXPECT_EQ(run.exit_code, 1) << run;
  const json report = json::parse(files.read("r.json"));
  ASSERT_FALSE(report["groups"].empty()) << run;
  std::string ids;
  for (const json& one : report["groups"]) {  // a limit of time or memory has a group for each form
    EXPECT_EQ(one["outcome"], bug.outcome);
    ids += one["id"].get<std::string>() + "\n";
  }
  const json group = report["groups"][0];
  EXPECT_THAT(run.out, HasSubstr(group["id"].get<std::string>()));
  EXPECT_EQ(group["cases"][0]["damage"], bug.damage);
  ASSERT_TRUE(group["shrunk"].is_number()) << group;
  EXPECT_LE(group["shrunk"], group["cases"][0]["bytes"]);
  // The file that is kept still does it.
  const std::string file = group["file"];
  const std::size_t memory = bug.name == std::string("greedy") ? 300'000'000 : 0;  // as above
  const Outcome again = run_program({program("tetproof-faulty-reader"), bug.name, files / ("out/" + file)},
                                    {.timeout_s = 2, .memory_limit = memory});
#if !defined(__SANITIZE_ADDRESS__)  // under which no limit of memory is set
  EXPECT_EQ(again.signal, bug.signal) << again;
#endif
  // Known, it is no failure.
  const std::string known = files.write("known", ids);
  const Outcome quiet =
      fuzz({"--reader", faulty_reader(bug.name), "--formats", "msh22", "--kinds", bug.damage, "--cases", "60",
            "--cpu", "0.3", "--memory", "300", "--known", known});
  EXPECT_EQ(quiet.exit_code, 0) << quiet;
}

INSTANTIATE_TEST_SUITE_P(All, FaultyReader,
                         ::testing::Values(Bug{"negative", "crashed", "negative-count", SIGABRT},
                                           Bug{"endless", "slow", "missing-end", SIGALRM},
                                           Bug{"greedy", "out-of-memory", "huge-count", SIGABRT}),
                         [](const auto& bug) { return std::string(bug.param.name); });

TEST_F(FuzzOthers, AReaderWithoutBugsHasNoFindings) {
  const Outcome run = fuzz({"--reader", program("tetproof-convert") + " {file} --info", "--cases", "150"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_THAT(run.out, HasSubstr("0 findings in 0 new groups"));
}

TEST_F(FuzzOthers, WrongUsageIsOneLine) {
  expect_refused(fuzz({"--judge", "no-such-checker"}), "tetproof-verify");
  expect_refused(fuzz({"--judge", "no-such-program {mesh}"}), "no such program");
  expect_refused(fuzz({"--judge", "true 'x {mesh}"}), "no end");
  expect_refused(fuzz({"--judge", "true {mesh}", "--says", "("}), "regular expression");
  expect_refused(fuzz({"--judge", "true {mesh}", "--kinds", "no-such-kind"}), "no-such-kind");
  expect_refused(fuzz({"--judge", "true {mesh}", "--reader", "true {file}"}), "found both");
  expect_refused(fuzz({"--judge", "true {mesh}", "--mesher", "tetgen"}), "--mesher");
  expect_refused(fuzz({"--judge", "true {mesh}", "--shrink", "3"}), "--shrink");
  expect_refused(fuzz({"--judge", "true {mesh}", "--formats", "x"}), "x");
  expect_refused(fuzz({"--reader", "true"}), "{file}");
  expect_refused(fuzz({"--reader", "true {file}", "--formats", "no-such-format"}), "no-such-format");
  expect_refused(fuzz({"--reader", "true {file}", "--kinds", "no-such-damage"}), "no-such-damage");
  expect_refused(fuzz({"--reader", "true {file}", "--says", "x"}), "--says");
  expect_refused(fuzz({"--formats", "msh22", "--mesher", "tetgen"}), "--formats");
}

}  // namespace
}  // namespace tetproof::test
